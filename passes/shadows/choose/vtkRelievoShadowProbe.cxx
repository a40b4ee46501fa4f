// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowProbe.h"

#include "vtkRelievoProbeView.h"
#include "vtkRelievoPropMeshes.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowMethods.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>

namespace
{
// Sides of the coarse maps, in texels.
constexpr int Sides[] = { 512, 2048 };

// Exponents of the law: where edges are many texels apart, and where they are not.
constexpr double Power = 0.9;
constexpr double LeastPower = 0.5;

// Ratio of wrong verdicts of maps to those counted by the probe: fitted to the planner's bench
// (docs/charts/README.md).
constexpr double WrongOfCounted = 0.6;

constexpr int Phases = 8;          // tested offsets of the grid
constexpr int LeastSamples = 3000; // pixels that face a light
constexpr int MostPixels = 9000;   // pixels tested to find them
constexpr int FittedSize = 2048;   // of the maps whose views are requested

vtkRelievoShadowScene GetScene(
  const vtkRelievoShadowContext& work, const vtkRelievoFrameCamera& view)
{
  vtkRelievoShadowScene scene;
  vtkRelievoShadowFit::Request& request = scene.Request;
  request.Size = FittedSize;
  request.Border = work.Radius + 1;
  const glm::dmat4 viewToWorld = glm::inverse(view.WorldToView);
  request.Eye = glm::dvec3(viewToWorld[3]);
  request.Gaze = glm::normalize(-glm::dvec3(viewToWorld[2]));
  request.ViewUp = glm::dvec3(viewToWorld[1]);
  request.ParallelEye = view.Parallel;
  scene.WorldToNDC = view.ViewToNDC * view.WorldToView;
  scene.Casters = work.Props.GetAllBoxes(); // a method may have removed casters
  scene.Receivers = work.Props.GetReceiverBoxes();
  return scene;
}

void Add(std::vector<double>& key, const glm::dvec3& v)
{
  key.insert(key.end(), { v.x, v.y, v.z });
}

void Add(std::vector<double>& key, const glm::dmat4& m)
{
  key.insert(key.end(), &m[0][0], &m[0][0] + 16);
}

// Maps one axis of the fitted rectangle to the map.
double Place(const vtkRelievoMapAxis& axis, double from)
{
  int i = 0;
  while (i + 1 < axis.Pieces && from > axis.From[i + 1])
  {
    ++i;
  }
  return axis.To[i] +
    (from - axis.From[i]) * (axis.To[i + 1] - axis.To[i]) / (axis.From[i + 1] - axis.From[i]);
}

// n.l of the visible surface.
double GetFacing(const vtkRelievoCasterRays::Hit& seen, const vtkRelievoToLight& to)
{
  return glm::dot(glm::normalize(seen.Normal), glm::normalize(to.Ray));
}

// A place on the map, both coordinates 0 to 1; false outside it.
bool Project(const vtkRelievoShadowView& view, const glm::dvec3& world, glm::dvec2& at)
{
  const glm::dvec4 clip = view.ViewToNDC * (view.WorldToView * glm::dvec4(world, 1.0));
  if (!(clip.w > 0.0))
  {
    return false;
  }
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  at = glm::dvec2(Place(view.U, 0.5 + 0.5 * ndc.x), Place(view.V, 0.5 + 0.5 * ndc.y));
  return std::abs(ndc.x) <= 1.0 && std::abs(ndc.y) <= 1.0;
}
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowProbe::HasScene(const vtkRelievoShadowProps& props) const
{
  return props.GetSceneState() == this->Scene;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProbe::Settle(const vtkRelievoShadowProps& props)
{
  this->Scene = props.GetSceneState();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProbe::Release()
{
  const int updates = this->Updates;
  *this = vtkRelievoShadowProbe();
  this->Updates = updates;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProbe::Update(const vtkRelievoShadowContext& work,
  const std::vector<vtkRelievoShadowLight>& lights, const vtkRelievoFrameCamera& picture)
{
  const glm::dvec3 center = vtkRelievoShadowRegion::GetMiddle(vtkRelievoShadowRegion::Cut(
    work.Props.GetReceiverBoxes(), picture.ViewToNDC * picture.WorldToView));
  const vtkRelievoFrameCamera view =
    vtkRelievoProbeView::GetStep(picture, center, work.Props.GetReceiverBoxes());
  const double first = vtkRelievoProbeView::GetFirst(picture, work.Props.GetAllBoxes());
  const std::vector<vtkRelievoShadowLight> casting = vtkRelievoProbeView::GetStep(lights, center);
  std::vector<double> key = { static_cast<double>(view.Viewport[2]),
    static_cast<double>(view.Viewport[3]), first, work.Bias, static_cast<double>(work.Radius) };
  Add(key, view.WorldToView);
  Add(key, view.ViewToNDC);
  for (const vtkRelievoShadowLight& light : casting)
  {
    Add(key, light.Positional ? light.Position : light.Direction);
    Add(key, light.Direction);
    key.insert(key.end(), { light.Positional ? 1.0 : 0.0, light.ConeAngle, light.Reach });
  }
  for (const vtkRelievoBox& box : work.Props.GetAllBoxes())
  {
    Add(key, box.Min);
    Add(key, box.Max);
  }
  if (key == this->Key && this->HasScene(work.Props))
  {
    return;
  }
  this->Key = key;
  this->Settle(work.Props);
  ++this->Updates;
  this->Lights = casting;
  this->Unfollowed.clear();
  // Without memory for their trees the probe finds nothing, and is not known.
  this->Rays.SetSurfaces(work.Props.CollectSurfaces(false, this->Unfollowed));
  const vtkRelievoShadowScene scene = GetScene(work, view);
  this->Nearest = std::max(first, view.Parallel ? 2.0 * view.Near - view.Far : 1e-9 * view.Near);
  this->EdgeShare = -1.0;
  this->TakeSamples(view, vtkRelievoProbeView::GetPart(scene.Receivers, scene.WorldToNDC));
  vtkRelievoShadowCache even;
  even.Update(casting, scene, *vtkRelievoShadowMethod::Make(vtkRelievoShadowMethods::MAP));
  this->Maps = even.GetNumberOfMaps();
  this->Even = this->Ask(even, work.Bias);
  this->Warped = this->Even;
  if (std::any_of(casting.begin(), casting.end(),
        [](const vtkRelievoShadowLight& light) { return !light.Positional; }))
  {
    vtkRelievoShadowCache warped;
    warped.Update(casting, scene, *vtkRelievoShadowMethod::Make(vtkRelievoShadowMethods::WARPED));
    this->Warped = this->Ask(warped, work.Bias);
  }
}

//------------------------------------------------------------------------------
double vtkRelievoShadowProbe::GetRoundedReach() const
{
  double reach = 0.0;
  for (const vtkRelievoSurface& surface : this->Rays.GetSurfaces())
  {
    reach = std::max(reach, vtkRelievoPropMeshes::GetRoundedReach(surface.Caster));
  }
  return reach;
}

//------------------------------------------------------------------------------
// Places that face a light, at pixels that cover the part evenly (M. Roberts, The unreasonable
// effectiveness of quasirandom sequences, 2018).
void vtkRelievoShadowProbe::TakeSamples(const vtkRelievoFrameCamera& view, const glm::dvec4& part)
{
  const vtkRelievoShadowPixels pixels(view, this->Rays.GetCenter());
  const glm::dvec3 center = this->Rays.GetCenter();
  this->Samples.clear();
  long long unknown = 0;
  std::vector<std::vector<Sample>> found;
  for (int first = 0; first < MostPixels && static_cast<int>(this->Samples.size()) < LeastSamples;
       first += LeastSamples)
  {
    found.assign(LeastSamples, {});
    std::vector<char> lost(LeastSamples, 0);
    const auto look = [&](int i) {
      const double x = part.x + part.z * std::fmod(0.5 + 0.7548776662466927 * (first + i), 1.0);
      const double y = part.y + part.w * std::fmod(0.5 + 0.5698402909980532 * (first + i), 1.0);
      const vtkRelievoPixelRay eye = pixels.GetRay(x * view.Viewport[2], y * view.Viewport[3]);
      const vtkRelievoCasterRays::Hit seen = this->Rays.FindFirst(eye.From, eye.Ray, this->Nearest);
      lost[i] = vtkRelievoMeetsAny(
        this->Unfollowed, center, eye.From, eye.Ray, seen.Surface < 0 ? 1e300 : seen.T);
      if (seen.Surface < 0 || lost[i] || !this->Rays.GetSurfaces()[seen.Surface].Receives)
      {
        return;
      }
      const glm::dvec3 place = eye.From + seen.T * eye.Ray;
      const double blur = vtkRelievoPlaceBlur * std::abs(seen.T) * glm::length(eye.Ray);
      // To the right, left, above or below.
      const glm::dvec2 aside = (i & 2 ? -0.5 : 0.5) * glm::dvec2(i & 1, ~i & 1);
      const vtkRelievoPixelRay beside =
        pixels.GetRay(x * view.Viewport[2] + aside.x, y * view.Viewport[3] + aside.y);
      for (std::size_t light = 0; light < this->Lights.size(); ++light)
      {
        const vtkRelievoToLight to(this->Lights[light], place, center);
        if (!to.Lights || !(GetFacing(seen, to) > vtkRelievoLeastFacing))
        {
          continue;
        }
        lost[i] = lost[i] || vtkRelievoMeetsAny(this->Unfollowed, center, place, to.Ray, to.Last);
        const bool lit = this->Rays.Pass(place, to.Ray, to.Last, seen, blur) > 0.0;
        found[i].push_back({ place, seen, blur, beside, static_cast<int>(light), lit });
      }
    };
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(0, LeastSamples, [&](vtkIdType from, vtkIdType to) {
        for (vtkIdType i = from; i < to; ++i)
        {
          look(static_cast<int>(i));
        }
      });
    });
    for (int i = 0; i < LeastSamples; ++i)
    {
      unknown += lost[i] ? 1 : 0;
      if (!lost[i])
      {
        this->Samples.insert(this->Samples.end(), found[i].begin(), found[i].end());
      }
    }
  }
  this->Known = !this->Samples.empty() && unknown <= static_cast<long long>(this->Samples.size());
}

//------------------------------------------------------------------------------
vtkRelievoShadowProbe::Count vtkRelievoShadowProbe::Ask(
  const vtkRelievoShadowCache& cache, double bias) const
{
  struct Wrong
  {
    double At[Levels] = { 0.0, 0.0 };
  };
  std::vector<Wrong> counts(this->Samples.size());
  const glm::dvec3 center = this->Rays.GetCenter();
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(this->Samples.size()), [&](vtkIdType from, vtkIdType to) {
        for (vtkIdType i = from; i < to; ++i)
        {
          const Sample& sample = this->Samples[i];
          const auto& maps = cache.GetEntries()[sample.Light].Maps;
          // There are no casters outside all maps.
          const auto map = std::find_if(maps.begin(), maps.end(), [&](const auto& each) {
            glm::dvec2 at;
            return Project(each.View, sample.Place + center, at);
          });
          if (map != maps.end())
          {
            this->AddWrong(sample, map->View, bias, counts[i].At);
          }
        }
      });
  });
  Count count;
  count.Asked = static_cast<double>(counts.size());
  for (const Wrong& each : counts)
  {
    for (int level = 0; level < Levels; ++level)
    {
      count.Wrong[level] += each.At[level];
    }
  }
  return count;
}

