// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Casters that are drawn into no map.
#include "vtkRelievoCasterFollow.h"
#include "vtkRelievoCasterRays.h"
#include "vtkRelievoShadowProps.h"

#include "vtkProp.h"

//------------------------------------------------------------------------------
vtkRelievoShadowProps::Caster vtkRelievoShadowProps::GetCaster(
  vtkProp* prop, const Choice& choice) const
{
  const bool always = choice.Casts == 1;
  const bool bySight = choice.Casts == -1;
  return { prop, always, always || (bySight && this->Attenuates),
    always || (bySight && prop->HasOpaqueGeometry() != 0) };
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowProps::IsInMaps(const Caster& caster, bool withoutFollowed) const
{
  return caster.InMaps && !(withoutFollowed && this->Followed.count(caster.Prop) > 0);
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoCaster> vtkRelievoShadowProps::Follow()
{
  std::vector<vtkRelievoCaster> followed;
  this->Followed.clear();
  for (const Caster& caster : this->Casters)
  {
    if (vtkRelievoCasterFollow::Collect(caster.Prop, caster.Attenuates, this->Glyphs, followed))
    {
      this->Followed.insert(caster.Prop);
    }
  }
  return followed;
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> vtkRelievoShadowProps::GetState(bool withoutFollowed) const
{
  std::vector<std::uint64_t> state = this->State;
  for (const Caster& caster : this->Casters)
  {
    if (caster.InMaps)
    {
      state.push_back(this->IsInMaps(caster, withoutFollowed) ? 1 : 0);
    }
  }
  return state;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoBox> vtkRelievoShadowProps::GetCasterBoxes(bool withoutFollowed) const
{
  std::vector<vtkRelievoBox> boxes;
  for (std::size_t i = 0; i < this->Casters.size(); ++i)
  {
    if (this->IsInMaps(this->Casters[i], withoutFollowed))
    {
      boxes.push_back(this->CasterBoxes[i]);
    }
  }
  return boxes;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoSurface> vtkRelievoShadowProps::CollectSurfaces(
  bool attenuates, std::vector<vtkRelievoBox>& others) const
{
  std::vector<vtkRelievoSurface> surfaces;
  for (std::size_t i = 0; i < this->Spliced.size(); ++i)
  {
    vtkProp* const prop = this->Spliced[i];
    Choice choice;
    for (const Choice& made : this->Choices)
    {
      choice = made.Prop == prop ? made : choice;
    }
    vtkRelievoSurface surface;
    const Caster kind = this->GetCaster(prop, choice);
    const bool translucent = attenuates ? kind.Attenuates : kind.Translucent;
    surface.Casts = kind.InMaps || translucent;
    surface.Receives = choice.Receives;
    std::vector<vtkRelievoCaster> casters;
    if (!vtkRelievoCasterFollow::Collect(prop, translucent, this->Glyphs, casters))
    {
      others.push_back(this->AllBoxes[i]); // one for each of Spliced
    }
    for (const vtkRelievoCaster& caster : casters)
    {
      surface.Caster = caster;
      surface.Seen = caster.Passes <= 0.0; // also outside the view, which may be stepped
      surface.Caster.Passes = attenuates ? caster.Passes : 0.0;
      surfaces.push_back(surface);
    }
  }
  return surfaces;
}
