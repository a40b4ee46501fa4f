// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMaterialMap.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
vtkDataArray* GetValues(vtkImageData* image)
{
  return image ? image->GetPointData()->GetScalars() : nullptr;
}

// Reduces by means over texels: taking every n-th texel would alias.
template <typename T>
std::vector<T> Reduce(const T* from, const int size[2], int components, int factor, int reduced[2])
{
  reduced[0] = std::max(1, size[0] / factor);
  reduced[1] = std::max(1, size[1] / factor);
  std::vector<T> out(static_cast<std::size_t>(reduced[0]) * reduced[1] * components);
  for (int y = 0; y < reduced[1]; ++y)
  {
    for (int x = 0; x < reduced[0]; ++x)
    {
      const int xEnd = std::min(size[0], (x + 1) * factor);
      const int yEnd = std::min(size[1], (y + 1) * factor);
      for (int c = 0; c < components; ++c)
      {
        double sum = 0.0;
        for (int j = y * factor; j < yEnd; ++j)
        {
          for (int i = x * factor; i < xEnd; ++i)
          {
            sum += from[(static_cast<std::size_t>(j) * size[0] + i) * components + c];
          }
        }
        const double mean = sum / ((xEnd - x * factor) * (yEnd - y * factor));
        out[(static_cast<std::size_t>(y) * reduced[0] + x) * components + c] =
          static_cast<T>(std::numeric_limits<T>::is_integer ? std::floor(mean + 0.5) : mean);
      }
    }
  }
  return out;
}
}

