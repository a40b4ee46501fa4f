// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Casters that are drawn into no map.
#include "vtkRelievoCasterFollow.h"
#include "vtkRelievoCasterRays.h"
#include "vtkRelievoShadowProps.h"

#include "vtkProp.h"

//------------------------------------------------------------------------------
std::vector<vtkRelievoCaster> vtkRelievoShadowProps::TakeFollowed()
{
  this->AllCasters.swap(this->Casters);
  this->AllCasterBoxes.swap(this->CasterBoxes);
  this->Casters.clear();
  this->CasterBoxes.clear();
  std::vector<vtkRelievoCaster> followed;
  for (std::size_t i = 0; i < this->AllCasters.size(); ++i)
  {
    const Caster& caster = this->AllCasters[i];
    if (!vtkRelievoCasterFollow::Collect(caster.Prop, caster.Translucent, followed))
    {
      this->Casters.push_back(caster);
      this->CasterBoxes.push_back(this->AllCasterBoxes[i]);
    }
  }
  return followed;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::PutBackFollowed()
{
  this->Casters = this->AllCasters;
  this->CasterBoxes = this->AllCasterBoxes;
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
    surface.Casts = choice.Casts == 1 || (choice.Casts == -1 && prop->HasOpaqueGeometry() != 0);
    surface.Receives = choice.Receives;
    std::vector<vtkRelievoCaster> casters;
    if (!vtkRelievoCasterFollow::Collect(prop, choice.Casts == 1, casters))
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
