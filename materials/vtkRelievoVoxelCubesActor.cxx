// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelCubesActor.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShader.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkRelievoVoxelCubesActor);

namespace
{
// A cube with sides of 1 around the origin; each face has its own points, with its normal.
vtkSmartPointer<vtkPolyData> MakeCube()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> faces;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -0.5, 0.5 })
    {
      vtkIdType ids[4];
      // Counter-clockwise from outside.
      const double corners[4][2] = { { -0.5, -0.5 }, { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 } };
      for (int c = 0; c < 4; ++c)
      {
        double place[3];
        double normal[3] = { 0., 0., 0. };
        place[axis] = side;
        place[(axis + 1) % 3] = side > 0. ? corners[c][0] : corners[c][1];
        place[(axis + 2) % 3] = side > 0. ? corners[c][1] : corners[c][0];
        normal[axis] = side > 0. ? 1. : -1.;
        ids[c] = points->InsertNextPoint(place);
        normals->InsertNextTuple(normal);
      }
      faces->InsertNextCell(4, ids);
    }
  }
  auto cube = vtkSmartPointer<vtkPolyData>::New();
  cube->SetPoints(points);
  cube->SetPolys(faces);
  cube->GetPointData()->SetNormals(normals);
  return cube;
}
}

//------------------------------------------------------------------------------
// Rejects values that are not finite; equal values are not a change, which would redraw shadow
// maps.
void vtkRelievoVoxelCubesActor::Change(
  const char* name, double* values, const double* given, int count)
{
  if (!std::all_of(given, given + count, [](double value) { return std::isfinite(value); }))
  {
    vtkErrorMacro(<< name << " is unchanged: the given values are not finite.");
    return;
  }
  if (!std::equal(given, given + count, values))
  {
    std::copy(given, given + count, values);
    this->UpdateUniforms();
  }
}

//------------------------------------------------------------------------------
vtkRelievoVoxelCubesActor::vtkRelievoVoxelCubesActor()
{
  this->Glyphs->SetSourceData(MakeCube());
  this->Glyphs->SetScaleModeToScaleByVectorComponents();
  this->Glyphs->SetScaleArray("instance");
  // From the filter's array; without the array glyphs are not rotated.
  this->Glyphs->SetOrientationModeToQuaternion();
  this->Glyphs->SetOrientationArray("orientation");
  this->SetMapper(this->Glyphs);
  // Before VTK's own replacement, which replaces the remaining tag by the instance's matrix.
  const std::string text = vtkRelievoShaderLibrary::Get("cubes/cubes.glsl");
  this->GetShaderProperty()->AddVertexShaderReplacement(
    "//VTK::Glyph::Dec", true, "//VTK::Glyph::Dec\n" + text, false);
  this->UpdateUniforms();
}

//------------------------------------------------------------------------------
vtkRelievoVoxelCubesActor::~vtkRelievoVoxelCubesActor() = default;

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetInputConnection(vtkAlgorithmOutput* port)
{
  this->Glyphs->SetInputConnection(port);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetInputData(vtkDataObject* data)
{
  this->Glyphs->SetInputDataObject(data);
}

//------------------------------------------------------------------------------
vtkGlyph3DMapper* vtkRelievoVoxelCubesActor::GetGlyphMapper()
{
  return this->Glyphs;
}

//------------------------------------------------------------------------------
// Not by a change of the mapper, which would rebuild its instances.
void vtkRelievoVoxelCubesActor::UpdateUniforms()
{
  float cell[4] = { 0.F, 0.F, 0.F, 0.F };
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[axis] = static_cast<float>(std::abs(this->CellSize[axis]));
    cell[3] = std::max(cell[3], cell[axis]);
  }
  const float fall[3] = { static_cast<float>(this->Transition), static_cast<float>(this->RestSize),
    static_cast<float>(this->Growth) };
  const float repeller[4] = { static_cast<float>(this->Repeller[0]),
    static_cast<float>(this->Repeller[1]), static_cast<float>(this->Repeller[2]),
    static_cast<float>(this->RepellerRadius) };
  vtkUniforms* uniforms = this->GetShaderProperty()->GetVertexCustomUniforms();
  uniforms->SetUniform4f("relievoCubeCell", cell);
  uniforms->SetUniform3f("relievoCubeFall", fall);
  uniforms->SetUniform4f("relievoCubeRepeller", repeller);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetCellSize(double x, double y, double z)
{
  const double size[3] = { x, y, z };
  this->Change("CellSize", this->CellSize, size, 3);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetTransition(double distance)
{
  const double value = std::max(distance, 0.);
  this->Change("Transition", &this->Transition, &value, 1);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetRestSize(double size)
{
  const double value = std::clamp(size, 0., 1.);
  this->Change("RestSize", &this->RestSize, &value, 1);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetGrowth(double growth)
{
  const double value = std::clamp(growth, 0., 1.);
  this->Change("Growth", &this->Growth, &value, 1);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetRepeller(double x, double y, double z)
{
  const double place[3] = { x, y, z };
  this->Change("Repeller", this->Repeller, place, 3);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::SetRepellerRadius(double radius)
{
  const double value = std::max(radius, 0.);
  this->Change("RepellerRadius", &this->RepellerRadius, &value, 1);
}

//------------------------------------------------------------------------------
double* vtkRelievoVoxelCubesActor::GetBounds()
{
  // Otherwise the bounds would include those computed below, and grow with each call.
  this->MapperBounds[0] = VTK_DOUBLE_MAX;
  double* bounds = this->Superclass::GetBounds();
  if (!bounds || !(bounds[0] <= bounds[1]))
  {
    return bounds;
  }
  // The mapper knows the sizes of instances, which are at most those of the drawn cubes.
  vtkBoundingBox box(bounds);
  vtkMatrix4x4* matrix = this->GetMatrix();
  vtkBoundingBox cell;
  vtkBoundingBox ball;
  for (int corner = 0; corner < 8; ++corner)
  {
    double side[4] = { 0., 0., 0., 0. };
    double place[4] = { 0., 0., 0., 1. };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double sign = (corner >> axis & 1) ? 1. : -1.;
      side[axis] = sign * this->CellSize[axis] / 2.;
      place[axis] =
        this->Repeller[axis] + sign * (this->RepellerRadius + std::abs(this->CellSize[axis]) / 2.);
    }
    matrix->MultiplyPoint(side, side);
    matrix->MultiplyPoint(place, place);
    cell.AddPoint(side);
    ball.AddPoint(place);
  }
  box.Inflate(cell.GetLength(0) / 2., cell.GetLength(1) / 2., cell.GetLength(2) / 2.);
  if (this->RepellerRadius > 0. && box.Intersects(ball))
  {
    box.AddBox(ball);
  }
  box.GetBounds(this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubesActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CellSize: " << this->CellSize[0] << " " << this->CellSize[1] << " "
     << this->CellSize[2] << "\n";
  os << indent << "Transition: " << this->Transition << "\n";
  os << indent << "RestSize: " << this->RestSize << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "Repeller: " << this->Repeller[0] << " " << this->Repeller[1] << " "
     << this->Repeller[2] << "\n";
  os << indent << "RepellerRadius: " << this->RepellerRadius << "\n";
}
