// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowProbe.h"

#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowPass.h"
#include "vtkRelievoShadowWork.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoTiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Sides of the coarse maps, in texels.
constexpr int Sides[] = { 512, 2048 };

// Powers of the law: where edges are far apart for a texel, and where they are not.
constexpr double Power = 0.9;
constexpr double LeastPower = 0.5;

// Wrong verdicts of maps over those that are counted so: fitted to the bench of the planner
// (docs/charts/README.md).
constexpr double WrongOfCounted = 0.6;

constexpr int Phases = 8;            // places of the grid that are tried
constexpr int LeastSamples = 3000;   // that face a light
constexpr int MostPixels = 9000;     // that are looked at for them
constexpr double LightSteps = 32.0;  // of a light, in its distance
constexpr int FittedSize = 2048;     // of the maps whose views are asked for
constexpr double StepsPerView = 8.0; // of the camera, in half the height of what it sees

glm::dvec3 Round(const glm::dvec3& v, double step)
{
  return step * glm::round(v / step);
}

// Near and far in steps, as most cameras' follow the scene; only what is in view by its sides
// matters.
void SetDepths(vtkRelievoView& view)
{
  double& n = view.Near;
  double& f = view.Far;
  glm::dmat4& p = view.ViewToNDC;
  if (!(f > n) || !(view.Parallel || n > 0.0))
  {
    return;
  }
  if (view.Parallel)
  {
    const double step = 0.5 * std::exp2(std::ceil(std::log2(f - n)));
    n = step * std::floor(n / step);
    f = step * std::ceil(f / step);
    p[2][2] = -2.0 / (f - n);
    p[3][2] = -(f + n) / (f - n);
    return;
  }
  n = std::exp2(std::floor(std::log2(n)));
  f = std::exp2(std::ceil(std::log2(f)));
  p[2][2] = -(f + n) / (f - n);
  p[3][2] = -2.0 * f * n / (f - n);
}

// The depth from which on surfaces are seen, in steps: the near plane's if it cuts something.
double GetFirst(const vtkRelievoView& view, const std::vector<vtkRelievoBox>& boxes)
{
  const auto cut = [&view](const vtkRelievoBox& box) {
    double low = 1e300;
    double high = -1e300;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec4 corner(i & 1 ? box.Max.x : box.Min.x, i & 2 ? box.Max.y : box.Min.y,
        i & 4 ? box.Max.z : box.Min.z, 1.0);
      const double depth = -(view.WorldToView * corner).z;
      low = std::min(low, depth);
      high = std::max(high, depth);
    }
    return low < view.Near && high > (view.Parallel ? -1e300 : 0.0);
  };
  if (!(view.Far > view.Near) || std::none_of(boxes.begin(), boxes.end(), cut))
  {
    return std::numeric_limits<double>::lowest();
  }
  if (view.Parallel)
  {
    const double step = std::exp2(std::floor(std::log2(view.Far - view.Near))) / 64.0;
    return step * std::floor(view.Near / step);
  }
  return view.Near > 0.0 ? std::exp2(std::floor(8.0 * std::log2(view.Near)) / 8.0) : 0.0;
}

// The camera at the nearest of a few places and directions.
vtkRelievoView GetStep(const vtkRelievoView& view, const glm::dvec3& center)
{
  vtkRelievoView stepped = view;
  const glm::dmat4 viewToWorld = glm::inverse(view.WorldToView);
  const glm::dvec3 eye(viewToWorld[3]);
  const double half = 1.0 / std::abs(view.ViewToNDC[1][1]); // at unit distance
  const double away = std::max(glm::length(center - eye), 1e-300);
  const double size = std::exp2(std::floor(std::log2(view.Parallel ? half : half * away)));
  if (!std::isfinite(size) || !(size > 0.0))
  {
    return view;
  }
  const double turn = (view.Parallel ? 0.25 : half) / StepsPerView;
  const glm::dvec3 back = glm::normalize(Round(glm::normalize(glm::dvec3(viewToWorld[2])), turn));
  glm::dvec3 up = Round(glm::normalize(glm::dvec3(viewToWorld[1])), 0.25 / StepsPerView);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  up = glm::cross(back, right);
  const glm::dvec3 from = Round(eye, size / StepsPerView);
  if (!(glm::length(right) > 0.5) || !(glm::length(back) > 0.5))
  {
    return view;
  }
  glm::dmat4 placed(1.0);
  placed[0] = glm::dvec4(right, 0.0);
  placed[1] = glm::dvec4(up, 0.0);
  placed[2] = glm::dvec4(back, 0.0);
  placed[3] = glm::dvec4(from, 1.0);
  stepped.WorldToView = glm::inverse(placed);
  SetDepths(stepped);
  return stepped;
}