//------------------------------------------------------------------------------
vtkRelievoMaterialMap::~vtkRelievoMaterialMap()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
void vtkRelievoMaterialMap::SetImage(vtkImageData* image)
{
  this->Image = image;
  this->LoadTime = 0;
  this->FailTime = 0;
  this->LastFault.clear();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoMaterialMap::GetTime() const
{
  return std::max(this->Image->GetMTime(), GetValues(this->Image)->GetMTime());
}

//------------------------------------------------------------------------------
std::string vtkRelievoMaterialMap::GetFault() const
{
  vtkDataArray* values = GetValues(this->Image);
  if (!values || values->GetNumberOfTuples() == 0)
  {
    return "it has no scalars";
  }
  const int* size = this->Image->GetDimensions();
  const int components = values->GetNumberOfComponents();
  if (size[2] != 1 || components < this->LeastComponents || components > 4)
  {
    std::ostringstream out;
    out << "it has " << size[0] << " x " << size[1] << " x " << size[2] << " points of "
        << components << " components; one slice in z, of " << this->LeastComponents
        << " to 4 components, was expected";
    return out.str();
  }
  if (values->GetNumberOfTuples() != static_cast<vtkIdType>(size[0]) * size[1])
  {
    std::ostringstream out;
    out << "it has " << values->GetNumberOfTuples() << " values for " << size[0] << " x " << size[1]
        << " points; one for each was expected";
    return out.str();
  }
  return this->FailTime == this->GetTime() ? "OpenGL cannot make a texture of it" : "";
}

//------------------------------------------------------------------------------
std::string vtkRelievoMaterialMap::TakeFault()
{
  const std::string before = this->LastFault;
  this->LastFault = this->Image ? this->GetFault() : std::string();
  return this->LastFault != before ? this->LastFault : std::string();
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterialMap::IsFloat() const
{
  vtkDataArray* values = GetValues(this->Image);
  return values && values->GetDataType() != VTK_UNSIGNED_CHAR &&
    values->GetDataType() != VTK_UNSIGNED_SHORT;
}

//------------------------------------------------------------------------------
void vtkRelievoMaterialMap::GetRange(double range[2]) const
{
  range[0] = 0.0;
  range[1] = 1.0;
  if (this->IsFloat())
  {
    GetValues(this->Image)->GetFiniteRange(range, 0);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterialMap::Load(vtkOpenGLRenderWindow* window, bool repeat, std::string& remark)
{
  if (!window || !this->IsUsable())
  {
    return false;
  }
  vtkDataArray* values = GetValues(this->Image);
  const vtkMTimeType time = this->GetTime();
  if (this->IsLoaded() && this->Window == window && this->LoadTime == time &&
    this->Repeat == repeat)
  {
    return true;
  }
  const int* size = this->Image->GetDimensions();
  const int components = values->GetNumberOfComponents();
  this->Release(this->Window);
  this->Window = window;
  int type = values->GetDataType();
  const void* data = values->GetVoidPointer(0);
  std::vector<float> floats;
  bool unknown = false;
  if (this->IsFloat())
  {
    // Unknown values get the least known value, so that mipmaps do not spread holes.
    double range[2];
    this->GetRange(range);
    floats.resize(static_cast<std::size_t>(values->GetNumberOfTuples()) * components);
    for (std::size_t i = 0; i < floats.size(); ++i)
    {
      const double value = values->GetComponent(
        static_cast<vtkIdType>(i / components), static_cast<int>(i % components));
      unknown = unknown || !std::isfinite(value);
      floats[i] = static_cast<float>(std::isfinite(value) ? value : range[0]);
    }
    data = floats.data();
    type = VTK_FLOAT;
  }
  if (unknown)
  {
    remark = "values that are not finite are replaced by the least finite one";
  }
  this->Size[0] = size[0];
  this->Size[1] = size[1];
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  const int factor = (std::max(size[0], size[1]) + limit - 1) / limit;
  std::vector<unsigned char> bytes;
  std::vector<unsigned short> shorts;
  if (factor > 1)
  {
    if (type == VTK_UNSIGNED_CHAR)
    {
      bytes = Reduce(static_cast<const unsigned char*>(data), size, components, factor, this->Size);
      data = bytes.data();
    }
    else if (type == VTK_UNSIGNED_SHORT)
    {
      shorts =
        Reduce(static_cast<const unsigned short*>(data), size, components, factor, this->Size);
      data = shorts.data();
    }
    else
    {
      floats = Reduce(static_cast<const float*>(data), size, components, factor, this->Size);
      data = floats.data();
    }
    std::ostringstream out;
    out << size[0] << " x " << size[1] << " texels are more than this OpenGL's " << limit
        << ": reduced to " << this->Size[0] << " x " << this->Size[1];
    remark = out.str();
  }
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  const int wrap = repeat ? vtkTextureObject::Repeat : vtkTextureObject::ClampToEdge;
  this->Texture->SetWrapS(wrap);
  this->Texture->SetWrapT(wrap);
  this->Texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  // VTK makes no mipmaps of raw values, so they are made below.
  const int longest = std::max(this->Size[0], this->Size[1]);
  this->Texture->SetMaxLevel(static_cast<int>(std::floor(std::log2(longest))));
  if (!this->Texture->Create2DFromRaw(static_cast<unsigned int>(this->Size[0]),
        static_cast<unsigned int>(this->Size[1]), components, type, const_cast<void*>(data)))
  {
    this->FailTime = time;
    this->Texture = nullptr;
    return false;
  }
  this->Texture->Activate();
  glGenerateMipmap(GL_TEXTURE_2D);
  this->Texture->Deactivate();
  const vtkIdType texels = static_cast<vtkIdType>(this->Size[0]) * this->Size[1];
  const int each = type == VTK_UNSIGNED_CHAR ? 1 : type == VTK_UNSIGNED_SHORT ? 2 : 4;
  this->Bytes = texels * components * each * 4 / 3; // including mipmaps
  this->LoadTime = time;
  this->Repeat = repeat;
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterialMap::IsLoaded() const
{
  // A finalized window has freed its textures.
  return this->Texture && this->Texture->GetHandle() != 0;
}

//------------------------------------------------------------------------------
int vtkRelievoMaterialMap::Activate()
{
  this->Texture->Activate();
  return this->Texture->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterialMap::Deactivate()
{
  if (this->Texture && this->Window)
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterialMap::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return;
  }
  if (this->Texture && window)
  {
    this->Texture->ReleaseGraphicsResources(window);
  }
  this->Texture = nullptr;
  this->Bytes = 0;
  this->LoadTime = 0;
}
