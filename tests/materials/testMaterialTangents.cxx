// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Materials and VTK's PBR shading take the tangents of vtkRelievoTangents from the mesh: mapped
// normals against the closed form of a bent texture, on both of its mirrored halves.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoMaterial.h>
#include <vtkRelievoTangents.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace testMaterialTangents
{
namespace
{
using namespace relievoTest;

constexpr int Size = 200;
const glm::dvec3 Mapped(0.48, 0.36, 0.8); // the value of the whole map

// v is y less the bend at |x|, u is |x|: along growing u, at the same v, y follows the bend, and so
// does the tangent; the left half is mirrored.
double Bend(double x)
{
  return 0.3 * std::sin(2.5 * x);
}

glm::dvec3 Tangent(double x)
{
  const double side = x < 0. ? -1. : 1.;
  return glm::normalize(glm::dvec3(side, 0.75 * std::cos(2.5 * std::abs(x)), 0.));
}

glm::dvec3 Truth(double x)
{
  const glm::dvec3 normal(0., 0., 1.);
  const glm::dvec3 tangent = Tangent(x);
  const glm::dvec3 bitangent = (x < 0. ? -1. : 1.) * glm::cross(normal, tangent);
  return Mapped.x * tangent + Mapped.y * bitangent + Mapped.z * normal;
}

// The plane from -1 to 1 in triangles, with a column of points at x = 0.
vtkSmartPointer<vtkPolyData> BentPlane(int cells)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(ReliefPlane(cells));
  triangles->Update();
  vtkSmartPointer<vtkPolyData> mesh = triangles->GetOutput();
  vtkNew<vtkFloatArray> texture;
  texture->SetNumberOfComponents(2);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    texture->InsertNextTuple2(std::abs(p[0]), p[1] - Bend(std::abs(p[0])));
    normals->InsertNextTuple3(0., 0., 1.);
  }
  mesh->GetPointData()->SetTCoords(texture);
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

template <typename Array>
vtkSmartPointer<vtkImageData> EvenMap(double scale, double offset)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 4, 1);
  vtkNew<Array> values;
  values->SetNumberOfComponents(3);
  for (int i = 0; i < 16; ++i)
  {
    values->InsertNextTuple3(
      scale * Mapped.x + offset, scale * Mapped.y + offset, scale * Mapped.z + offset);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

struct Errors
{
  double Left = 0., Right = 0.; // means, degrees
};

Errors ErrorsOf(vtkRenderer* renderer)
{
  const Layers layers(renderer, { "depth", "normal", "position" }, Way::Shared);
  double sum[2] = { 0., 0. };
  int count[2] = { 0, 0 };
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      if (std::isfinite(layers.Value("depth", x, y)))
      {
        const double place = layers.Vector("position", x, y).x;
        const glm::dvec3 seen = layers.Vector("normal", x, y);
        const glm::dvec3 truth = Truth(place);
        const int half = place < 0. ? 0 : 1;
        sum[half] += std::atan2(glm::length(glm::cross(seen, truth)), glm::dot(seen, truth));
        ++count[half];
      }
    }
  }
  RELIEVO_CHECK(count[0] > 10000 && count[1] > 10000);
  const double degrees = 57.295779513082320877;
  return { degrees * sum[0] / count[0], degrees * sum[1] / count[1] };
}

struct Scene
{
  relievoTest::Stage Stage{ Size, Size };
  vtkSmartPointer<vtkActor> Actor;
  GLCheck Watch{ this->Stage.Window };

  explicit Scene(vtkPolyData* mesh)
    : Actor(AddActor(this->Stage.Renderer, mesh))
  {
    vtkCamera* camera = this->Stage.Renderer->GetActiveCamera();
    camera->SetPosition(0., 0., 4.);
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.);
    camera->SetClippingRange(1., 9.);
  }
};

