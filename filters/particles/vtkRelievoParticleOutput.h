// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes particles as points with arrays.
#ifndef vtkRelievoParticleOutput_h
#define vtkRelievoParticleOutput_h

#include "vtkRelievoParticleField.h"
#include "vtkRelievoParticleMaps.h"
#include "vtkRelievoParticleState.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

class vtkCellArray;
class vtkDataSet;
class vtkIdTypeArray;
class vtkPolyData;

struct vtkRelievoParticleOutput
{
  const vtkRelievoParticleMaps& Maps;
  const vtkRelievoParticleField& Field;
  bool Inside;
  bool Orientations;
  // Numbers and cells of the particles, shared by the outputs of all times; Write makes them if
  // their count differs.
  vtkSmartPointer<vtkIdTypeArray>& Numbers;
  vtkSmartPointer<vtkCellArray>& Vertices;

  // The names of the start's point arrays that are left out because particles have their own; or an
  // empty text.
  std::string FindReplaced(vtkDataSet* start) const;

  // Writes particles, numbered from `first`; their start's point data are copied.
  void Write(const vtkRelievoParticleState& state, vtkIdType first, vtkDataSet* start,
    vtkPolyData* output) const;

private:
  void Number(vtkIdType first, vtkIdType count) const;
};

#endif
