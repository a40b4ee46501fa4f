// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeShade.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoVolumeExchange.h"
#include "vtkRelievoVolumeExtinction.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
// Textures grow in these steps, so that a moving light seldom needs another one.
constexpr int Step = 32;

// Half floats end at 65504, and filters make NaN of infinite texels.
constexpr float Deepest = vtkRelievoOpticalDepths::Deepest;

// Numbers of nodes that are chosen for goals.
const int NodeCounts[] = { 32, 64, 128, 256, 512, 1024 };
// Estimates have errors: they must be this much below a tolerance.
constexpr double Margin = 1.2;
constexpr int FewestPlaces = 256; // of an estimate
constexpr int MostPlaces = 4096;
// Time of a node on common machines, until a grid has been timed.
constexpr double UsualMilliseconds = 3e-5;

int RoundUp(int size)
{
  return (size + Step - 1) / Step * Step;
}

double CountNodes(const vtkRelievoOpticalDepths::Extent& extent,
  const vtkRelievoOpticalDepths::Source& source, int most)
{
  vtkRelievoOpticalDepths depths;
  depths.Lay(extent, source, most);
  const glm::dvec3 size(depths.GetSize());
  return size.x * size.y * size.z;
}

// To detect errors of the calls that follow.
void ClearErrors()
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoVolumeShade::vtkRelievoVolumeShade()
  : Exchange(std::make_unique<vtkRelievoVolumeExchange>(nullptr))
{
}

//------------------------------------------------------------------------------
vtkRelievoVolumeShade::~vtkRelievoVolumeShade()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeShade::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Exchange->GetController())
  {
    this->Exchange = std::make_unique<vtkRelievoVolumeExchange>(controller);
    this->State.clear();
  }
}