// The lights at the nearest of a few places and directions.
std::vector<vtkRelievoShadowLight> GetStep(
  const std::vector<vtkRelievoShadowLight>& lights, const glm::dvec3& center)
{
  std::vector<vtkRelievoShadowLight> stepped = lights;
  for (vtkRelievoShadowLight& light : stepped)
  {
    light.Direction = glm::normalize(Round(light.Direction, 1.0 / LightSteps));
    const double size = std::exp2(std::floor(std::log2(glm::length(light.Position - center))));
    if (light.Positional && std::isfinite(size) && size > 0.0)
    {
      light.Position = Round(light.Position, size / LightSteps);
    }
  }
  return stepped;
}

vtkRelievoShadowScene GetScene(const vtkRelievoShadowWork& work, const vtkRelievoView& view)
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
  scene.Casters = work.Props.GetAllBoxes(); // a method may have taken casters out
  scene.Receivers = work.Props.GetReceiverBoxes();
  return scene;
}

// The part of the window that boxes are seen in.
glm::dvec4 GetPart(const std::vector<vtkRelievoBox>& boxes, const glm::dmat4& worldToNDC)
{
  glm::dvec2 low(1.0);
  glm::dvec2 high(-1.0);
  for (const glm::dvec3& point :
    vtkRelievoShadowRegion::GetPoints(vtkRelievoShadowRegion::Cut(boxes, worldToNDC)))
  {
    const glm::dvec4 clip = worldToNDC * glm::dvec4(point, 1.0);
    if (!(clip.w > 0.0))
    {
      return glm::dvec4(0.0, 0.0, 1.0, 1.0);
    }
    low = glm::min(low, glm::dvec2(clip) / clip.w);
    high = glm::max(high, glm::dvec2(clip) / clip.w);
  }
  low = glm::clamp(low, -1.0, 1.0);
  high = glm::clamp(high, -1.0, 1.0);
  return high.x > low.x && high.y > low.y ? glm::dvec4(0.5 * low + 0.5, 0.5 * (high - low))
                                          : glm::dvec4(0.0, 0.0, 1.0, 1.0);
}

void Add(std::vector<double>& key, const glm::dvec3& v)
{
  key.insert(key.end(), { v.x, v.y, v.z });
}

void Add(std::vector<double>& key, const glm::dmat4& m)
{
  key.insert(key.end(), &m[0][0], &m[0][0] + 16);
}

// Along one axis of the map, from the fitted rectangle to the map.
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

