// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Casters that are drawn into no map.
#include "vtkRelievoCasterFollow.h"
#include "vtkRelievoShadowProps.h"

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
