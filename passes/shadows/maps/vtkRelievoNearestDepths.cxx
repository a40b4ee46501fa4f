// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoNearestDepths.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkRelievoNearestDepths::Begin(int size, int layers)
{
  const int block = 1 << BlockPower;
  this->Size = size;
  this->Across = (size + block - 1) / block;
  this->Nearest.assign(this->CountBlocks() * static_cast<std::size_t>(layers), 0.f);
  this->Changed = true;
}

//------------------------------------------------------------------------------
void vtkRelievoNearestDepths::Set(int layer, const std::vector<float>& depths)
{
  if (this->Texels.GetTextureUnit() < 0)
  {
    this->Forget(layer);
    return;
  }
  const auto size = static_cast<std::size_t>(this->Size);
  const auto across = static_cast<std::size_t>(this->Across);
  float* blocks = this->Nearest.data() + this->CountBlocks() * static_cast<std::size_t>(layer);
  std::fill_n(blocks, this->CountBlocks(), 1.f);
  std::vector<float> least(size);
  for (std::size_t from = 0; from < size; from += std::size_t(1) << BlockPower)
  {
    std::fill(least.begin(), least.end(), 1.f);
    const std::size_t end = std::min(size, from + (std::size_t(1) << BlockPower));
    for (std::size_t y = from; y < end; ++y)
    {
      const float* row = depths.data() + y * size;
      for (std::size_t x = 0; x < size; ++x)
      {
        least[x] = std::min(least[x], row[x]);
      }
    }
    float* to = blocks + (from >> BlockPower) * across;
    for (std::size_t x = 0; x < size; ++x)
    {
      to[x >> BlockPower] = std::min(to[x >> BlockPower], least[x]);
    }
  }
  this->Changed = true;
}

//------------------------------------------------------------------------------
void vtkRelievoNearestDepths::Forget(int layer)
{
  std::fill_n(this->Nearest.data() + this->CountBlocks() * static_cast<std::size_t>(layer),
    this->CountBlocks(), 0.f);
  this->Changed = true;
}

//------------------------------------------------------------------------------
bool vtkRelievoNearestDepths::Bind(vtkOpenGLRenderWindow* window)
{
  if (this->Nearest.size() > vtkRelievoTextureBuffer::GetMostTexels())
  {
    return false;
  }
  if (!this->Texels.IsIn(window))
  {
    this->Texels.Allocate(window, this->Nearest.size(), 1);
    this->Changed = true;
  }
  this->Texels.Activate();
  return this->Texels.GetTextureUnit() >= 0;
}

//------------------------------------------------------------------------------
void vtkRelievoNearestDepths::Unbind()
{
  this->Texels.Deactivate();
}

//------------------------------------------------------------------------------
// The least of each block and of those within the radius, first along rows, then along columns.
void vtkRelievoNearestDepths::Spread(const float* from, int radius, float* to) const
{
  std::vector<float> rows(this->CountBlocks());
  const auto spread = [this, radius](const float* in, float* out, int step, int lineStep) {
    for (int line = 0; line < this->Across; ++line)
    {
      for (int i = 0; i < this->Across; ++i)
      {
        float least = 1.f;
        for (int j = std::max(0, i - radius); j <= std::min(this->Across - 1, i + radius); ++j)
        {
          least = std::min(least, in[line * lineStep + j * step]);
        }
        out[line * lineStep + i * step] = least;
      }
    }
  };
  spread(from, rows.data(), 1, this->Across);
  spread(rows.data(), to, this->Across, 1);
}

//------------------------------------------------------------------------------
void vtkRelievoNearestDepths::Update(
  vtkOpenGLRenderWindow* window, const std::vector<double>& reaches)
{
  if (!this->Changed && reaches == this->Reaches)
  {
    return;
  }
  std::vector<float> spread(this->Nearest.size());
  for (std::size_t layer = 0; layer < reaches.size(); ++layer)
  {
    // Both ends of a ray are rounded to a texel.
    const double blocks = std::ceil((reaches[layer] + 1.0) / (1 << BlockPower));
    const std::size_t first = layer * this->CountBlocks();
    this->Spread(this->Nearest.data() + first,
      static_cast<int>(std::min(blocks, static_cast<double>(this->Across))), &spread[first]);
  }
  this->Reaches = reaches;
  this->Changed = false;
  this->Texels.Upload(window, spread, 1);
}

//------------------------------------------------------------------------------
void vtkRelievoNearestDepths::Tell(vtkShaderProgram* program) const
{
  program->SetUniformi("relievoShadowNearest", this->Texels.GetTextureUnit());
  program->SetUniformi("relievoShadowBlocks", this->Across);
}

//------------------------------------------------------------------------------
void vtkRelievoNearestDepths::Release(vtkWindow* window)
{
  this->Texels.Release(window);
  this->Changed = true;
}
