// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowCertifier.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowLights.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowProps.h"
#include "vtkRelievoThreads.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
// OpenGL's steps for edges in a pixel.
constexpr double SubPixel = 1.0 / 256.0;

// Surfaces are searched at the layer depth's value, within this share of it; in parallel
// projection, of the whole depth range.
constexpr double DepthWindow = 1e-3;

constexpr double TransmittanceSlack = 0.02;
constexpr std::size_t Batch = 8192;
const char* const DepthLayer = "depth";
constexpr double MostTexels = 8.0;

// Whether all numbers fit a half float's 11 bits.
bool AreHalf(const float* depths, vtkIdType count)
{
  return std::all_of(depths, depths + count, [](float depth) {
    int power = 0;
    const float bits = std::ldexp(std::frexp(depth, &power), 11);
    return !std::isfinite(depth) || bits == std::floor(bits);
  });
}

// Adds the casters of other processes; meshes with copies of other processes' cells are replaced by
// those.
void AddOthers(const vtkRelievoMeshExchange& others, std::vector<vtkRelievoSurface>& surfaces)
{
  for (std::size_t i = 0, own = surfaces.size(); i < own; ++i)
  {
    vtkRelievoSurface casting = surfaces[i];
    casting.Caster.Mesh = others.GetOwn(casting.Caster.Mesh);
    if (casting.Casts && casting.Caster.Mesh != surfaces[i].Caster.Mesh)
    {
      surfaces[i].Casts = false;
      casting.Seen = casting.Receives = false;
      surfaces.push_back(casting);
    }
  }
  for (const vtkRelievoPlacedMesh& mesh : others.GetOthers())
  {
    vtkRelievoSurface surface;
    surface.Caster = mesh;
    surface.Seen = surface.Receives = false;
    surfaces.push_back(surface);
  }
}

// Maps are merged without the casters of other processes: these are exchanged for the rays alone.
// `fault`: this process's error, of which all processes learn. Returns an error if any has one.
std::string ExchangeCasters(vtkRelievoMeshExchange& others,
  const std::vector<vtkRelievoSurface>& surfaces, const std::vector<vtkRelievoBox>& unfollowed,
  const std::string& fault)
{
  vtkRelievoMeshPart part;
  for (const vtkRelievoSurface& surface : surfaces)
  {
    if (surface.Casts)
    {
      part.Meshes.push_back(surface.Caster);
    }
  }
  part.InMaps = unfollowed;
  const std::string declined = others.Share(part, false);
  return declined.empty() ? others.Confirm(fault) : declined;
}

// Draws the layers with the renderer alone, into a framebuffer of the frame; returns an error, or
// "".
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
  const bool amends = frame->GetAmends();
  frame->SetAmends(false); // shadows fall on surfaces
  renderer->GetRenderWindow()->Start();
  renderer->Render();
  frame->SetLayersOnly(layersOnly);
  std::string fault = frame->TryReadLayers(layers, image);
  frame->SetAmends(amends);
  renderer->GetRenderWindow()->End();
  for (const std::string& layer : added)
  {
    frame->ReleaseLayer(layer);
  }
  return fault;
}

// A step from the centre of a pixel towards one of its four sides.
vtkRelievoPixelRay GetBeside(const vtkRelievoShadowPixels& pixels, int x, int y, int corner)
{
  return pixels.GetRay(
    x + 0.5 + (corner & 1 ? SubPixel : -SubPixel), y + 0.5 + (corner & 2 ? SubPixel : -SubPixel));
}

