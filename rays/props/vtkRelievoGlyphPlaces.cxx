// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGlyphPlaces.h"

#include "vtkBitArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkQuaternion.h"
#include "vtkRelievoGlyphArrays.h"
#include "vtkRelievoPropMTime.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
using Matrices = vtkRelievoGlyphPlaces::Matrices;
using Numbers = vtkRelievoGlyphPlaces::Numbers;
using Meshes = std::vector<vtkPolyData*>;

constexpr vtkIdType MostGlyphs = 1 << 22;
constexpr double Flat = 1e-2; // relative to the longest side

template <typename Visit>
void ForEachLeaf(vtkCompositeDataSet* blocks, Visit visit)
{
  auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    visit(it->GetCurrentDataObject(), static_cast<int>(it->GetCurrentFlatIndex()));
  }
}

// The meshes of each source. False if VTK draws none of them, or a line instead.
bool FindSources(vtkGlyph3DMapper* mapper, std::vector<Meshes>& sources)
{
  if (!mapper->GetUseSourceTableTree())
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
    {
      sources.push_back({ mapper->GetSource(i) });
      if (!sources.back()[0])
      {
        return false;
      }
    }
    return !sources.empty();
  }
  vtkDataObjectTree* tree = mapper->GetSourceTableTree();
  if (!tree || mapper->GetNumberOfInputConnections(1) > 1)
  {
    return false;
  }
  auto it = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  it->TraverseSubTreeOff();
  it->VisitOnlyLeavesOff();
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    Meshes meshes;
    vtkDataObject* source = it->GetCurrentDataObject();
    const auto add = [&](vtkDataObject* leaf, int) {
      if (auto* mesh = vtkPolyData::SafeDownCast(leaf))
      {
        meshes.push_back(mesh);
      }
    };
    if (auto* parts = vtkCompositeDataSet::SafeDownCast(source))
    {
      ForEachLeaf(parts, add);
    }
    else if (vtkPolyData::SafeDownCast(source))
    {
      add(source, 0);
    }
    else
    {
      return false;
    }
    sources.push_back(meshes);
  }
  return !sources.empty();
}

struct Input
{
  vtkDataSet* Points;
  int Block;
};

// The drawn inputs. False if the attributes of blocks matter, which VTK's versions inherit
// differently.
bool FindInputs(vtkGlyph3DMapper* mapper, std::vector<Input>& inputs)
{
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto* points = vtkDataSet::SafeDownCast(input))
  {
    inputs.push_back({ points, 0 });
    return true;
  }
  auto* blocks = vtkCompositeDataSet::SafeDownCast(input);
  vtkCompositeDataDisplayAttributes* attributes = mapper->GetBlockAttributes();
  if (!blocks ||
    (attributes && (attributes->HasBlockVisibilities() || attributes->HasBlockOpacities())))
  {
    return false;
  }
  ForEachLeaf(blocks, [&](vtkDataObject* block, int index) {
    if (auto* points = vtkDataSet::SafeDownCast(block))
    {
      inputs.push_back({ points, index });
    }
  });
  return true;
}

// Parameters by which a mapper computes a matrix from a point's data.
class Rules
{
public:
  Rules(vtkGlyph3DMapper* mapper, vtkDataSet* points, int sources)
    : Mapper(mapper)
    , Points(points)
    , Last(sources - 1)
    , Index(vtkRelievoGlyphArrays::GetSourceIndex(mapper, points))
    , Orient(vtkRelievoGlyphArrays::GetOrientation(mapper, points))
    , Scale(vtkRelievoGlyphArrays::GetScale(mapper, points))
  {
    if (mapper->GetMasking())
    {
      this->Mask = vtkBitArray::SafeDownCast(vtkRelievoGlyphArrays::GetMask(mapper, points));
    }
  }