//------------------------------------------------------------------------------
// For each of the coarse maps, the share of grid offsets with a wrong verdict.
void vtkRelievoShadowProbe::AddWrong(const Sample& sample, const vtkRelievoShadowView& view,
  double bias, double (&shares)[Levels]) const
{
  const glm::dvec3 center = this->Rays.GetCenter();
  const glm::dvec3 world = sample.Place + center;
  const glm::dvec3 normal = glm::normalize(sample.Seen.Normal);
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
    : size.y <= size.z                                         ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  const glm::dvec3 right = glm::normalize(glm::cross(normal, axis));
  const glm::dvec3 up = glm::cross(normal, right);
  const double depth = -(view.WorldToView * glm::dvec4(world, 1.0)).z;
  const double texel = view.Texel * (view.Parallel ? 1.0 : depth); // of FittedSize
  // Change of the map's coordinates along the receiver's plane.
  const double step = 0.25 * texel;
  glm::dvec2 at;
  glm::dvec2 beside[2];
  Project(view, world, at);
  Project(view, world + step * right, beside[0]);
  Project(view, world + step * up, beside[1]);
  const glm::dmat2 slope((beside[0] - at) / step, (beside[1] - at) / step);
  if (!(std::abs(glm::determinant(slope)) > 0.0))
  {
    return;
  }
  const glm::dmat2 back = glm::inverse(slope);
  const vtkRelievoShadowLight& light = this->Lights[sample.Light];
  for (int level = 0; level < Levels; ++level)
  {
    const double side = Sides[level];
    double sum = 0.0;
    bool unlike = true;
    for (int phase = 0; phase < Phases && unlike; ++phase)
    {
      const glm::dvec2 shift =
        glm::fract(static_cast<double>(phase) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
      const glm::dvec2 low = glm::floor(at * side - 0.5 - shift) + 0.5 + shift;
      const glm::dvec2 within = at * side - low;
      double lit = 0.0;
      int count = 0;
      for (int corner = 0; corner < 4; ++corner)
      {
        const glm::dvec2 offset(corner & 1, corner >> 1);
        const glm::dvec2 along = back * ((low + offset) / side - at);
        glm::dvec3 start = sample.Place + along.x * right + along.y * up;
        start += glm::normalize(vtkRelievoToLight(light, start, center).Ray) *
          (bias * texel * FittedSize / side);
        const vtkRelievoToLight to(light, start, center);
        const glm::dvec2 weights = glm::mix(1.0 - within, within, offset);
        const bool passes = this->Rays.Pass(start, to.Ray, to.Last, sample.Seen, sample.Blur) > 0.0;
        lit += passes ? weights.x * weights.y : 0.0;
        count += passes == sample.Lit ? 1 : 0;
      }
      sum += (lit >= 0.5) != sample.Lit ? 1.0 : 0.0;
      unlike = phase > 0 || count < 4;
    }
    shares[level] += sum / Phases;
  }
}

//------------------------------------------------------------------------------
double vtkRelievoShadowProbe::GetWrongShare(int size, bool warped) const
{
  const Count& count = warped ? this->Warped : this->Even;
  const double asked = std::max(1.0, count.Asked);
  const double ratio = static_cast<double>(Sides[1]) / Sides[0];
  // Half a pixel more than the number found: finding none does not prove that there are none.
  const double coarse = (count.Wrong[0] + 0.5 * std::pow(ratio, Power)) / asked;
  const double fine = (count.Wrong[1] + 0.5) / asked;
  // The coarser map gives most of the estimate as long as the law holds.
  const double both =
    (count.Wrong[0] + count.Wrong[1] + 0.5) / (asked * (1.0 + std::pow(ratio, Power)));
  const double share = std::max(both, fine);
  const double found = std::log(coarse / fine) / std::log(ratio);
  const double power = std::min(Power, std::max(LeastPower, found + 0.3));
  return std::min(
    1.0, WrongOfCounted * share * std::pow(static_cast<double>(size) / Sides[1], -power));
}

//------------------------------------------------------------------------------
double vtkRelievoShadowProbe::GetEdgeShare()
{
  if (this->EdgeShare < 0.0)
  {
    std::vector<char> edges(this->Samples.size());
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(0, static_cast<vtkIdType>(edges.size()), [&](vtkIdType from, vtkIdType to) {
        for (vtkIdType i = from; i < to; ++i)
        {
          edges[i] = this->IsAtEdge(this->Samples[i]) ? 1 : 0;
        }
      });
    });
    this->EdgeShare = static_cast<double>(std::count(edges.begin(), edges.end(), 1)) /
      static_cast<double>(std::max<std::size_t>(1, edges.size()));
  }
  return this->EdgeShare;
}

//------------------------------------------------------------------------------
// No edge if the neighbouring pixel shows no surface, or one outside the light's cone, which has no
// verdict.
bool vtkRelievoShadowProbe::IsAtEdge(const Sample& sample) const
{
  const vtkRelievoPixelRay& eye = sample.Beside;
  const vtkRelievoCasterRays::Hit seen = this->Rays.FindFirst(eye.From, eye.Ray, this->Nearest);
  if (seen.Surface < 0)
  {
    return false;
  }
  const glm::dvec3 place = eye.From + seen.T * eye.Ray;
  const vtkRelievoToLight to(this->Lights[sample.Light], place, this->Rays.GetCenter());
  if (!to.Lights)
  {
    return false;
  }
  const bool lit =
    GetFacing(seen, to) > 0.0 && this->Rays.Pass(place, to.Ray, to.Last, seen, sample.Blur) > 0.0;
  return lit != sample.Lit;
}