//------------------------------------------------------------------------------
// Processes take the settings and lights of the first one: their grids have to be equal.
void vtkRelievoVolumeShade::TakeFirst(std::vector<vtkRelievoOpticalDepths::Source>& sources)
{
  std::vector<double> numbers = { static_cast<double>(this->Nodes),
    static_cast<double>(this->Harmonics), this->Goals.Tolerance, this->Goals.Milliseconds,
    this->MostBytes };
  for (const vtkRelievoOpticalDepths::Source& source : sources)
  {
    const glm::dvec3& place = source.Position;
    const glm::dvec3& way = source.Direction;
    numbers.insert(numbers.end(),
      { source.Positional ? 1.0 : 0.0, place.x, place.y, place.z, way.x, way.y, way.z });
  }
  this->Exchange->TakeFirst(numbers);
  this->Nodes = static_cast<int>(numbers[0]);
  this->Harmonics = static_cast<int>(numbers[1]);
  this->Goals = { numbers[2], numbers[3] };
  this->MostBytes = numbers[4];
  const double* from = numbers.data() + 5;
  for (vtkRelievoOpticalDepths::Source& source : sources)
  {
    source.Positional = from[0] != 0.0;
    source.Position = glm::dvec3(from[1], from[2], from[3]);
    source.Direction = glm::dvec3(from[4], from[5], from[6]);
    from += 7;
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoVolumeShade::Update(
  vtkOpenGLRenderWindow* window, std::vector<vtkRelievoOpticalDepths::Source> sources)
{
  if (this->Exchange->IsOn())
  {
    this->TakeFirst(sources);
  }
  this->Made = 0;
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
    this->Owner = window;
  }
  GLint limit = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
  const int lights = static_cast<int>(sources.size());
  const int room = this->Exchange->GetLeast(limit / Step / std::max(1, lights) * Step - Step);
  std::vector<std::uint64_t> state;
  for (const vtkRelievoPlacedVolume& volume : this->Casters)
  {
    volume.AddState(this->Colored, state);
  }
  // Goals in a millionth and in microseconds.
  for (const double setting : { static_cast<double>(room), static_cast<double>(this->Nodes),
         1e6 * this->Goals.Tolerance, 1e3 * this->Goals.Milliseconds, this->Colored ? 1.0 : 0.0,
         static_cast<double>(this->Harmonics) })
  {
    state.push_back(static_cast<std::uint64_t>(setting));
  }
  const bool changed = this->Exchange->IsAnywhere(state != this->State);
  if (!changed && !this->Fault.empty() && sources == this->Sources)
  {
    return this->Fault; // refused before
  }
  const bool all = changed || !this->Fault.empty();
  this->Fault.clear();
  if (all)
  {
    this->State = state;
    this->Fields.clear();
    this->NotTraced.clear();
    for (const vtkRelievoPlacedVolume& volume : this->Casters)
    {
      std::string why;
      for (const vtkRelievoVolumeExtinction& field :
        vtkRelievoVolumeExtinction::Collect(volume, why, this->Colored))
      {
        this->Fields.push_back(field);
      }
      this->NotTraced += why.empty() ? std::string() : "; a volume casts none: " + why;
    }
    this->Extent =
      this->Exchange->Join(vtkRelievoOpticalDepths::GetExtent(this->Fields), this->Others);
    if (this->Exchange->IsOn()) // another process's volumes may have changed
    {
      this->Shares.clear();
      this->Chosen = 0;
    }
  }
  if (this->Extent.Corners.empty() || sources.empty())
  {
    const std::string notTraced = this->NotTraced;
    this->Release(window);
    this->State = state;
    this->NotTraced = notTraced;
    return std::string();
  }
  const auto refuse = [&](const std::string& fault) {
    this->Release(window);
    this->State = state;
    this->Sources = sources;
    this->Fault = fault;
    return fault;
  };
  if (room < Step)
  {
    return refuse("this OpenGL has no room for the depths of volumes towards " +
      std::to_string(lights) + " lights");
  }
  this->Tinted = this->Extent.Tinted;
  const int most = this->ChooseNodes(sources, room);
  const bool resized = most != this->NodesMade;
  this->NodesMade = most;
  const double bytes = this->CountBytes(sources, most);
  if (bytes > this->MostBytes)
  {
    return refuse("the depths of volumes would take " +
      std::to_string(static_cast<long long>(bytes / 1048576.0)) + " MiB, more than " +
      std::to_string(static_cast<long long>(this->MostBytes / 1048576.0)) +
      (this->Goals.IsSet() ? "; let fewer lights cast shadows"
                           : "; lower volume_nodes, which is " + std::to_string(most)));
  }
  std::vector<std::size_t> made;
  const auto began = std::chrono::steady_clock::now();
  this->Depths.resize(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    if (all || resized || i >= this->Sources.size() || !(this->Sources[i] == sources[i]))
    {
      this->MakeDepths(sources[i], i);
      made.push_back(i);
    }
  }
  this->Sources = sources;
  if (this->Exchange->IsAnywhere(this->Allocate(lights)))
  {
    // The new texture is empty.
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      if (std::find(made.begin(), made.end(), i) == made.end())
      {
        this->MakeDepths(sources[i], i);
        made.push_back(i);
      }
    }
  }
  this->Made = static_cast<int>(made.size());
  double nodes = 0.0;
  for (const std::size_t light : made)
  {
    const glm::dvec3 size(this->Depths[light].GetSize());
    nodes += size.x * size.y * size.z;
  }
  if (nodes > 0.0 && this->Harmonics == 0)
  {
    const auto took = std::chrono::steady_clock::now() - began;
    const double each = std::chrono::duration<double, std::milli>(took).count() / nodes;
    const bool first = all || this->MillisecondsPerNode == 0.0;
    this->MillisecondsPerNode = first ? each : std::min(this->MillisecondsPerNode, each);
  }
  const bool loaded = this->Texture &&
    std::all_of(
      made.begin(), made.end(), [this](std::size_t light) { return this->Upload(light); });
  if (!this->Exchange->IsEverywhere(loaded))
  {
    return refuse("this OpenGL has no memory for the depths of volumes towards lights");
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeShade::MakeDepths(
  const vtkRelievoOpticalDepths::Source& source, std::size_t light)
{
  vtkRelievoOpticalDepths& depths = this->Depths[light];
  depths.Lay(this->Extent, source, this->NodesMade, this->Harmonics);
  depths.Fill(this->Fields, this->Tinted);
  this->Exchange->Add(depths.GetDepths().data(), depths.GetDepths().size());
  if (this->Tinted)
  {
    this->Exchange->Add(&depths.GetTints()[0].x, 3 * depths.GetTints().size());
  }
}

//------------------------------------------------------------------------------
// The fewest nodes that meet the tolerance, but not more than there is time and memory for. The
// choice keeps while nothing changes, though the measured time does: one picture has one grid.
int vtkRelievoVolumeShade::ChooseNodes(
  const std::vector<vtkRelievoOpticalDepths::Source>& sources, int limit)
{
  if (!this->Goals.IsSet())
  {
    this->WrongShare = -1.0;
    return std::min(this->Nodes, limit);
  }
  const bool same = this->SourcesVary ? this->ChosenSources.size() == sources.size()
                                      : this->ChosenSources == sources;
  if (this->Chosen > 0 && this->ChosenState == this->State && same)
  {
    return this->Chosen;
  }
  this->ChosenState = this->State;
  this->ChosenSources = sources;
  int chosen = std::min(this->Nodes, limit);
  if (this->Goals.Tolerance > 0.0)
  {
    this->EstimateShares(limit);
    chosen = this->Exchange->GetMost(this->Shares.back().first);
  }
  if (this->Goals.Milliseconds > 0.0)
  {
    const double each =
      this->MillisecondsPerNode > 0.0 ? this->MillisecondsPerNode : UsualMilliseconds;
    int fast = NodeCounts[0];
    for (const int count : NodeCounts)
    {
      double nodes = 0.0;
      for (const vtkRelievoOpticalDepths::Source& source : sources)
      {
        nodes += CountNodes(this->Extent, source, count);
      }
      fast = each * nodes <= this->Goals.Milliseconds ? count : fast;
    }
    chosen = std::min(this->Exchange->GetLeast(fast), chosen);
  }
  while (chosen > NodeCounts[0] && this->CountBytes(sources, chosen) > this->MostBytes)
  {
    chosen /= 2;
  }
  this->WrongShare = -1.0;
  for (const auto& share : this->Goals.Tolerance > 0.0 ? this->Shares : Estimates())
  {
    this->WrongShare = share.first == chosen ? share.second : this->WrongShare;
  }
  this->Chosen = chosen;
  return chosen;
}

//------------------------------------------------------------------------------
// Bytes of the texture, which has room for the largest grid along each axis, for every light.
double vtkRelievoVolumeShade::CountBytes(
  const std::vector<vtkRelievoOpticalDepths::Source>& sources, int most) const
{
  glm::dvec3 size(0.0);
  for (const vtkRelievoOpticalDepths::Source& source : sources)
  {
    vtkRelievoOpticalDepths depths;
    depths.Lay(this->Extent, source, most, this->Harmonics);
    for (int i = 0; i < 3; ++i)
    {
      size[i] = std::max<double>(size[i], RoundUp(depths.GetStored()[i]));
    }
  }
  return 2.0 * this->GetChannels() * size.x * size.y * size.z * static_cast<double>(sources.size());
}

//------------------------------------------------------------------------------
// For the light of a sun from an oblique direction, so that the choice does not change while lights
// move. The last one is small enough, or the best.
void vtkRelievoVolumeShade::EstimateShares(int limit)
{
  // Estimates stay when the volumes only move together.
  std::vector<std::uint64_t> state = { static_cast<std::uint64_t>(limit), this->Colored ? 1u : 0u,
    static_cast<std::uint64_t>(1e6 * this->Goals.Tolerance) };
  for (vtkRelievoPlacedVolume volume : this->Casters)
  {
    volume.ToWorld[3] -= glm::dvec4(glm::dvec3(this->Casters[0].ToWorld[3]), 0.0);
    volume.AddState(this->Colored, state);
  }
  if (!this->Shares.empty() && state == this->SharesState)
  {
    return;
  }
  this->Shares.clear();
  this->SharesState = state;
  vtkRelievoOpticalDepths::Source source;
  source.Direction = glm::normalize(glm::dvec3(-0.31, -0.83, -0.47));
  // A share is found by at least a few wrong places.
  const int places = static_cast<int>(
    std::min<double>(std::max<double>(4.0 / this->Goals.Tolerance, FewestPlaces), MostPlaces));
  glm::ivec3 before(0);
  for (const int count : NodeCounts)
  {
    vtkRelievoOpticalDepths depths;
    depths.Lay(this->Extent, source, count);
    if (!this->Shares.empty() && (count > limit || depths.GetSize() == before))
    {
      break; // there are no more nodes than voxels
    }
    before = depths.GetSize();
    const double share = depths.EstimateWrongShare(this->Fields, source, Slack, places);
    this->Shares.emplace_back(std::min(count, limit), std::max(share, 0.0));
    if (share * Margin <= this->Goals.Tolerance)
    {
      break;
    }
  }
}

//------------------------------------------------------------------------------
// Returns whether the texture is a new one, and empty; 0 if there is no memory.
bool vtkRelievoVolumeShade::Allocate(int lights)
{
  int size[3] = { 0, 0, 0 };
  for (const vtkRelievoOpticalDepths& depths : this->Depths)
  {
    for (int i = 0; i < 3; ++i)
    {
      size[i] = std::max(size[i], RoundUp(depths.GetStored()[i]));
    }
  }
  // A size that would do keeps: maps of a light that turns need more and less.
  const bool fits = this->Texture && this->Channels == this->GetChannels() &&
    this->Slices * lights <= this->Size[2] && size[0] <= this->Size[0] &&
    size[1] <= this->Size[1] && size[2] <= this->Slices && this->Slices <= 2 * size[2] &&
    this->Size[2] <= 2 * this->Slices * lights;
  if (fits)
  {
    return false;
  }
  if (this->Texture)
  {
    glDeleteTextures(1, &this->Texture);
    this->Texture = 0;
  }
  this->Channels = this->GetChannels();
  this->Slices = size[2];
  std::copy(size, size + 3, this->Size);
  this->Size[2] *= lights;
  ClearErrors();
  GLint others = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_3D, &others);
  glGenTextures(1, &this->Texture);
  glBindTexture(GL_TEXTURE_3D, this->Texture);
  glTexImage3D(GL_TEXTURE_3D, 0, this->Tinted ? GL_RGBA16F : GL_R16F, this->Size[0], this->Size[1],
    this->Size[2], 0, this->Tinted ? GL_RGBA : GL_RED, GL_FLOAT, nullptr);
  const bool there = glGetError() == GL_NO_ERROR;
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(others));
  if (!there)
  {
    glDeleteTextures(1, &this->Texture);
    this->Texture = 0;
  }
  return true;
}

