// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthToPoints.h"

#include "vtkRelievoFormulas.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace f64 = relievo::f64;

vtkStandardNewMacro(vtkRelievoDepthToPoints);

namespace
{
struct Camera
{
  f64::mat4 CameraToWorld = f64::mat4(1.);
  f64::mat4 Projection = f64::mat4(1.);
};

// The names of existing arrays, for messages.
std::string Names(vtkFieldData* fields)
{
  std::ostringstream names;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    const char* name = fields->GetArrayName(i);
    names << (i ? ", " : "") << (name ? name : "(unnamed)");
  }
  return fields->GetNumberOfArrays() ? names.str() : "none";
}

// The one-component depth array of a single slice; null, with `problem` set, if there is none.
vtkDataArray* GetDepth(vtkImageData* image, const std::string& name, std::string& problem)
{
  if (image->GetDimensions()[2] > 1)
  {
    problem = "the input has " + std::to_string(image->GetDimensions()[2]) +
      " slices, but a depth image has one";
    return nullptr;
  }
  vtkDataArray* depth = image->GetPointData()->GetArray(name.c_str());
  if (depth && depth->GetNumberOfComponents() == 1)
  {
    return depth;
  }
  problem = "the input needs a point array '" + name + "' (DepthArrayName) of one component, but " +
    (depth ? "it has " + std::to_string(depth->GetNumberOfComponents())
           : "its arrays are: " + Names(image->GetPointData()));
  return nullptr;
}

// Reads 16 numbers, row by row, into columns; false, with `problem` set, if there are none.
bool GetMatrix(vtkFieldData* fields, const char* name, f64::mat4& matrix, std::string& problem)
{
  vtkDataArray* array = fields->GetArray(name);
  if (!array || array->GetNumberOfValues() != 16)
  {
    problem = "the input's field data needs an array '" + std::string(name) +
      "' of 16 numbers (a 4 x 4 matrix, row by row), but " +
      (array ? "it has " + std::to_string(array->GetNumberOfValues()) + " numbers"
             : "its arrays are: " + Names(fields));
    return false;
  }
  const int components = array->GetNumberOfComponents();
  for (int i = 0; i < 16; ++i)
  {
    const double value = array->GetComponent(i / components, i % components);
    if (!std::isfinite(value))
    {
      problem = "the matrix '" + std::string(name) + "' has a number that is not finite";
      return false;
    }
    matrix[i % 4][i / 4] = value;
  }
  return true;
}

// Inverts an affine matrix by its 3 x 3 part: 4 x 4 determinants would lose digits of a far
// translation.
bool InvertAffine(const f64::mat4& matrix, f64::mat4& inverse)
{
  const f64::mat3 linear(matrix);
  const double determinant = glm::determinant(linear);
  const bool affine =
    matrix[0][3] == 0. && matrix[1][3] == 0. && matrix[2][3] == 0. && matrix[3][3] == 1.;
  if (!affine || determinant == 0. || !std::isfinite(determinant))
  {
    return false;
  }
  const f64::mat3 linearInverse = glm::inverse(linear);
  inverse = f64::mat4(linearInverse);
  inverse[3] = f64::vec4(-(linearInverse * f64::vec3(matrix[3])), 1.);
  return true;
}

bool GetCamera(vtkFieldData* fields, Camera& camera, std::string& problem)
{
  f64::mat4 worldToCamera;
  f64::mat4 worldToNdc;
  if (!fields->GetAbstractArray("worldToCamera") && fields->GetAbstractArray("R"))
  {
    problem = "the input is of a sensor, which R and t in its field data place, and not of a "
              "renderer's camera with the matrices worldToCamera and worldToNDC; capture the layer "
              "position, whose values are the points";
    return false;
  }
  if (!GetMatrix(fields, "worldToCamera", worldToCamera, problem) ||
    !GetMatrix(fields, "worldToNDC", worldToNdc, problem))
  {
    return false;
  }
  if (!InvertAffine(worldToCamera, camera.CameraToWorld))
  {
    problem = "the matrix 'worldToCamera' has no inverse, or its last row is not 0 0 0 1";
    return false;
  }
  camera.Projection = worldToNdc * camera.CameraToWorld;
  return true;
}
}

//------------------------------------------------------------------------------
vtkRelievoDepthToPoints::vtkRelievoDepthToPoints()
{
  this->SetDepthArrayName("depth");
  this->Parameters.AddWhole("stride", vtkRelievoMember(Stride), 1, VTK_INT_MAX, "",
    "Uses every Stride-th column and row of pixels, from the lower left one.");
  this->Parameters.AddFlag("keep_arrays", vtkRelievoMember(KeepArrays),
    "Whether the points carry the values of all arrays at their pixels.");
}

//------------------------------------------------------------------------------
vtkRelievoDepthToPoints::~vtkRelievoDepthToPoints()
{
  this->SetDepthArrayName(nullptr);
}

//------------------------------------------------------------------------------
int vtkRelievoDepthToPoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoDepthToPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const std::string name = this->DepthArrayName ? this->DepthArrayName : "";
  Camera camera;
  std::string problem;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1; // of several processes, those without part of the image
  }
  if (!GetDepth(input, name, problem) || !GetCamera(input->GetFieldData(), camera, problem))
  {
    // The output stays empty. Status 0 would make the pipeline report a second error.
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No points: " << problem << ".");
    return 1;
  }

  vtkPointData* layers = input->GetPointData();
  vtkDataArray* depth = layers->GetArray(name.c_str());
  int size[3];
  input->GetDimensions(size);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> pixels;
  const f64::vec2 viewport(size[0], size[1]);
  for (vtkIdType y = 0; y < size[1] && !this->GetAbortExecute(); y += this->Stride)
  {
    for (vtkIdType x = 0; x < size[0]; x += this->Stride)
    {
      const vtkIdType pixel = y * size[0] + x;
      const double z = depth->GetComponent(pixel, 0);
      if (!std::isfinite(z))
      {
        continue;
      }
      const f64::vec2 ndc = f64::relievoNdcFromPixel(f64::vec2(x, y), viewport);
      const f64::vec3 eye = f64::relievoEyePosition(ndc, z, camera.Projection);
      const f64::vec3 world = f64::relievoWorldPosition(eye, camera.CameraToWorld);
      points->InsertNextPoint(world.x, world.y, world.z);
      pixels->InsertNextId(pixel);
    }
    this->UpdateProgress((y + 1.) / size[1]);
  }

  const vtkIdType count = pixels->GetNumberOfIds();
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetNumberOfValues(count);
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->SetValue(i, i);
    ids->SetId(i, i);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(1, vertices);
  output->SetPoints(points);
  output->SetVerts(cells);
  if (this->KeepArrays)
  {
    output->GetPointData()->CopyAllOn();
    output->GetPointData()->CopyAllocate(layers, count);
    output->GetPointData()->CopyData(layers, pixels, ids);
  }
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoDepthToPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DepthArrayName: " << (this->DepthArrayName ? this->DepthArrayName : "(none)")
     << "\n";
  os << indent << "KeepArrays: " << (this->KeepArrays ? "on" : "off") << "\n";
  os << indent << "Stride: " << this->Stride << "\n";
}
