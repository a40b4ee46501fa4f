// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRCamera.h"

#include "vtkRelievoEXRFields.h"
#include "vtkType.h"

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <string>
#include <vector>

namespace relievo::exr
{
namespace
{
using Matrix = std::vector<double>; // VTK's order: 4 * row + column

const std::string CameraPrefix = "relievo:";

Imath::M44d ToImath(const Matrix& vtk)
{
  Imath::M44d m;
  for (int i = 0; i < 16; ++i)
  {
    m[i / 4][i % 4] = vtk[i];
  }
  return m;
}

// Converts VTK's world-to-camera matrix to OpenEXR's: row vectors, and the camera looks along +z.
Imath::M44f CameraToStandard(const Matrix& vtk)
{
  Imath::M44f m;
  for (int r = 0; r < 4; ++r)
  {
    for (int c = 0; c < 4; ++c)
    {
      m[r][c] = static_cast<float>(c == 2 ? -vtk[4 * c + r] : vtk[4 * c + r]);
    }
  }
  return m;
}

Matrix CameraFromStandard(const Imath::M44f& m)
{
  Matrix vtk(16);
  for (int r = 0; r < 4; ++r)
  {
    for (int c = 0; c < 4; ++c)
    {
      vtk[4 * c + r] = c == 2 ? -m[r][c] : m[r][c];
    }
  }
  return vtk;
}

// Converts NDC from -1 .. 1, y up, to 0 .. 1, y down: x' = (x + w) / 2, y' = (w - y) / 2.
Imath::M44f NdcToStandard(const Matrix& vtk)
{
  Imath::M44f m;
  for (int r = 0; r < 4; ++r)
  {
    const double w = vtk[12 + r];
    m[r][0] = static_cast<float>((vtk[r] + w) / 2);
    m[r][1] = static_cast<float>((w - vtk[4 + r]) / 2);
    m[r][2] = static_cast<float>(vtk[8 + r]);
    m[r][3] = static_cast<float>(w);
  }
  return m;
}

Matrix NdcFromStandard(const Imath::M44f& m)
{
  Matrix vtk(16);
  for (int r = 0; r < 4; ++r)
  {
    const double w = m[r][3];
    vtk[r] = 2.0 * m[r][0] - w;
    vtk[4 + r] = w - 2.0 * m[r][1];
    vtk[8 + r] = m[r][2];
    vtk[12 + r] = w;
  }
  return vtk;
}
}

//------------------------------------------------------------------------------
void WriteCamera(vtkFieldData* fields, Imf::Header& header)
{
  const Matrix camera = FieldNumbers(fields, "worldToCamera", 16);
  if (!camera.empty())
  {
    Insert(header, "worldToCamera", Imf::M44fAttribute(CameraToStandard(camera)));
    Insert(header, CameraPrefix + "worldToCamera", Imf::M44dAttribute(ToImath(camera)));
  }
  const Matrix ndc = FieldNumbers(fields, "worldToNDC", 16);
  if (!ndc.empty())
  {
    Insert(header, "worldToNDC", Imf::M44fAttribute(NdcToStandard(ndc)));
    Insert(header, CameraPrefix + "worldToNDC", Imf::M44dAttribute(ToImath(ndc)));
  }
  for (const std::string name : { "near", "far" })
  {
    const std::vector<double> plane = FieldNumbers(fields, name.c_str(), 1);
    if (!plane.empty())
    {
      Insert(header, name, Imf::FloatAttribute(static_cast<float>(plane[0])));
      Insert(header, CameraPrefix + name, Imf::DoubleAttribute(plane[0]));
    }
  }
  const std::vector<double> origin = FieldNumbers(fields, "relievo:origin", 3);
  if (!origin.empty())
  {
    Insert(header, "relievo:origin", Imf::V3dAttribute({ origin[0], origin[1], origin[2] }));
  }
}

//------------------------------------------------------------------------------
void ReadCamera(const Imf::Header& header, vtkFieldData* fields)
{
  const auto exact = [&](const std::string& name) {
    const Imath::M44d* m = ValueOf<Imath::M44d>(header, CameraPrefix + name);
    return m ? Matrix((*m)[0], (*m)[0] + 16) : Matrix();
  };
  const Imath::M44f* standardCamera = ValueOf<Imath::M44f>(header, "worldToCamera");
  const Imath::M44f* standardNdc = ValueOf<Imath::M44f>(header, "worldToNDC");
  Matrix camera = exact("worldToCamera");
  Matrix ndc = exact("worldToNDC");
  camera = camera.empty() && standardCamera ? CameraFromStandard(*standardCamera) : camera;
  ndc = ndc.empty() && standardNdc ? NdcFromStandard(*standardNdc) : ndc;
  if (!camera.empty())
  {
    AddFieldNumbers(fields, "worldToCamera", VTK_DOUBLE, camera);
  }
  if (!ndc.empty())
  {
    AddFieldNumbers(fields, "worldToNDC", VTK_DOUBLE, ndc);
  }
  for (const std::string name : { "near", "far" })
  {
    const double* precise = ValueOf<double>(header, CameraPrefix + name);
    const float* standard = ValueOf<float>(header, name);
    if (precise || standard)
    {
      AddFieldNumbers(fields, name, VTK_DOUBLE, { precise ? *precise : *standard });
    }
  }
  if (const Imath::V3d* origin = ValueOf<Imath::V3d>(header, "relievo:origin"))
  {
    AddFieldNumbers(fields, "relievo:origin", VTK_DOUBLE, { origin->x, origin->y, origin->z });
  }
}
}