  // Without valid arrays VTK draws nothing, with an error.
  bool AreSound() const
  {
    const bool four = this->Mapper->GetOrientationMode() == vtkGlyph3DMapper::QUATERNION;
    return (!this->Mask || this->Mask->GetNumberOfComponents() == 1) &&
      (!this->Orient || this->Orient->GetNumberOfComponents() == (four ? 4 : 3)) &&
      (!this->Scale || this->Scale->GetNumberOfComponents() == 3 ||
        this->Mapper->GetScaleMode() != vtkGlyph3DMapper::SCALE_BY_COMPONENTS);
  }

  bool IsDrawn(vtkIdType point) const { return !this->Mask || this->Mask->GetValue(point) != 0; }

  int GetSource(vtkIdType point) const
  {
    if (!this->Index)
    {
      return 0;
    }
    const double value =
      vtkMath::Norm(this->Index->GetTuple(point), this->Index->GetNumberOfComponents());
    return std::max(0, std::min(this->Last, static_cast<int>(value)));
  }

  glm::dmat3 GetTurn(vtkIdType point) const
  {
    if (!this->Orient)
    {
      return glm::dmat3(1.0);
    }
    double v[4] = { 0.0, 0.0, 0.0, 0.0 };
    this->Orient->GetTuple(point, v);
    vtkQuaterniond turn;
    if (this->Mapper->GetOrientationMode() == vtkGlyph3DMapper::QUATERNION)
    {
      turn.Set(v);
    }
    else if (this->Mapper->GetOrientationMode() == vtkGlyph3DMapper::ROTATION)
    {
      const glm::dvec3 half = 0.5 * glm::radians(glm::dvec3(v[0], v[1], v[2]));
      turn = vtkQuaterniond(std::cos(half.z), 0.0, 0.0, std::sin(half.z)) *
        vtkQuaterniond(std::cos(half.x), std::sin(half.x), 0.0, 0.0) *
        vtkQuaterniond(std::cos(half.y), 0.0, std::sin(half.y), 0.0);
    }
    else if (v[1] == 0.0 && v[2] == 0.0)
    {
      if (v[0] < 0.0)
      {
        turn.Set(0.0, 0.0, 1.0, 0.0); // half a turn about y
      }
    }
    else
    {
      // Half a turn about the bisector of x and the direction.
      const glm::dvec3 axis = glm::normalize(glm::dvec3(v[0] + vtkMath::Norm(v), v[1], v[2]));
      turn.Set(0.0, axis.x, axis.y, axis.z);
    }
    double rows[3][3];
    turn.ToMatrix3x3(rows);
    glm::dmat3 matrix;
    for (int i = 0; i < 9; ++i)
    {
      matrix[i % 3][i / 3] = rows[i / 3][i % 3];
    }
    return matrix;
  }

