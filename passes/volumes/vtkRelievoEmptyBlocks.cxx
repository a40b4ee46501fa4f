// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEmptyBlocks.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoVolumeImages.h"
#include "vtkRelievoVolumeSplice.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int SmallestSide = 3; // of a block, in voxels
constexpr int MostBlocks = 128; // along an axis
constexpr int Farthest = 255;   // distance in blocks

// Why samples of a transparent value may change the picture, or an empty string.
std::string WhyInFull(
  vtkOpenGLGPUVolumeRayCastMapper* mapper, vtkVolume* volume, vtkDataArray* values)
{
  vtkVolumeProperty* property = volume->GetProperty();
  vtkShaderProperty* shader = volume->GetShaderProperty();
  if (volume->IsA("vtkMultiVolume"))
  {
    return "a vtkMultiVolume mixes its volumes";
  }
  if (!vtkImageData::SafeDownCast(mapper->GetDataSetInput()) || !values)
  {
    return "its data are no image";
  }
  if (values->GetNumberOfComponents() != 1)
  {
    return "its values have several components";
  }
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return "its blend mode is not composite";
  }
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "its transfer function is two-dimensional";
  }
  if (mapper->GetMaskInput() &&
    mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType)
  {
    return "its mask has labels with transfer functions of their own";
  }
  if (mapper->GetScalarOpacityRangeType() != vtkGPUVolumeRayCastMapper::SCALAR)
  {
    return "its opacities are not those of the data's range";
  }
  if (shader->HasFragmentShaderCode() || shader->GetNumberOfShaderReplacements() > 0)
  {
    return "it has custom shader code";
  }
  if (vtkRelievoVolumeSplice::HasPartitions(mapper))
  {
    return "it is drawn in partitions";
  }
  return std::string();
}

// The greatest value that the data's type, or the data, may have in VTK's texture, which bounds the
// rounding of the shader.
double GetLargest(vtkDataArray* values, const double range[2])
{
  const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
  const bool small = values->GetDataTypeSize() <= 2;
  return small ? std::max(largest, values->GetDataTypeMax()) : largest;
}
}

//------------------------------------------------------------------------------
vtkRelievoEmptyBlocks::~vtkRelievoEmptyBlocks() = default;

//------------------------------------------------------------------------------
std::string vtkRelievoEmptyBlocks::Update(vtkOpenGLGPUVolumeRayCastMapper* mapper,
  vtkVolume* volume, double leastShare, vtkOpenGLRenderWindow* window)
{
  vtkDataSet* data = mapper->GetDataSetInput();
  int cells = 0;
  vtkDataArray* values = vtkAbstractMapper::GetScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells);
  const std::string why = WhyInFull(mapper, volume, values);
  if (!why.empty())
  {
    return why;
  }
  int points[3];
  vtkImageData::SafeDownCast(data)->GetDimensions(points);
  const glm::ivec3 size = glm::ivec3(points[0], points[1], points[2]) - (cells ? 1 : 0);
  if (static_cast<vtkIdType>(size.x) * size.y * size.z != values->GetNumberOfTuples())
  {
    return "its array has the wrong length";
  }
  // VTK loads its texture again if one of the two was modified.
  const vtkMTimeType time = std::max(values->GetMTime(), data->GetMTime());
  const bool changed = values != this->Values || time != this->Time || size != this->Size;
  if (changed)
  {
    this->Values = values;
    this->Time = time;
    this->Size = size;
    this->Side =
      std::max(SmallestSide, (std::max({ size.x, size.y, size.z }) + MostBlocks - 1) / MostBlocks);
    this->Blocks = (size + this->Side - 1) / this->Side;
    const auto number = static_cast<std::size_t>(this->Blocks.x) * this->Blocks.y * this->Blocks.z;
    this->Lows.assign(number, std::numeric_limits<double>::infinity());
    this->Highs.assign(number, -std::numeric_limits<double>::infinity());
    values->GetFiniteRange(this->Range);
    switch (values->GetDataType())
    {
      vtkTemplateMacro(this->FindRanges(static_cast<const VTK_TT*>(values->GetVoidPointer(0))));
      default:
        this->Values = nullptr;
        return "its values are no numbers";
    }
  }
  if (!(this->Range[0] < this->Range[1]))
  {
    return "all of its values are equal";
  }
  // VTK's table, which a step's length changes only where it is not 0: see vtkRelievoVolumeMarch.
  vtkPiecewiseFunction* function = volume->GetProperty()->GetScalarOpacity();
  const int needed = function->EstimateMinNumberOfSamples(this->Range[0], this->Range[1]);
  const int most = std::max(1024, vtkTextureObject::GetMaximumTextureSize(window));
  std::vector<double> opacities(std::min(most, std::max(1024, vtkMath::NearestPowerOfTwo(needed))));
  function->GetTable(
    this->Range[0], this->Range[1], static_cast<int>(opacities.size()), opacities.data());
  if (changed || opacities != this->Opacities)
  {
    this->Opacities = opacities;
    this->FindEmpty();
    this->Release();
  }
  if (this->Empty == 0)
  {
    return "no part of it is transparent";
  }
  if (static_cast<double>(this->Empty) < leastShare * static_cast<double>(this->GetNumber()))
  {
    return "too few of its blocks are transparent to save time";
  }
  return this->Texture ? std::string() : this->Upload(window);
}

//------------------------------------------------------------------------------
template <typename Value>
void vtkRelievoEmptyBlocks::FindRanges(const Value* values)
{
  vtkRelievoForAll(this->Blocks.z,
    [&](vtkIdType slab) { this->FindRangesOfSlab(values, static_cast<int>(slab)); });
}

