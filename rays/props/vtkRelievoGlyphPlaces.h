// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a vtkGlyph3DMapper puts its sources: the matrices that VTK hands to OpenGL and to nobody
// else, by its rules for masks, sources, orientations and scales, as they are drawn or exact.
#ifndef vtkRelievoGlyphPlaces_h
#define vtkRelievoGlyphPlaces_h

#include "vtkRelievoFormulas.h"   // for GLM
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

class vtkDataSet;
class vtkGlyph3DMapper;
class vtkPolyData;

class VTKRELIEVORAYS_EXPORT vtkRelievoGlyphPlaces
{
public:
  // From a source to the actor.
  using Matrices = std::vector<glm::dmat4>;

  enum class Numbers
  {
    AsDrawn, // rounded to floats, as VTK has them; without flat glyphs: floats have no way back
    Exact
  };

  explicit vtkRelievoGlyphPlaces(Numbers numbers = Numbers::AsDrawn)
    : Kind(numbers)
  {
  }

  // A mesh of a source, and all of its places in a block of the input, with the block's flat index
  // and its points. Good until the mapper's pipeline changes.
  struct Group
  {
    vtkPolyData* Mesh = nullptr;
    std::shared_ptr<const Matrices> Places;
    std::shared_ptr<const std::vector<vtkIdType>> Points;
    int Block = 0;
  };

  // Calculated when the mapper, its points or its sources have changed. Null if they are not to be
  // had: glyphs that OpenGL culls, blocks with a visibility or an opacity of their own, input that
  // VTK does not draw.
  const std::vector<Group>* Find(vtkGlyph3DMapper* mapper);

private:
  struct Held
  {
    vtkWeakPointer<vtkGlyph3DMapper> Mapper;
    std::vector<std::uint64_t> State;
    bool Known = false;
    std::vector<Group> Groups;
  };
  Numbers Kind;
  std::map<vtkGlyph3DMapper*, Held> Mappers;
};

#endif
