// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Props.h
 * @brief Small objects for tests of layers: actors, balls, moved copies, textures.
 */
#ifndef relievoTestProps_h
#define relievoTestProps_h

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <glm/glm.hpp>

class vtkRenderer;

namespace relievoTest
{
/** Adds an actor with its own mapper for the mesh. */
vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkPolyData* mesh);

/** A ball about the origin, 12 x 9, with normals at its points, points in float. */
vtkSmartPointer<vtkPolyData> MakeBall(double radius);

/** A copy moved by x, y, z, points in float. */
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, double x, double y, double z);

/** A square of half width 1 in the plane z = 0, one quad, with texture coordinates from 0 to 1. */
vtkSmartPointer<vtkPolyData> MakeSquare();

/**
 * A texture of 4 x 4 texels, not interpolated: orange (255, 128, 0) where x + y is even, elsewhere
 * blue (0, 128, 255) or, with `holes`, nothing.
 */
vtkSmartPointer<vtkTexture> MakeChecker(bool holes);

/** The parity of x + y of the texel at a position of the square; -1 near a texel's border. */
int GetCheckerParity(const glm::dvec3& place);
}

#endif