// Points and lines in maps are wider than their boxes by some texels.
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
vtkSmartPointer<vtkRelievoShadowCertificate> vtkRelievoShadowCertifier::CertifyPicture(
  const Picture& picture, int rays, int seed, std::string& fault)
{
  const std::vector<vtkRelievoShadowLight>& casting = picture.Lights.GetCasting();
  std::vector<std::string> layers;
  for (const vtkRelievoShadowLight& light : casting)
  {
    layers.push_back(picture.Lights.GetLayer(picture.Renderer, light.Light));
  }
  const std::size_t count = layers.size();
  layers.emplace_back(DepthLayer);
  vtkNew<vtkImageData> image;
  vtkNew<vtkImageData> dimmed;
  picture.Work.WithoutVolumes = true;
  fault = DrawLayers(picture.Renderer, picture.Frame, layers, image);
  picture.Work.WithoutVolumes = false;
  // Processes draw together: all of them twice, whoever has the volumes.
  const bool volumes = picture.Work.Others.IsOn() || !picture.Work.Props.GetVolumeCasters().empty();
  if (volumes && (fault.empty() || picture.Work.Others.IsOn()))
  {
    const std::string again = DrawLayers(picture.Renderer, picture.Frame, layers, dimmed);
    fault = fault.empty() ? again : fault;
  }
  if (fault.empty() && casting.size() != count)
  {
    fault = "other lights cast now";
  }
  vtkRelievoShadowCertifier certifier;
  certifier.Attenuates = picture.Method->Traces();
  // Maps treat translucent casters as opaque.
  std::vector<vtkRelievoSurface> surfaces =
    picture.Work.Props.CollectSurfaces(certifier.Attenuates, certifier.Unfollowed);
  vtkRelievoMeshExchange exchanged = picture.Work.Others;
  if (exchanged.IsOn() && !certifier.Attenuates) // rays have exchanged them for the picture
  {
    exchanged.Clear();
    fault = ExchangeCasters(exchanged, surfaces, certifier.Unfollowed, fault);
  }
  if (!fault.empty())
  {
    return nullptr;
  }
  const auto read = [](vtkImageData* from, const std::string& layer) {
    auto* array = vtkFloatArray::SafeDownCast(from->GetPointData()->GetArray(layer.c_str()));
    return array ? array->GetPointer(0) : nullptr;
  };
  certifier.View = picture.Work.View;
  certifier.Lights = casting;
  certifier.Depth = read(image, DepthLayer);
  certifier.CoarseDepth = AreHalf(certifier.Depth, image->GetNumberOfPoints());
  for (std::size_t i = 0; i < count; ++i)
  {
    certifier.Visibility.push_back(read(image, layers[i]));
    certifier.Dimmed.push_back(volumes ? read(dimmed, layers[i]) : nullptr);
  }
  if (exchanged.IsOn())
  {
    AddOthers(exchanged, surfaces);
    const std::vector<vtkRelievoBox>& boxes = exchanged.GetWhole().InMaps;
    certifier.Unfollowed.insert(certifier.Unfollowed.end(), boxes.begin(), boxes.end());
  }
  // Rays do not reach the values of other processes' volumes, whose shade begins beside them.
  const std::vector<glm::dvec3>& corners = picture.Work.Shade.GetOthers();
  const double beside = picture.Work.Shade.GetNodeDistance();
  for (std::size_t i = 0; i + 8 <= corners.size(); i += 8)
  {
    vtkRelievoBox box;
    box.Min = box.Max = corners[i];
    for (std::size_t corner = i; corner < i + 8; ++corner)
    {
      box.Min = glm::min(box.Min, corners[corner]);
      box.Max = glm::max(box.Max, corners[corner]);
    }
    box.Min -= beside;
    box.Max += beside;
    certifier.Unfollowed.push_back(box);
  }
  fault = certifier.Rays.SetSurfaces(surfaces);
  if (!fault.empty())
  {
    fault = "no tree for rays: " + fault;
    return nullptr;
  }
  const double wider = GetWidth(picture.Work.Cache);
  for (vtkRelievoBox& box : certifier.Unfollowed)
  {
    box.Min -= wider;
    box.Max += wider;
  }
  certifier.AddVolumes(picture.Work.Props);
  auto certificate = vtkSmartPointer<vtkRelievoShadowCertificate>::New();
  certifier.Certify(rays, seed, certificate);
  return certificate;
}

