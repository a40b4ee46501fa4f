// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameScene.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
std::vector<vtkRelievoFrameLight> vtkRelievoFrameScene::FindLights(vtkRenderer* renderer)
{
  std::vector<vtkRelievoFrameLight> lights;
  vtkLightCollection* collection = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  collection->InitTraversal(it);
  int on = 0;
  while (vtkLight* light = collection->GetNextLight(it))
  {
    const int number = static_cast<int>(lights.size());
    lights.push_back({ light, number, light->GetSwitch() ? on++ : -1 });
  }
  return lights;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoFrameProp> vtkRelievoFrameScene::FindVisible(vtkRenderer* renderer)
{
  std::vector<vtkRelievoFrameProp> visible;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  for (int number = 0; vtkProp* prop = props->GetNextProp(it); ++number)
  {
    if (prop->GetVisibility())
    {
      visible.push_back({ prop, number, {} });
      vtkRelievoPropParts::Collect(prop, visible.back().Parts);
    }
  }
  return visible;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameScene::Take(const vtkRenderState* s)
{
  this->Props.resize(s->GetPropArrayCount());
  for (std::size_t i = 0; i < this->Props.size(); ++i)
  {
    this->Props[i].Prop = s->GetPropArray()[i];
    vtkRelievoPropParts::Collect(this->Props[i].Prop, this->Props[i].Parts);
  }
}
