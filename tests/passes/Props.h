// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Props.h
 * @brief Small things to put before the layers: actors, balls, moved copies.
 */
#ifndef relievoTestProps_h
#define relievoTestProps_h

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

namespace relievoTest
{
/** Adds an actor with a mapper of its own for the mesh. */
vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkPolyData* mesh);

/** A ball about the origin, 12 x 9, with normals at its points, points in float. */
vtkSmartPointer<vtkPolyData> MakeBall(double radius);

/** A copy moved by x, y, z, points in float. */
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, double x, double y, double z);
}

#endif
