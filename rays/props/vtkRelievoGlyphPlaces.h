// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The matrices by which a vtkGlyph3DMapper places its sources, which VTK passes only to OpenGL:
// computed by its rules for masks, sources, orientations and scales, either rounded as for drawing,
// or exact.
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
  // From a source to the actor's coordinates.
  using Matrices = std::vector<glm::dmat4>;

  enum class Numbers
  {
    AsDrawn, // rounded to floats as in VTK; flat glyphs fail: floats cannot invert their matrix
    Exact
  };

  explicit vtkRelievoGlyphPlaces(Numbers numbers = Numbers::AsDrawn)
    : Kind(numbers)
  {
  }

  // A mesh of a source, and all of its places in a block of the input, with the block's flat index
  // and points. Valid until the mapper's pipeline changes.
  struct Group
  {
    vtkPolyData* Mesh = nullptr;
    std::shared_ptr<const Matrices> Places;
    std::shared_ptr<const std::vector<vtkIdType>> Points;
    int Block = 0;
  };

  // Recomputed after a change of the mapper, its points or its sources. Null if the places cannot
  // be determined: glyphs culled by OpenGL, blocks with their own visibility or opacity, input that
  // VTK does not draw.
  const std::vector<Group>* Find(vtkGlyph3DMapper* mapper);

private:
  struct Cached
  {
    vtkWeakPointer<vtkGlyph3DMapper> Mapper;
    std::vector<std::uint64_t> State;
    bool Known = false;
    std::vector<Group> Groups;
  };
  Numbers Kind;
  std::map<vtkGlyph3DMapper*, Cached> Mappers;
};

#endif
