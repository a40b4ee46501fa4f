// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass proves its picture: it is drawn again as layers, and judged.
#include "vtkRelievoShadowInternals.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoCasterRays.h"
#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoShadowJudge.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
const char* const Depth = "depth";
constexpr double MostTexels = 8.0;

// Whether all of them have a half float's 11 bits.
bool AreHalf(const float* depths, vtkIdType count)
{
  return std::all_of(depths, depths + count, [](float depth) {
    int power = 0;
    const float bits = std::ldexp(std::frexp(depth, &power), 11);
    return !std::isfinite(depth) || bits == std::floor(bits);
  });
}

// The renderer alone draws the layers, into a framebuffer of the frame's own; "" or what is wrong.
std::string DrawLayers(vtkRenderer* renderer, vtkRelievoFramePass* frame,
  const std::vector<std::string>& layers, vtkImageData* image)
{
  std::vector<std::string> added;
  for (const std::string& layer : layers)
  {
    if (!frame->IsLayerRequested(layer))
    {
      frame->RequestLayer(layer);
      added.push_back(layer);
    }
  }
  const bool layersOnly = frame->GetLayersOnly();
  frame->SetLayersOnly(true);
  renderer->GetRenderWindow()->Start();
  renderer->Render();
  frame->SetLayersOnly(layersOnly);
  std::string fault = frame->TryReadLayers(layers, image);
  renderer->GetRenderWindow()->End();
  for (const std::string& layer : added)
  {
    frame->ReleaseLayer(layer);
  }
  return fault;
}

// What is drawn into maps as points and lines is wider there than its box, by some texels.
double GetWidth(const vtkRelievoShadowCache& cache)
{
  double widest = 0.0;
  for (const auto& entry : cache.GetEntries())
  {
    for (const auto& map : entry.Maps)
    {
      widest = std::max(widest, map.View.Texel * (map.View.Parallel ? 1.0 : map.View.Far));
    }
  }
  return MostTexels * widest;
}
}

//------------------------------------------------------------------------------
vtkRelievoShadowCertificate* vtkRelievoShadowPass::Certify(int rays, int seed)
{
  Internals& in = *this->Internal;
  in.Certificate = nullptr;
  if (rays <= 0)
  {
    vtkErrorMacro("Certify was given " << rays << " rays; give it 1 or more. 6000 without an error "
                                       << "prove a share of wrong verdicts below 0.05 %.");
    return nullptr;
  }
  if (this->SoftSamples > 1 && !in.Schedule.Exchange.IsOn())
  {
    vtkErrorMacro("Certify judges verdicts of lights that are points, and SoftSamples is "
      << this->SoftSamples << "; set it to 0 and render first.");
    return nullptr;
  }
  vtkRenderer* const renderer = in.Renderer;
  vtkRelievoFramePass* const frame = in.Frame;
  if (!frame || !renderer || !renderer->GetRenderWindow() || in.Lights.GetCasting().empty())
  {
    vtkErrorMacro("Certify has no picture: the last frame made no shadows of lights. Switch them "
                  "on, add a light that casts, and render first.");
    return nullptr;
  }
  std::vector<std::string> layers;
  for (const vtkRelievoShadowLight& light : in.Lights.GetCasting())
  {
    layers.push_back(in.Lights.GetLayer(renderer, light.Light));
  }
  const std::size_t casting = layers.size();
  layers.emplace_back(Depth);
  vtkNew<vtkImageData> image;
  const std::string fault = DrawLayers(renderer, frame, layers, image);
  if (!fault.empty() || in.Lights.GetCasting().size() != casting)
  {
    vtkErrorMacro("Certify could not draw the picture again: " << fault << ".");
    return nullptr;
  }
  const auto read = [&image](const std::string& layer) {
    auto* array = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(layer.c_str()));
    return array ? array->GetPointer(0) : nullptr;
  };
  vtkRelievoShadowJudge judge;
  judge.View = in.Work.View;
  judge.Attenuates = in.Method->Traces();
  judge.Lights = in.Lights.GetCasting();
  judge.Depth = read(Depth);
  judge.CoarseDepth = AreHalf(judge.Depth, image->GetNumberOfPoints());
  for (std::size_t i = 0; i < casting; ++i)
  {
    judge.Visibility.push_back(read(layers[i]));
  }
  // Maps know translucent casters as opaque ones.
  std::vector<vtkRelievoSurface> surfaces =
    in.Work.Props.CollectSurfaces(in.Method->Traces(), judge.Unfollowed);
  if (in.Method->Traces() && in.Work.Others.IsOn())
  {
    in.Work.Others.AddTo(surfaces);
    const std::vector<vtkRelievoBox>& others = in.Work.Others.GetWhole().InMaps;
    judge.Unfollowed.insert(judge.Unfollowed.end(), others.begin(), others.end());
  }
  judge.Rays.SetSurfaces(surfaces);
  const double wider = GetWidth(in.Work.Cache);
  for (vtkRelievoBox& box : judge.Unfollowed)
  {
    box.Min -= wider;
    box.Max += wider;
  }
  in.Certificate = vtkSmartPointer<vtkRelievoShadowCertificate>::New();
  judge.Certify(rays, seed, in.Certificate);
  return in.Certificate;
}
