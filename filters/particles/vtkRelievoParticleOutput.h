// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Particles as points with arrays.
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
  // Numbers and cells of the particles, which the outputs of all times share; Write makes them if
  // there are none of that count.
  vtkSmartPointer<vtkIdTypeArray>& Numbers;
  vtkSmartPointer<vtkCellArray>& Vertices;

  // The names of the point data that do not go along, as particles have their own; or nothing.
  std::string FindReplaced(vtkDataSet* start) const;

  // Particles, the first of which has this number; their start's point data go along.
  void Write(const vtkRelievoParticleState& state, vtkIdType first, vtkDataSet* start,
    vtkPolyData* output) const;

private:
  void Number(vtkIdType first, vtkIdType count) const;
};

#endif
