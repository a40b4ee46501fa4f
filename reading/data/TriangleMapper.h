// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's mapper of polygons, faster for pure triangle meshes: 32-bit corners go to the GPU directly
// from memory, and the bounds are found in one pass. VTK gathers the corners cell by cell in an
// array of its own. Input that is data, and no filter's output, has no pipeline to update, which
// would cost more than drawing a small mesh. The picture is the same, and so is the name of the
// class, by which passes recognise a mapper's kind.
#ifndef TriangleMapper_h
#define TriangleMapper_h

#include "ReadingNames.h"
#include "vtkOpenGLPolyDataMapper.h"

#include <array>

namespace reading
{
class TriangleMapper : public vtkOpenGLPolyDataMapper
{
public:
  static TriangleMapper* New();
  using Superclass = vtkOpenGLPolyDataMapper;

  using Superclass::SetInputConnection;
  void SetInputConnection(int port, vtkAlgorithmOutput* input) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  TriangleMapper() = default;
  ~TriangleMapper() override = default;

  void ComputeBounds() override;
  void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* mesh) override;

private:
  std::array<vtkMTimeType, 2> Uploaded = {}; // the triangles and points on the GPU; 0: VTK's own
  vtkMTimeType BoundsTime = 0;
  std::array<double, 6> KnownBounds = {};

  TriangleMapper(const TriangleMapper&) = delete;
  void operator=(const TriangleMapper&) = delete;
};
}

#endif