//------------------------------------------------------------------------------
// Volumes that rays cannot trace cast no shadow, which may be wrong.
void vtkRelievoShadowCertifier::AddVolumes(const vtkRelievoShadowProps& props)
{
  for (const vtkRelievoPlacedVolume& placed : props.GetVolumeCasters())
  {
    std::string why;
    for (const vtkRelievoVolumeExtinction& field : vtkRelievoVolumeExtinction::Collect(placed, why))
    {
      this->Volumes.push_back(field);
    }
    vtkAbstractVolumeMapper* mapper = placed.Volume->GetMapper();
    const double* bounds = mapper ? mapper->GetBounds() : placed.Volume->GetBounds();
    if (!why.empty() && bounds && bounds[0] <= bounds[1])
    {
      // A volume without a mapper, as a vtkMultiVolume, has bounds in the world.
      const glm::dmat4 toWorld = mapper ? placed.ToWorld : glm::dmat4(1.0);
      vtkRelievoBox box;
      for (int i = 0; i < 8; ++i)
      {
        const glm::dvec3 corner(
          toWorld * glm::dvec4(bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)], 1.0));
        box.Min = i == 0 ? corner : glm::min(box.Min, corner);
        box.Max = i == 0 ? corner : glm::max(box.Max, corner);
      }
      this->Unfollowed.push_back(box);
    }
  }
}