//------------------------------------------------------------------------------
// Each row of voxels has ranges along x, which are added to the blocks that it is in or next to.
template <typename Value>
void vtkRelievoEmptyBlocks::FindRangesOfSlab(const Value* values, int slab)
{
  const int lowest = std::max(0, slab * this->Side - 1);
  const int highest = std::min(this->Size.z - 1, (slab + 1) * this->Side);
  for (int z = lowest; z <= highest; ++z)
  {
    for (int y = 0; y < this->Size.y; ++y)
    {
      const Value* row = values + this->Size.x * (y + static_cast<vtkIdType>(this->Size.y) * z);
      const int first = std::max(0, (y - 1) / this->Side);
      const int last = std::min(this->Blocks.y - 1, (y + 1) / this->Side);
      for (int block = 0; block < this->Blocks.x; ++block)
      {
        const int end = std::min(this->Size.x - 1, (block + 1) * this->Side);
        int x = std::max(0, block * this->Side - 1);
        Value low = row[x];
        Value high = low;
        bool numbers = true;
        for (; x <= end; ++x)
        {
          numbers = numbers && row[x] - row[x] == 0; // not infinite, nor NaN
          low = row[x] < low ? row[x] : low;
          high = row[x] > high ? row[x] : high;
        }
        // VTK's texture has no defined value near a voxel that is not a finite number.
        const double least =
          numbers ? static_cast<double>(low) : -std::numeric_limits<double>::infinity();
        const double greatest =
          numbers ? static_cast<double>(high) : std::numeric_limits<double>::infinity();
        for (int j = first; j <= last; ++j)
        {
          const std::size_t at =
            block + this->Blocks.x * (j + static_cast<std::size_t>(this->Blocks.y) * slab);
          this->Lows[at] = std::min(this->Lows[at], least);
          this->Highs[at] = std::max(this->Highs[at], greatest);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEmptyBlocks::FindEmpty()
{
  // How many opacities before each are not 0.
  const auto width = static_cast<int>(this->Opacities.size());
  std::vector<int> visible(width + 1, 0);
  for (int i = 0; i < width; ++i)
  {
    visible[i + 1] = visible[i] + (this->Opacities[i] != 0.0 ? 1 : 0);
  }
  // Texels of the table between which a value lies, without an offset of half a texel; the shader's
  // floats round.
  const double stretch = vtkRelievoVolumeImages::GetStretch(this->Values);
  const double across = this->Range[1] - this->Range[0];
  const double slack = 0.05 + width * 4e-7 * GetLargest(this->Values, this->Range) / across;
  const auto texel = [&](double value, double off) {
    const double place = std::floor((value - this->Range[0]) / across * width - 0.5 + off);
    return static_cast<int>(glm::clamp(place, 0.0, width - 1.0));
  };
  const glm::ivec3& n = this->Blocks;
  this->Distances.resize(this->Lows.size());
  this->Empty = 0;
  for (std::size_t i = 0; i < this->Lows.size(); ++i)
  {
    const int first = texel(std::min(this->Lows[i], this->Lows[i] * stretch), -slack);
    const int last = texel(std::max(this->Highs[i], this->Highs[i] * stretch), slack + 1.0);
    const bool empty = visible[last + 1] == visible[first];
    this->Distances[i] = empty ? Farthest : 0;
    this->Empty += empty ? 1 : 0;
  }
  // Chessboard distances, in two sweeps.
  const auto sweep = [&](int by) {
    const auto order = [by](int i, int count) { return by > 0 ? i : count - 1 - i; };
    for (int c = 0; c < n.z; ++c)
    {
      for (int b = 0; b < n.y; ++b)
      {
        for (int a = 0; a < n.x; ++a)
        {
          const glm::ivec3 at(order(a, n.x), order(b, n.y), order(c, n.z));
          unsigned char& distance = this->Distances[at.x + n.x * (at.y + n.y * at.z)];
          for (int i = 0; i < 13 && distance > 1; ++i)
          {
            const glm::ivec3 next = at + by * glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (glm::all(glm::greaterThanEqual(next, glm::ivec3(0))) &&
              glm::all(glm::lessThan(next, n)))
            {
              const int farther = this->Distances[next.x + n.x * (next.y + n.y * next.z)] + 1;
              distance = static_cast<unsigned char>(std::min<int>(distance, farther));
            }
          }
        }
      }
    }
  };
  sweep(1);
  sweep(-1);
}

//------------------------------------------------------------------------------
std::string vtkRelievoEmptyBlocks::Upload(vtkOpenGLRenderWindow* window)
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
  GLint others = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_3D, &others);
  if (!this->Texture)
  {
    glGenTextures(1, &this->Texture);
  }
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glBindTexture(GL_TEXTURE_3D, this->Texture);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, this->Blocks.x, this->Blocks.y, this->Blocks.z, 0, GL_RED,
    GL_UNSIGNED_BYTE, this->Distances.data());
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
  const bool there = glGetError() == GL_NO_ERROR;
  glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(others));
  if (!there)
  {
    this->Release();
    return "this OpenGL has no memory for its blocks";
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoEmptyBlocks::SetUniforms(
  vtkShaderProgram* program, vtkOpenGLRenderWindow* window, int unit) const
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  glBindTexture(GL_TEXTURE_3D, this->Texture);
  state->vtkglActiveTexture(GL_TEXTURE0);
  const glm::vec3 scale = glm::vec3(this->Size) / static_cast<float>(this->Side);
  program->SetUniformi("relievoEmptyBlocks", unit);
  program->SetUniform3f("relievoEmptyScale", &scale[0]);
}

//------------------------------------------------------------------------------
void vtkRelievoEmptyBlocks::Release()
{
  if (this->Texture)
  {
    glDeleteTextures(1, &this->Texture);
    this->Texture = 0;
  }
}
