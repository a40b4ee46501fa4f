// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerReader.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoArraySampler.h"
#include "vtkRelievoDepthRefiner.h"
#include "vtkRelievoDrawTable.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoImageMemory.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoRows.h"
#include "vtkRelievoWordDecoder.h"
#include "vtkRelievoWordFormats.h"
#include "vtkRelievoWordSource.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
using relievo::f64::relievoEyePosition;
using relievo::f64::relievoNdcFromPixel;

template <typename Array>
vtkSmartPointer<Array> NewArray(int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  vtkRelievoAllocateImage(array, components, tuples);
  return array;
}

// Lights' layers have names that the catalogue alone does not know.
const vtkRelievoLayer& Know(const std::string& layer, const vtkRelievoGBufferLayout& layout)
{
  return layout.GetLight(layer) >= 0 ? vtkRelievoLayerCatalogue::GetOfLight()
                                     : vtkRelievoLayerCatalogue::Find(layer);
}

// Maps cells cut by vtkRelievoConvexPolygons to the users' polygons.
class PolygonNumbers
{
public:
  vtkIdType Get(const vtkRelievoDrawTable::Hit& hit)
  {
    if (!hit.Mesh || hit.Cell < 0)
    {
      return hit.Cell;
    }
    if (hit.Mesh != this->Mesh)
    {
      this->Mesh = hit.Mesh;
      this->Numbers = vtkIdTypeArray::SafeDownCast(
        this->Mesh->GetCellData()->GetAbstractArray("vtkRelievoPolygonIds"));
    }
    return this->Numbers && hit.Cell < this->Numbers->GetNumberOfValues()
      ? this->Numbers->GetValue(hit.Cell)
      : hit.Cell;
  }

private:
  vtkPolyData* Mesh = nullptr;
  vtkIdTypeArray* Numbers = nullptr;
};

// Calls f(pixel, x, y) for every pixel, in several threads.
template <typename Function>
void ForPixels(const int region[4], Function f)
{
  const vtkIdType width = region[2];
  vtkRelievoForRows(region[3], region[2], [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType y = from; y < to; ++y)
    {
      for (vtkIdType x = 0; x < width; ++x)
      {
        f(y * width + x, static_cast<int>(x), static_cast<int>(y));
      }
    }
  });
}
}

//------------------------------------------------------------------------------
vtkRelievoLayerReader::vtkRelievoLayerReader(const vtkRelievoGBufferLayout& layout,
  vtkRelievoWordSource& source, const int region[4], const vtkRelievoFrameCamera& view)
  : Layout(layout)
  , Source(source)
  , Region{ region[0], region[1], region[2], region[3] }
  , View(view)
  , Words(static_cast<std::size_t>(layout.GetNumberOfWords()))
{
}

