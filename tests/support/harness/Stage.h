// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stage.h
 * @brief Small test objects: a renderer with the reference camera, a box, loose polygons.
 */
#ifndef relievoTestStage_h
#define relievoTestStage_h

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <vector>

namespace relievoTest
{
/** A renderer in an off-screen window, with the reference camera moved by `origin`. */
struct Stage
{
  Stage(int width, int height, const glm::dvec3& origin = glm::dvec3(0.));

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
};

/** A box about the origin, six quads facing outwards; points in double. */
vtkSmartPointer<vtkPolyData> MakeBox(double x, double y, double z);

/** A mesh of these points, in double, with an empty vtkCellArray of polygons to insert into. */
vtkSmartPointer<vtkPolyData> MakePolygons(const std::vector<glm::dvec3>& points);
}

#endif