  glm::dvec3 GetSize(vtkIdType point) const
  {
    if (!this->Mapper->GetScaling())
    {
      return glm::dvec3(1.0);
    }
    glm::dvec3 size(1.0);
    const int mode = this->Mapper->GetScaleMode();
    if (this->Scale && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
    {
      const double* v = this->Scale->GetTuple(point);
      size = mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS
        ? glm::dvec3(v[0], v[1], v[2])
        : glm::dvec3(vtkMath::Norm(v, this->Scale->GetNumberOfComponents()));
      if (this->Mapper->GetClamping())
      {
        const double* range = this->Mapper->GetRange();
        const double width = range[1] - range[0];
        size =
          (glm::min(glm::max(size, range[0]), range[1]) - range[0]) / (width == 0.0 ? 1.0 : width);
      }
    }
    size *= this->Mapper->GetScaleFactor();
    for (int i = 0; i < 3; ++i)
    {
      size[i] = size[i] == 0.0 ? 1e-10 : size[i];
    }
    return size;
  }

  glm::dvec3 GetPoint(vtkIdType point) const
  {
    glm::dvec3 p;
    this->Points->GetPoint(point, &p.x);
    return p;
  }

private:
  vtkGlyph3DMapper* Mapper;
  vtkDataSet* Points;
  int Last;
  vtkDataArray* Index;
  vtkDataArray* Orient;
  vtkDataArray* Scale;
  vtkBitArray* Mask = nullptr;
};

// The places of a source in one input.
struct SourcePlaces
{
  std::shared_ptr<Matrices> Places = std::make_shared<Matrices>();
  std::shared_ptr<std::vector<vtkIdType>> Points = std::make_shared<std::vector<vtkIdType>>();
};

// Appends to the places of each source. False if one of them is flat, so that floats cannot invert
// its matrix.
bool AddPlaces(
  const Rules& rules, vtkIdType points, Numbers numbers, std::vector<SourcePlaces>& places)
{
  for (vtkIdType i = 0; i < points; ++i)
  {
    if (!rules.IsDrawn(i))
    {
      continue;
    }
    const glm::dvec3 size = rules.GetSize(i);
    const glm::dvec3 sides = glm::abs(size);
    if (numbers == Numbers::AsDrawn &&
      std::min({ sides.x, sides.y, sides.z }) < Flat * std::max({ sides.x, sides.y, sides.z }))
    {
      return false;
    }
    const glm::dmat3 turn = rules.GetTurn(i);
    const glm::dmat4 place(glm::dvec4(size.x * turn[0], 0.0), glm::dvec4(size.y * turn[1], 0.0),
      glm::dvec4(size.z * turn[2], 0.0), glm::dvec4(rules.GetPoint(i), 1.0));
    const glm::mat4 drawn(place);
    // NaN matrices are not drawn.
    if (std::all_of(&drawn[0][0], &drawn[0][0] + 16, [](float x) { return std::isfinite(x); }))
    {
      SourcePlaces& source = places[rules.GetSource(i)];
      source.Places->push_back(numbers == Numbers::AsDrawn ? glm::dmat4(drawn) : place);
      source.Points->push_back(i);
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
const std::vector<vtkRelievoGlyphPlaces::Group>* vtkRelievoGlyphPlaces::Find(
  vtkGlyph3DMapper* mapper)
{
  for (auto it = this->Mappers.begin(); it != this->Mappers.end();)
  {
    it = it->second.Mapper ? std::next(it) : this->Mappers.erase(it);
  }
  std::vector<Meshes> sources;
  std::vector<Input> inputs;
  if (mapper->GetCullingAndLOD() || !FindSources(mapper, sources) || !FindInputs(mapper, inputs))
  {
    this->Mappers.erase(mapper);
    return nullptr;
  }
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  std::vector<std::uint64_t> state = { mapper->GetMTime(), vtkRelievoPropMTime::OfData(input),
    reinterpret_cast<std::uintptr_t>(input) };
  for (const Meshes& meshes : sources)
  {
    state.push_back(meshes.size());
    for (vtkPolyData* mesh : meshes)
    {
      state.push_back(reinterpret_cast<std::uintptr_t>(mesh));
    }
  }
  for (const Input& each : inputs)
  {
    state.push_back(reinterpret_cast<std::uintptr_t>(each.Points));
    state.push_back(each.Points->GetMTime());
  }
  Cached& cached = this->Mappers[mapper];
  if (cached.State != state)
  {
    cached = { mapper, state, true, {} };
    vtkIdType count = 0;
    for (const Input& each : inputs)
    {
      const Rules rules(mapper, each.Points, static_cast<int>(sources.size()));
      const vtkIdType points = each.Points->GetNumberOfPoints();
      std::vector<SourcePlaces> places(sources.size());
      count += points;
      cached.Known = cached.Known && count <= MostGlyphs && rules.AreSound() &&
        AddPlaces(rules, points, this->Kind, places);
      for (std::size_t i = 0; i < sources.size() && cached.Known; ++i)
      {
        for (vtkPolyData* mesh : sources[i])
        {
          cached.Groups.push_back({ mesh, places[i].Places, places[i].Points, each.Block });
        }
      }
    }
  }
  return cached.Known ? &cached.Groups : nullptr;
}