//------------------------------------------------------------------------------
vtkRelievoShadowCertifier::Findings vtkRelievoShadowCertifier::Judge(int x, int y, int light) const
{
  const std::size_t pixel = static_cast<std::size_t>(y) * this->View.Viewport[2] + x;
  const double depth = this->Depth[pixel];
  if (!std::isfinite(depth))
  {
    return NOTHING;
  }
  const double window = this->GetDepthWindow(depth);
  const double wanted = this->CoarseDepth ? depth - window : depth;
  const vtkRelievoShadowPixels pixels(this->View, this->Rays.GetCenter());
  const vtkRelievoPixelRay eye = pixels.GetRay(x + 0.5, y + 0.5);
  const vtkRelievoCasterRays::Hit seen =
    this->Rays.Find(eye.From, eye.Ray, depth - window, depth + window, wanted);
  const float drawn = this->Visibility[light][pixel];
  // On an outline OpenGL may draw a surface that the ray through the pixel's centre just misses.
  for (int corner = 0; corner < 4 && seen.Surface < 0; ++corner)
  {
    const vtkRelievoPixelRay beside = GetBeside(pixels, x, y, corner);
    if (this->Rays.Find(beside.From, beside.Ray, depth - window, depth + window, wanted).Surface >=
      0)
    {
      return TIE;
    }
  }
  if (seen.Surface < 0 || !std::isfinite(drawn))
  {
    return UNKNOWN;
  }
  const glm::dvec3 place = eye.From + seen.T * eye.Ray;
  const vtkRelievoToLight to(this->Lights[light], place, this->Rays.GetCenter());
  if (!to.Lights || !this->Rays.GetSurfaces()[seen.Surface].Receives)
  {
    return UNLIT;
  }
  const double facing = glm::dot(glm::normalize(seen.Normal), glm::normalize(to.Ray));
  if (!(facing > vtkRelievoLeastFacing))
  {
    return GRAZING;
  }
  if (vtkRelievoMeetsAny(this->Unfollowed, this->Rays.GetCenter(), place, to.Ray, to.Last))
  {
    return UNKNOWN;
  }
  const double blur = vtkRelievoPlaceBlur * glm::length(seen.T * eye.Ray);
  const double truth = this->Rays.Pass(place, to.Ray, to.Last, seen, blur);
  const auto getDimmed = [&](const glm::dvec3& at) {
    return std::exp(-vtkRelievoOpticalDepths::GetExactDepth(
      this->Volumes, this->Lights[light].GetSource(), at + this->Rays.GetCenter()));
  };
  const double passes = this->Volumes.empty() ? 1.0 : getDimmed(place);
  // Before the drawn verdict is known, which must not influence the selection.
  for (int corner = 0; corner < 4; ++corner)
  {
    const vtkRelievoPixelRay beside = GetBeside(pixels, x, y, corner);
    const double t = glm::dot(seen.Normal, place - beside.From) / glm::dot(seen.Normal, beside.Ray);
    const glm::dvec3 at = beside.From + t * beside.Ray;
    const vtkRelievoToLight other(this->Lights[light], at, this->Rays.GetCenter());
    if (this->Rays.Pass(at, other.Ray, other.Last, seen, blur) != truth ||
      this->HasOtherNeighbour(
        beside, light, wanted + glm::clamp(t - seen.T, -window, window), seen, truth) ||
      (!this->Volumes.empty() && std::abs(getDimmed(at) - passes) > TransmittanceSlack))
    {
      return TIE;
    }
  }
  if (!this->IsAlike(drawn, truth))
  {
    return drawn < truth ? FALSE_SHADOW : FALSE_LIGHT;
  }
  const double off = this->Dimmed[light] ? this->Dimmed[light][pixel] - drawn * passes : 0.0;
  return std::abs(off) <= TransmittanceSlack ? RIGHT : off < 0.0 ? FALSE_SHADOW : FALSE_LIGHT;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowCertifier::IsAlike(double a, double b) const
{
  return this->Attenuates ? std::abs(a - b) <= TransmittanceSlack : (a >= 0.5) == (b >= 0.5);
}

//------------------------------------------------------------------------------
// Whether a ray beside the pixel's centre hits another triangle with another verdict: OpenGL may
// draw either.
bool vtkRelievoShadowCertifier::HasOtherNeighbour(const vtkRelievoPixelRay& beside, int light,
  double wanted, const vtkRelievoCasterRays::Hit& seen, double truth) const
{
  const double window = this->GetDepthWindow(wanted);
  const vtkRelievoCasterRays::Hit found =
    this->Rays.Find(beside.From, beside.Ray, wanted - window, wanted + window, wanted);
  if (found.Surface < 0 || (found.Place == seen.Place && found.Triangle == seen.Triangle))
  {
    return false;
  }
  const glm::dvec3 place = beside.From + found.T * beside.Ray;
  const vtkRelievoToLight to(this->Lights[light], place, this->Rays.GetCenter());
  const double blur = vtkRelievoPlaceBlur * glm::length(found.T * beside.Ray);
  const double passes = glm::dot(found.Normal, to.Ray) > 0.0
    ? this->Rays.Pass(place, to.Ray, to.Last, found, blur)
    : 0.0;
  return !this->IsAlike(passes, truth);
}

//------------------------------------------------------------------------------
double vtkRelievoShadowCertifier::GetDepthWindow(double depth) const
{
  return DepthWindow *
    (this->View.Parallel ? std::max(std::abs(depth), this->View.Far - this->View.Near) : depth);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCertifier::Certify(
  int rays, int seed, vtkRelievoShadowCertificate* certificate) const
{
  const std::size_t width = static_cast<std::size_t>(this->View.Viewport[2]);
  const std::size_t pixels = width * static_cast<std::size_t>(this->View.Viewport[3]);
  std::vector<std::size_t> order(pixels * this->Lights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  vtkRelievoSplitMix64 lots(static_cast<std::uint64_t>(seed));
  std::vector<Findings> findings;
  for (std::size_t from = 0; from < order.size() && certificate->Judged < rays;)
  {
    const std::size_t to = std::min(order.size(), from + Batch);
    for (std::size_t i = from; i < to; ++i)
    {
      std::swap(order[i], order[i + lots.Next() % (order.size() - i)]);
    }
    findings.assign(to - from, NOTHING);
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(
        static_cast<vtkIdType>(from), static_cast<vtkIdType>(to), [&](vtkIdType a, vtkIdType b) {
          for (vtkIdType i = a; i < b; ++i)
          {
            const std::size_t one = order[static_cast<std::size_t>(i)];
            const std::size_t pixel = one % pixels;
            findings[static_cast<std::size_t>(i) - from] =
              this->Judge(static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                static_cast<int>(one / pixels));
          }
        });
    });
    for (std::size_t i = 0; i < findings.size() && certificate->Judged < rays; ++i)
    {
      const Findings found = findings[i];
      certificate->Judged += found <= FALSE_LIGHT ? 1 : 0;
      certificate->FalseShadow += found == FALSE_SHADOW ? 1 : 0;
      certificate->FalseLight += found == FALSE_LIGHT ? 1 : 0;
      certificate->Ties += found == TIE ? 1 : 0;
      certificate->Grazing += found == GRAZING ? 1 : 0;
      certificate->Unlit += found == UNLIT ? 1 : 0;
      certificate->Unknown += found == UNKNOWN ? 1 : 0;
    }
    from = to;
  }
}