Errors WithMaterial(vtkPolyData* mesh, int interpolation, vtkTexture* own = nullptr)
{
  Scene scene(mesh);
  scene.Actor->GetProperty()->SetInterpolation(interpolation);
  if (own)
  {
    scene.Actor->GetProperty()->SetNormalTexture(own);
  }
  vtkNew<vtkRelievoMaterial> material;
  material->SetNormalMap(EvenMap<vtkFloatArray>(1., 0.));
  material->Attach(scene.Actor);
  const Errors errors = ErrorsOf(scene.Stage.Renderer);
  material->Detach(scene.Actor);
  return errors;
}

void CheckActive(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* active = mesh->GetPointData()->GetTangents();
  vtkDataArray* all = mesh->GetPointData()->GetArray(name);
  if (!RELIEVO_CHECK(active && active->GetNumberOfComponents() == 3) ||
    !RELIEVO_CHECK(all && all->GetNumberOfComponents() == 4))
  {
    return;
  }
  RELIEVO_CHECK(vtkFloatArray::SafeDownCast(active) != nullptr); // VTK's mapper takes no other
  int mismatches = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      mismatches += active->GetComponent(i, c) == all->GetComponent(i, c) ? 0 : 1;
    }
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "active tangents that are not those of the array");
}

void TestMaterial()
{
  double last = 0.;
  for (const int cells : { 16, 32 })
  {
    const vtkSmartPointer<vtkPolyData> bare = BentPlane(cells);
    vtkNew<vtkRelievoTangents> filter;
    filter->SetInputData(bare);
    filter->Update();
    CheckActive(filter->GetOutput(), "tangent");
    const std::string name = std::to_string(cells) + " cells: ";
    const Errors flat = WithMaterial(bare, VTK_PHONG);
    double worst = 0.;
    for (const int interpolation : { VTK_PHONG, VTK_PBR })
    {
      const Errors smooth = WithMaterial(filter->GetOutput(), interpolation);
      worst = std::max({ worst, smooth.Left, smooth.Right });
    }
    RELIEVO_CHECK_AT_MOST(worst, 130. / (cells * cells), name + "mean of a half, degrees");
    // Faces by themselves know one tangent each: they are off by the bend within a cell.
    RELIEVO_CHECK_AT_MOST(2. * worst, std::min(flat.Left, flat.Right),
      name + "twice that, against what faces by themselves reach");
    RELIEVO_CHECK(last == 0. || worst < 0.3 * last);
    last = worst;
  }
}

// A model that brings a normal texture, as many glTF files do: the material's map is seen instead.
void TestOwnTexture()
{
  vtkNew<vtkRelievoTangents> filter;
  filter->SetInputData(BentPlane(32));
  filter->Update();
  vtkNew<vtkTexture> own;
  own->SetInputData(EvenMap<vtkUnsignedCharArray>(-127.5, 128.));
  const Errors alone = WithMaterial(filter->GetOutput(), VTK_PBR);
  const Errors errors = WithMaterial(filter->GetOutput(), VTK_PBR, own);
  RELIEVO_CHECK(errors.Left == alone.Left && errors.Right == alone.Right);
}

// VTK's own normal map, in bytes: right where the texture is not mirrored.
void TestPBR()
{
  vtkNew<vtkRelievoTangents> filter;
  filter->SetInputData(BentPlane(32));
  filter->SetTangentsName("Tangents");
  filter->Update();
  CheckActive(filter->GetOutput(), "Tangents");
  Scene scene(filter->GetOutput());
  vtkNew<vtkTexture> map;
  map->SetInputData(EvenMap<vtkUnsignedCharArray>(127.5, 128.));
  scene.Actor->GetProperty()->SetInterpolationToPBR();
  scene.Actor->GetProperty()->SetNormalTexture(map);
  const Errors errors = ErrorsOf(scene.Stage.Renderer);
  RELIEVO_CHECK_AT_MOST(errors.Right, 0.5, "VTK's PBR, the half that is not mirrored, degrees");
  RELIEVO_CHECK_THAT(errors.Left > 10., "VTK's PBR knows mirrored halves: say so in the docs");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMaterialTangents)
{
  relievoTest::Session session;
  TestMaterial();
  TestOwnTexture();
  TestPBR();
  return session.Result();
}
}
