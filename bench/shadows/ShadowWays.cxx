// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowWays.h"

#include <vtkCameraPass.h>
#include <vtkImageData.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>

#include <algorithm>
#include <cmath>

namespace relievoBench
{
namespace
{
void UseMethod(vtkRenderer* renderer, int mapSize, int method)
{
  vtkRelievoPass* pass = vtkRelievoPass::Attach(renderer);
  pass->ShadowsOn();
  pass->GetShadowStage()->SetMapSize(mapSize);
  pass->GetShadowStage()->SetMethod(method);
}
}

//------------------------------------------------------------------------------
const std::vector<ShadowWay>& ShadowWays()
{
  static const std::vector<ShadowWay> ways = {
    { "map", UseShadowMap, 4096, false },
    { "forward", UseShadowForward, 1024, true },
    { "warped", UseShadowWarped, 4096, false },
    { "exact", UseShadowExact, 4096, false },
    { "vtkShadowMapPass", UseShadowPeer, 4096, false },
  };
  return ways;
}

//------------------------------------------------------------------------------
void UseShadowPeer(vtkRenderer* renderer, int mapSize)
{
  vtkNew<vtkShadowMapBakerPass> baker;
  vtkNew<vtkShadowMapPass> shadows;
  vtkNew<vtkSequencePass> opaque;
  vtkNew<vtkRenderPassCollection> opaquePasses;
  opaquePasses->AddItem(vtkNew<vtkLightsPass>());
  opaquePasses->AddItem(vtkNew<vtkOpaquePass>());
  opaque->SetPasses(opaquePasses);
  vtkNew<vtkCameraPass> opaqueCamera;
  opaqueCamera->SetDelegatePass(opaque);
  baker->SetOpaqueSequence(opaqueCamera);
  baker->SetResolution(mapSize);
  shadows->SetShadowMapBakerPass(baker);
  shadows->SetOpaqueSequence(opaque);
  vtkNew<vtkSequencePass> sequence;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(shadows);
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  renderer->SetPass(camera);
}

//------------------------------------------------------------------------------
void UseShadowMap(vtkRenderer* renderer, int mapSize)
{
  UseMethod(renderer, mapSize, vtkRelievoShadowStage::METHOD_MAP);
}

//------------------------------------------------------------------------------
void UseShadowForward(vtkRenderer* renderer, int mapSize)
{
  UseMethod(renderer, mapSize, vtkRelievoShadowStage::METHOD_FORWARD);
}

//------------------------------------------------------------------------------
void UseShadowWarped(vtkRenderer* renderer, int mapSize)
{
  UseMethod(renderer, mapSize, vtkRelievoShadowStage::METHOD_WARPED);
}

//------------------------------------------------------------------------------
void UseShadowExact(vtkRenderer* renderer, int mapSize)
{
  UseMethod(renderer, mapSize, vtkRelievoShadowStage::METHOD_EXACT);
}

//------------------------------------------------------------------------------
void UseNoShadows(vtkRenderWindow* window, vtkRenderer* renderer)
{
  if (vtkRenderPass* pass = renderer->GetPass())
  {
    pass->ReleaseGraphicsResources(window);
  }
  renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
std::vector<float> PictureVisibility(vtkImageData* shadowed, vtkImageData* plain, double gamma)
{
  const auto* dark = static_cast<const unsigned char*>(shadowed->GetScalarPointer());
  const auto* lit = static_cast<const unsigned char*>(plain->GetScalarPointer());
  std::vector<float> visibility(static_cast<std::size_t>(plain->GetNumberOfPoints()));
  for (std::size_t i = 0; i < visibility.size(); ++i)
  {
    const double full = double(lit[3 * i]) + lit[3 * i + 1] + lit[3 * i + 2];
    const double left = double(dark[3 * i]) + dark[3 * i + 1] + dark[3 * i + 2];
    visibility[i] =
      full > 0. ? static_cast<float>(std::min(1., std::pow(left / full, gamma))) : 1.f;
  }
  return visibility;
}
}