//------------------------------------------------------------------------------
// A node that a grid does not reach equals its last one: filters reach it by rounding.
bool vtkRelievoVolumeShade::Upload(std::size_t light)
{
  vtkRelievoOpticalDepths& depths = this->Depths[light];
  const glm::ivec3 size = depths.GetStored();
  const glm::ivec3 padded =
    glm::min(size + 1, glm::ivec3(this->Size[0], this->Size[1], this->Slices));
  const int channels = this->GetChannels();
  std::vector<float> texels(static_cast<std::size_t>(padded.x) * padded.y * channels);
  const bool tinted = !depths.GetTints().empty();
  ClearErrors();
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  GLint others = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_3D, &others);
  glBindTexture(GL_TEXTURE_3D, this->Texture);
  for (int k = 0; k < padded.z; ++k)
  {
    auto to = texels.begin();
    for (int j = 0; j < padded.y; ++j)
    {
      for (int i = 0; i < padded.x; ++i)
      {
        const glm::ivec3 at = glm::min(glm::ivec3(i, j, k), size - 1);
        const std::size_t node = at.x + size.x * (at.y + size.y * static_cast<std::size_t>(at.z));
        for (int color = 0; color < channels - 1; ++color)
        {
          *to++ = tinted ? std::min(depths.GetTints()[node][color], Deepest) : 0.f;
        }
        *to++ = std::min(depths.GetDepths()[node], Deepest);
      }
    }
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, static_cast<GLint>(light) * this->Slices + k, padded.x,
      padded.y, 1, channels > 1 ? GL_RGBA : GL_RED, GL_FLOAT, texels.data());
  }
  const bool there = glGetError() == GL_NO_ERROR;
  glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(others));
  depths.ReleaseNodes();
  return there;
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeShade::Bind()
{
  if (!this->Texture)
  {
    return true;
  }
  vtkOpenGLState* state = this->Window->GetState();
  if (this->Unit < 0)
  {
    this->Unit = state->GetTextureUnitManager()->Allocate();
  }
  if (this->Unit < 0)
  {
    return false;
  }
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_3D, this->Texture);
  state->vtkglActiveTexture(GL_TEXTURE0);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeShade::Unbind()
{
  if (this->Unit >= 0 && this->Window)
  {
    vtkOpenGLState* state = this->Window->GetState();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(GL_TEXTURE_3D, 0);
    state->vtkglActiveTexture(GL_TEXTURE0);
    state->GetTextureUnitManager()->Free(this->Unit);
  }
  this->Unit = -1;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeShade::SetUniforms(
  vtkShaderProgram* program, const glm::dmat4& placeToWorld) const
{
  std::vector<glm::mat4> matrices;
  std::vector<glm::vec4> sizes;
  std::vector<glm::vec3> spreads;
  for (const vtkRelievoOpticalDepths& depths : this->Depths)
  {
    const glm::dmat4 rows = glm::transpose(depths.GetWorldToMap());
    const double slices = this->Spreads[spreads.size()] / glm::length(glm::dvec3(rows[2]));
    spreads.emplace_back(slices * glm::length(glm::dvec3(rows[0])),
      slices * glm::length(glm::dvec3(rows[1])), 0.5 * (depths.GetSize().z - 1));
    matrices.emplace_back(depths.GetWorldToMap() * placeToWorld);
    sizes.emplace_back(glm::vec3(depths.GetSize()), depths.IsAround() ? 1.f : 0.f);
  }
  const int lights = static_cast<int>(matrices.size());
  const float size[3] = { static_cast<float>(this->Size[0]), static_cast<float>(this->Size[1]),
    static_cast<float>(this->Size[2]) };
  program->SetUniformi("relievoVolumeDepths", this->Unit);
  program->SetUniformMatrix4x4v("relievoVolumeMatrix", lights, &matrices[0][0][0]);
  program->SetUniform4fv(
    "relievoVolumeSize", lights, reinterpret_cast<const float(*)[4]>(&sizes[0].x));
  if (this->IsSpread())
  {
    program->SetUniform3fv(
      "relievoVolumeSpread", lights, reinterpret_cast<const float(*)[3]>(&spreads[0].x));
  }
  program->SetUniform3f("relievoVolumeTexture", size);
  program->SetUniformf("relievoVolumeSlices", static_cast<float>(this->Slices));
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeShade::GetNodeDistance() const
{
  double across = 0.0;
  for (const glm::dvec3& corner : this->Extent.Corners)
  {
    across = std::max(across, glm::length(corner - this->Extent.Corners[0]));
  }
  return std::max(this->Extent.Spacing, 2.0 * across / std::max(1, this->NodesMade));
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeShade::IsAround() const
{
  return std::any_of(this->Depths.begin(), this->Depths.end(),
    [](const vtkRelievoOpticalDepths& depths) { return depths.IsAround(); });
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeShade::IsSpread() const
{
  return std::any_of(
    this->Spreads.begin(), this->Spreads.end(), [](double tangent) { return tangent > 0.0; });
}

//------------------------------------------------------------------------------
std::string vtkRelievoVolumeShade::GetReport() const
{
  std::ostringstream out;
  if (this->Texture)
  {
    const glm::ivec3& size = this->Depths[0].GetSize();
    out << ", depths of volumes in " << size.x << " x " << size.y;
    if (this->Harmonics > 0)
    {
      out << " rays of " << this->Depths[0].GetStored().z << " terms";
    }
    else
    {
      out << " x " << size.z << " nodes";
    }
    out << " for each light, " << this->Made << " made anew";
    if (this->Goals.IsSet())
    {
      out << ", at most " << this->NodesMade << " along an axis, chosen for the goal";
    }
    if (this->WrongShare >= 0.0)
    {
      out << ", expected share of places wrong by more than " << Slack << " "
          << std::setprecision(2) << 100.0 * this->WrongShare << " %";
    }
  }
  out << this->NotTraced;
  return out.str();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVolumeShade::GetBytes() const
{
  return this->Texture
    ? vtkIdType(2) * this->Channels * this->Size[0] * this->Size[1] * this->Size[2]
    : 0;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeShade::Release(vtkWindow* window)
{
  if (this->Texture && window && window == this->Owner)
  {
    this->Unbind();
    const vtkRelievoScopedContext context(window);
    glDeleteTextures(1, &this->Texture);
  }
  if (window == this->Owner || !this->Window)
  {
    this->Texture = 0;
    this->Unit = -1;
    this->Sources.clear();
    this->Depths.clear();
    this->Fields.clear();
    this->Extent = {};
    this->Others.clear();
    this->State.clear();
    this->NotTraced.clear();
    this->Fault.clear();
  }
}
