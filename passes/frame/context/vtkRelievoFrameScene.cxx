// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameScene.h"

#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <map>
#include <utility>

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

//------------------------------------------------------------------------------
void vtkRelievoFrameScene::Cull(vtkRenderer* renderer)
{
  std::vector<vtkProp*> props;
  std::map<vtkProp*, vtkRelievoFrameProp*> found;
  for (vtkRelievoFrameProp& each : this->Props)
  {
    props.push_back(each.Prop);
    found[each.Prop] = &each;
  }
  int count = static_cast<int>(props.size());
  int isTimed = 0;
  double time = count;
  vtkCollectionSimpleIterator it;
  renderer->GetCullers()->InitTraversal(it);
  while (vtkCuller* culler = renderer->GetCullers()->GetNextCuller(it))
  {
    time = culler->Cull(renderer, props.data(), count, isTimed);
  }
  std::vector<vtkRelievoFrameProp> drawn;
  for (int i = 0; i < count; ++i)
  {
    vtkProp* prop = props[static_cast<std::size_t>(i)];
    const double share = isTimed ? prop->GetRenderTimeMultiplier() : 1.0;
    prop->SetAllocatedRenderTime(share / time * renderer->GetAllocatedRenderTime(), renderer);
    drawn.push_back(std::move(*found[prop]));
  }
  this->Props = std::move(drawn);
}