//------------------------------------------------------------------------------
void vtkRelievoLayerReader::AddChannels(const std::string& layer, vtkRelievoGBufferLayout& layout)
{
  const int light = layout.GetLight(layer);
  const int source = Know(layer, layout).Source;
  layout.Normal = layout.Normal || (source & vtkRelievoLayer::FROM_NORMAL) != 0;
  layout.GeometricNormal =
    layout.GeometricNormal || (source & vtkRelievoLayer::FROM_GEOMETRIC_NORMAL) != 0;
  layout.Albedo = layout.Albedo || (source & vtkRelievoLayer::FROM_ALBEDO) != 0;
  // A named array is interpolated on the mesh, at the pixel's position in the cell.
  layout.Depth = layout.Depth || (source & vtkRelievoLayer::FROM_DEPTH) != 0;
  layout.Ids = layout.Ids || (source & vtkRelievoLayer::FROM_ID) != 0;
  if (light >= 0 &&
    std::find(layout.Shadows.begin(), layout.Shadows.end(), light) == layout.Shadows.end())
  {
    layout.Shadows.insert(
      std::upper_bound(layout.Shadows.begin(), layout.Shadows.end(), light), light);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerReader::NeedsPlaces(const std::string& layer)
{
  const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::Find(layer);
  return known.OfPoint || known.Kind == vtkRelievoLayer::ARRAY;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLayerReader::GetNumberOfPixels() const
{
  return static_cast<vtkIdType>(this->Region[2]) * this->Region[3];
}

//------------------------------------------------------------------------------
const std::uint32_t* vtkRelievoLayerReader::GetWords(int word)
{
  if (!this->Words[word])
  {
    const int most = this->Layout.GetWordsPerAttachment();
    const int first = word / most * most;
    std::vector<std::uint32_t*> planes;
    for (int i = first; i < std::min(first + most, this->Layout.GetNumberOfWords()); ++i)
    {
      this->Words[i].reset(static_cast<std::uint32_t*>(
        vtkRelievoNewImageMemory(this->GetNumberOfPixels() * sizeof(std::uint32_t))));
      planes.push_back(this->Words[i].get());
    }
    this->Source.Read(word / most, this->Region, planes);
  }
  return this->Words[word].get();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayerReader::Read(const std::string& layer, vtkImageData* image)
{
  if (image->GetNumberOfPoints() == 0)
  {
    image->SetDimensions(this->Region[2], this->Region[3], 1);
  }
  if (image->GetNumberOfPoints() != this->GetNumberOfPixels())
  {
    return "the image has " + std::to_string(image->GetNumberOfPoints()) +
      " points, but the layers have " + std::to_string(this->GetNumberOfPixels()) + " pixels";
  }
  vtkRelievoGBufferLayout needed;
  needed.Lights = this->Layout.Lights;
  AddChannels(layer, needed);
  if ((needed.Depth && !this->Layout.Depth) || (needed.Normal && !this->Layout.Normal) ||
    (needed.GeometricNormal && !this->Layout.GeometricNormal) ||
    (needed.Albedo && !this->Layout.Albedo) || (needed.Ids && !this->Layout.Ids) ||
    !std::includes(this->Layout.Shadows.begin(), this->Layout.Shadows.end(), needed.Shadows.begin(),
      needed.Shadows.end()))
  {
    return "the last frame did not make it; ask for it (RequestLayer) and render before";
  }
  std::string error;
  vtkSmartPointer<vtkDataArray> array;
  const vtkRelievoLayer& known = Know(layer, this->Layout);
  switch (known.Source)
  {
    case vtkRelievoLayer::FROM_DEPTH:
      array = known.OfPoint ? this->ReadPoints(known) : this->GetDepth();
      break;
    case vtkRelievoLayer::FROM_NORMAL:
      array = this->ReadNormal(this->Layout.NormalWord);
      break;
    case vtkRelievoLayer::FROM_GEOMETRIC_NORMAL:
      array = this->ReadNormal(this->Layout.GeometricNormalWord);
      break;
    case vtkRelievoLayer::FROM_ALBEDO:
      array = this->ReadAlbedo();
      break;
    case vtkRelievoLayer::FROM_ID:
      array = this->ReadId(layer);
      break;
    case vtkRelievoLayer::FROM_SHADOW:
      array = this->ReadShadow(needed.Shadows.front(), error);
      break;
    case vtkRelievoLayer::FROM_PICTURE:
      error = "it belongs to the picture; read it with vtkRelievoPass::ReadLayers";
      break;
    default:
      array = this->ReadNamedArray(layer, error);
      error += !error.empty() && vtkRelievoLayerCatalogue::GetIsOfLight(layer)
        ? ", and no light has this name (vtkRelievoShadowStage::GetShadowLayers)"
        : "";
  }
  if (array)
  {
    array->SetName(layer.c_str());
    image->GetPointData()->AddArray(array);
  }
  return error;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkRelievoLayerReader::ReadDepth()
{
  if (this->Layout.NormalDepthWord < 0 &&
    this->Layout.DepthFormat == vtkRelievoWordFormats::DEPTH_32F)
  {
    // The words are the depths themselves.
    this->GetWords(this->Layout.DepthWord);
    auto depths = vtkSmartPointer<vtkFloatArray>::New();
    depths->SetVoidArray(this->Words[this->Layout.DepthWord].release(), this->GetNumberOfPixels(),
      0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
    if (this->Refines && this->Layout.IdWord >= 0)
    {
      this->RefineDepth(depths->GetPointer(0));
    }
    return depths;
  }
  auto array = NewArray<vtkFloatArray>(1, this->GetNumberOfPixels());
  float* out = array->GetPointer(0);
  if (this->Layout.NormalDepthWord >= 0)
  {
    const int count = vtkRelievoGBufferLayout::GetNormalDepthWords(this->Layout.NormalDepth);
    const std::uint32_t* words[4] = {};
    for (int k = 0; k < count; ++k)
    {
      words[k] = this->GetWords(this->Layout.NormalDepthWord + k);
    }
    ForPixels(this->Region, [&](vtkIdType i, int, int) {
      std::uint32_t packed[4] = {};
      for (int k = 0; k < count; ++k)
      {
        packed[k] = words[k][i];
      }
      out[i] =
        vtkRelievoWordDecoder::DecodeNormalDepth(packed, this->Layout.NormalDepth, this->View).w;
    });
    return array;
  }
  const std::uint32_t* words = this->GetWords(this->Layout.DepthWord);
  ForPixels(this->Region, [&](vtkIdType i, int, int) {
    out[i] = static_cast<float>(
      vtkRelievoWordDecoder::DecodeDepth(words[i], this->Layout.DepthFormat, this->View));
  });
  return array;
}

//------------------------------------------------------------------------------
vtkFloatArray* vtkRelievoLayerReader::GetDepth()
{
  if (!this->Depth)
  {
    this->Depth = this->ReadDepth();
  }
  return this->Depth;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerReader::ResolveDraws()
{
  if (!this->Resolved)
  {
    this->Draws->Resolve(this->Renderer, this->View);
    this->Resolved = true;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLayerReader::RefineDepth(float* depths)
{
  this->ResolveDraws();
  const std::uint32_t* words = this->GetWords(this->Layout.IdWord);
  vtkRelievoDepthRefiner(*this->Draws, this->View, words).Refine(depths, *this->Links);
}

//------------------------------------------------------------------------------
// Called before threads use the result.
void vtkRelievoLayerReader::PreparePlaces()
{
  if (this->Layout.PlaceWord < 0 || !this->Places.empty())
  {
    return;
  }
  this->ResolveDraws();
  this->GetDepth();
  this->Ids = this->GetWords(this->Layout.IdWord);
  const std::uint32_t* words[2];
  for (int k = 0; k < 2; ++k)
  {
    words[k] = this->GetWords(this->Layout.PlaceWord + k);
  }
  this->Places.resize(2 * static_cast<std::size_t>(this->GetNumberOfPixels()));
  for (vtkIdType i = 0; i < this->GetNumberOfPixels(); ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      this->Places[2 * static_cast<std::size_t>(i) + static_cast<std::size_t>(k)] =
        relievo::bits::ToFloat(words[k][i]);
    }
  }
}

//------------------------------------------------------------------------------
const glm::dvec3* vtkRelievoLayerReader::GetPlace(vtkIdType pixel, glm::dvec3& eye)
{
  if (this->Places.empty() || !this->Draws->Find(this->Ids[pixel]).Moved)
  {
    return nullptr;
  }
  const float* place = this->Places.data() + 2 * pixel;
  const double depth = this->Depth->GetValue(pixel);
  eye = glm::dvec3(place[0], place[1], -depth);
  // Shader code that moves the mesh in its own space leaves positions on the pixel's ray, which are
  // more exact than interpolated ones.
  const vtkIdType width = this->Region[2];
  const glm::dvec2 size(width, this->Region[3]);
  const glm::dvec2 at(pixel % width, pixel / width);
  const auto seen = [&](const glm::dvec2& each) {
    return glm::dvec3(
      relievoEyePosition(relievoNdcFromPixel(each, size), depth, this->View.ViewToNDC));
  };
  const double off = glm::distance(glm::dvec2(eye), glm::dvec2(seen(at)));
  const double step = glm::distance(glm::dvec2(seen(at + 1.0)), glm::dvec2(seen(at)));
  return off > 0.01 * step ? &eye : nullptr;
}

//------------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<Array> vtkRelievoLayerReader::MakeOfPoints(const vtkRelievoLayer& layer)
{
  const float* depths = this->GetDepth()->GetPointer(0);
  const int components = layer.Components;
  auto array = NewArray<Array>(components, this->GetNumberOfPixels());
  auto* out = array->GetPointer(0);
  using Value = typename Array::ValueType;
  const glm::dvec2 size(this->Region[2], this->Region[3]);
  const glm::dmat4 viewToWorld = glm::inverse(this->View.WorldToView);
  this->PreparePlaces();
  ForPixels(this->Region, [&](vtkIdType i, int x, int y) {
    double values[vtkRelievoArraySampler::MaximumComponents];
    std::fill_n(values, components, layer.Background);
    if (std::isfinite(depths[i]))
    {
      glm::dvec3 eye;
      if (!this->GetPlace(i, eye))
      {
        eye = relievoEyePosition(
          relievoNdcFromPixel(glm::dvec2(x, y), size), depths[i], this->View.ViewToNDC);
      }
      const glm::dvec3 point = layer.Space == vtkRelievoLayer::WORLD
        ? relievo::f64::relievoWorldPosition(eye, viewToWorld)
        : eye;
      layer.OfPoint(&point[0], values);
    }
    std::transform(values, values + components, out + i * components,
      [](double value) { return static_cast<Value>(value); });
  });
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadPoints(const vtkRelievoLayer& layer)
{
  return layer.Type == VTK_DOUBLE
    ? vtkSmartPointer<vtkDataArray>(this->MakeOfPoints<vtkDoubleArray>(layer))
    : vtkSmartPointer<vtkDataArray>(this->MakeOfPoints<vtkFloatArray>(layer));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadNormal(int firstWord)
{
  auto array = NewArray<vtkFloatArray>(3, this->GetNumberOfPixels());
  float* out = array->GetPointer(0);
  const bool together = firstWord < 0;
  const int count = together
    ? vtkRelievoGBufferLayout::GetNormalDepthWords(this->Layout.NormalDepth)
    : vtkRelievoGBufferLayout::GetNormalWords(this->Layout.ChosenNormalFormat);
  const std::uint32_t* words[4] = {};
  const int first = together ? this->Layout.NormalDepthWord : firstWord;
  for (int k = 0; k < count; ++k)
  {
    words[k] = this->GetWords(first + k);
  }
  // From view to world: the transposed matrix transforms normals correctly under any scale.
  const glm::mat3 toSpace = this->WorldNormals
    ? glm::mat3(glm::transpose(glm::dmat3(this->View.WorldToView)))
    : glm::mat3(1.0f);
  const vtkIdType width = this->Region[2];
  vtkRelievoForRows(this->Region[3], this->Region[2], [&](vtkIdType from, vtkIdType to) {
    // Cached: neighbours mostly show the background or one flat triangle.
    std::uint32_t packed[4] = {};
    glm::vec3 normal(0.0f);
    for (vtkIdType i = from * width; i < to * width; ++i)
    {
      bool same = i > from * width;
      for (int k = 0; k < count; ++k)
      {
        const std::uint32_t word = words[k][i];
        same = same && word == packed[k];
        packed[k] = word;
      }
      if (!same)
      {
        normal = together
          ? glm::vec3(vtkRelievoWordDecoder::DecodeNormalDepth(
              packed, this->Layout.NormalDepth, this->View))
          : vtkRelievoWordDecoder::DecodeNormal(packed, this->Layout.ChosenNormalFormat);
        if (normal != glm::vec3(0.0f))
        {
          normal = glm::normalize(toSpace * normal);
        }
      }
      out[3 * i] = normal.x;
      out[3 * i + 1] = normal.y;
      out[3 * i + 2] = normal.z;
    }
  });
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadId(const std::string& layer)
{
  this->ResolveDraws();
  const bool actor = layer == "actor";
  const bool block = layer == "block";
  auto array = NewArray<vtkIntArray>(1, this->GetNumberOfPixels());
  int* out = array->GetPointer(0);
  const std::uint32_t* words = this->GetWords(this->Layout.IdWord);
  const vtkIdType width = this->Region[2];
  vtkRelievoForRows(this->Region[3], this->Region[2], [&](vtkIdType from, vtkIdType to) {
    std::uint32_t last = vtkRelievoDrawTable::Nothing;
    int value = -1;
    PolygonNumbers numbers;
    for (vtkIdType i = from * width; i < to * width; ++i)
    {
      const std::uint32_t word = words[i];
      if (word != last)
      {
        last = word;
        const auto hit = this->Draws->Find(word);
        value = actor ? hit.Actor : block ? hit.Block : static_cast<int>(numbers.Get(hit));
      }
      out[i] = value;
    }
  });
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadNamedArray(
  const std::string& layer, std::string& error)
{
  this->ResolveDraws();
  vtkRelievoArraySampler sampler(layer, *this->Draws, this->View);
  int components = 0;
  const int type = sampler.Prepare(this->Renderer, components, error);
  if (!error.empty())
  {
    return nullptr;
  }
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  vtkRelievoAllocateImage(array, components, this->GetNumberOfPixels());
  const std::uint32_t* words = this->GetWords(this->Layout.IdWord);
  const vtkIdType width = this->Region[2];
  this->PreparePlaces();
  vtkRelievoForRows(this->Region[3], this->Region[2], [&](vtkIdType from, vtkIdType to) {
    vtkRelievoArraySampler::Place place;
    double values[vtkRelievoArraySampler::MaximumComponents];
    for (vtkIdType i = from * width; i < to * width; ++i)
    {
      sampler.Enter(words[i], place);
      glm::dvec3 eye;
      sampler.Sample(place, static_cast<int>(i % width), static_cast<int>(i / width),
        this->GetPlace(i, eye), values);
      array->SetTuple(i, values);
    }
  });
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadAlbedo()
{
  auto array = NewArray<vtkUnsignedCharArray>(4, this->GetNumberOfPixels());
  unsigned char* out = array->GetPointer(0);
  const std::uint32_t* words = this->GetWords(this->Layout.AlbedoWord);
  const vtkIdType width = this->Region[2];
  vtkRelievoForRows(this->Region[3], this->Region[2], [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from * width; i < to * width; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        out[4 * i + k] = static_cast<unsigned char>(words[i] >> (8 * k));
      }
    }
  });
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadShadow(int light, std::string& error)
{
  const int lights = this->Renderer ? this->Renderer->GetLights()->GetNumberOfItems() : 0;
  if (light >= lights)
  {
    error = "the renderer has " + std::to_string(lights) + (lights == 1 ? " light" : " lights") +
      ", counted from 0";
    return nullptr;
  }
  const std::vector<int>& shadows = this->Layout.Shadows;
  const int place =
    static_cast<int>(std::lower_bound(shadows.begin(), shadows.end(), light) - shadows.begin());
  auto array = NewArray<vtkFloatArray>(1, this->GetNumberOfPixels());
  float* out = array->GetPointer(0);
  const std::uint32_t* words = this->GetWords(this->Layout.ShadowWord + place / 2);
  const int shift = 16 * (place % 2);
  const vtkIdType width = this->Region[2];
  vtkRelievoForRows(this->Region[3], this->Region[2], [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from * width; i < to * width; ++i)
    {
      out[i] = static_cast<float>((words[i] >> shift) & 0xffffu) / 65535.0f;
    }
  });
  return array;
}