// A place on the map, both 0 to 1; false outside it.
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
vtkRelievoView vtkRelievoShadowProbe::GetPicture(const vtkRelievoView& view, vtkRenderer* renderer)
{
  vtkRelievoView picture = view;
  const glm::dmat4 toPicture = vtkRelievoGetTileToPicture(renderer);
  picture.ViewToNDC = toPicture * view.ViewToNDC;
  for (int axis = 0; axis < 2; ++axis)
  {
    int& pixels = picture.Viewport[2 + axis];
    pixels = static_cast<int>(std::lround(pixels / toPicture[axis][axis]));
  }
  return picture;
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
void vtkRelievoShadowProbe::Update(const vtkRelievoShadowWork& work,
  const std::vector<vtkRelievoShadowLight>& lights, const vtkRelievoView& picture)
{
  const glm::dvec3 center = vtkRelievoShadowRegion::GetMiddle(vtkRelievoShadowRegion::Cut(
    work.Props.GetReceiverBoxes(), picture.ViewToNDC * picture.WorldToView));
  const vtkRelievoView view = GetStep(picture, center);
  const double first = GetFirst(picture, work.Props.GetAllBoxes());
  const std::vector<vtkRelievoShadowLight> casting = GetStep(lights, center);
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
  this->Rays.SetSurfaces(work.Props.CollectSurfaces(false, this->Unfollowed));
  const vtkRelievoShadowScene scene = GetScene(work, view);
  this->TakeSamples(view,
    std::max(first, view.Parallel ? 2.0 * view.Near - view.Far : 1e-9 * view.Near),
    GetPart(scene.Receivers, scene.WorldToNDC));
  vtkRelievoShadowCache even;
  even.Update(casting, scene, *vtkRelievoShadowMethod::Make(vtkRelievoShadowPass::METHOD_MAP));
  this->Maps = even.GetNumberOfMaps();
  this->Even = this->Ask(even, work.Bias);
  this->Warped = this->Even;
  if (std::any_of(casting.begin(), casting.end(),
        [](const vtkRelievoShadowLight& light) { return !light.Positional; }))
  {
    vtkRelievoShadowCache warped;
    warped.Update(
      casting, scene, *vtkRelievoShadowMethod::Make(vtkRelievoShadowPass::METHOD_WARPED));
    this->Warped = this->Ask(warped, work.Bias);
  }
}

//------------------------------------------------------------------------------
// Places that face a light, at pixels that fill the part evenly (M. Roberts, The unreasonable
// effectiveness of quasirandom sequences, 2018).
void vtkRelievoShadowProbe::TakeSamples(
  const vtkRelievoView& view, double nearest, const glm::dvec4& part)
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
      const vtkRelievoCasterRays::Meeting seen = this->Rays.FindFirst(
        eye.From, eye.Ray, nearest);
      lost[i] = vtkRelievoMeetsAny(
        this->Unfollowed, center, eye.From, eye.Ray, seen.Surface < 0 ? 1e300 : seen.T);
      if (seen.Surface < 0 || lost[i] || !this->Rays.GetSurfaces()[seen.Surface].Receives)
      {
        return;
      }
      const glm::dvec3 place = eye.From + seen.T * eye.Ray;
      const double blur = vtkRelievoPlaceBlur * std::abs(seen.T) * glm::length(eye.Ray);
      for (std::size_t light = 0; light < this->Lights.size(); ++light)
      {
        const vtkRelievoToLight to(this->Lights[light], place, center);
        if (!to.Lights ||
          !(glm::dot(glm::normalize(seen.Normal), glm::normalize(to.Ray)) > vtkRelievoLeastFacing))
        {
          continue;
        }
        lost[i] = lost[i] || vtkRelievoMeetsAny(this->Unfollowed, center, place, to.Ray, to.Last);
        found[i].push_back({ place, seen, blur, static_cast<int>(light),
          this->Rays.Pass(place, to.Ray, to.Last, seen, blur) > 0.0 });
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
  this->Known =
    !this->Samples.empty() && unknown <= static_cast<long long>(this->Samples.size());
}

//------------------------------------------------------------------------------
vtkRelievoShadowProbe::Count vtkRelievoShadowProbe::Ask(
  const vtkRelievoShadowCache& cache, double bias) const
{
  struct Wrong
  {
    double At[Levels] = { 0.0, 0.0 };
  };
  std::vector<Wrong> wrong(this->Samples.size());
  const glm::dvec3 center = this->Rays.GetCenter();
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(this->Samples.size()), [&](vtkIdType from, vtkIdType to) {
        for (vtkIdType i = from; i < to; ++i)
        {
          const Sample& sample = this->Samples[i];
          const auto& maps = cache.GetEntries()[sample.Light].Maps;
          // Outside of all maps nothing casts.
          const auto map = std::find_if(maps.begin(), maps.end(), [&](const auto& each) {
            glm::dvec2 at;
            return Project(each.View, sample.Place + center, at);
          });
          if (map != maps.end())
          {
            this->AddWrong(sample, map->View, bias, wrong[i].At);
          }
        }
      });
  });
  Count count;
  count.Asked = static_cast<double>(wrong.size());
  for (const Wrong& each : wrong)
  {
    for (int level = 0; level < Levels; ++level)
    {
      count.Wrong[level] += each.At[level];
    }
  }
  return count;
}

//------------------------------------------------------------------------------
// In each of the coarse maps, the share of places of its grid for which the verdict is wrong.
void vtkRelievoShadowProbe::AddWrong(const Sample& sample, const vtkRelievoShadowView& view,
  double bias, double (&wrong)[Levels]) const
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
  // How the map's coordinates change along the receiver's plane.
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
    wrong[level] += sum / Phases;
  }
}

//------------------------------------------------------------------------------
double vtkRelievoShadowProbe::GetWrongShare(int size, bool warped) const
{
  const Count& count = warped ? this->Warped : this->Even;
  const double asked = std::max(1.0, count.Asked);
  const double ratio = static_cast<double>(Sides[1]) / Sides[0];
  // Half a pixel more than were seen: nothing seen is not nothing there.
  const double coarse = (count.Wrong[0] + 0.5 * std::pow(ratio, Power)) / asked;
  const double fine = (count.Wrong[1] + 0.5) / asked;
  // Most of what is known comes from the coarser map, as long as the law holds.
  const double both =
    (count.Wrong[0] + count.Wrong[1] + 0.5) / (asked * (1.0 + std::pow(ratio, Power)));
  const double share = std::max(both, fine);
  const double found = std::log(coarse / fine) / std::log(ratio);
  const double power = std::min(Power, std::max(LeastPower, found + 0.3));
  return std::min(
    1.0, WrongOfCounted * share * std::pow(static_cast<double>(size) / Sides[1], -power));
}
