// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Materials with normal maps on meshes that the vertex shader moves, against the same mesh moved by
// vtkRelievoSkin: with tangents of the mesh, which are skinned, and with those that the material
// finds on the screen.
#include "Check.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "SkinnedScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataTangents.h>
#include <vtkRelievoMaterial.h>
#include <vtkTriangleFilter.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <string>

namespace testSkinnedMaterials
{
namespace
{
using namespace relievoTest;

vtkSmartPointer<vtkPolyData> MakeMesh(bool withTangents)
{
  const auto rest = MakeThreeBoneTube(41, 20);
  vtkNew<vtkFloatArray> places;
  places->SetName("TextureCoordinates");
  places->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    const double angle = static_cast<double>(i % 20) / 10.;
    places->InsertNextTuple2(PointOf(rest, i).x, angle > 1. ? 2. - angle : angle);
  }
  rest->GetPointData()->SetTCoords(places);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(rest);
  triangles->Update();
  vtkSmartPointer<vtkPolyData> mesh = triangles->GetOutput();
  if (withTangents)
  {
    vtkNew<vtkPolyDataTangents> tangents;
    tangents->SetInputConnection(triangles->GetOutputPort());
    tangents->Update();
    mesh = tangents->GetOutput();
  }
  mesh->SetFieldData(rest->GetFieldData());
  return mesh;
}

// Waves along both coordinates, as floats.
vtkSmartPointer<vtkImageData> MakeNormals()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const glm::dvec3 n = glm::normalize(
        glm::dvec3(0.5 * std::sin(0.1963495 * x), 0.3 * std::cos(0.0981748 * y), 1.));
      for (int i = 0; i < 3; ++i)
      {
        image->SetScalarComponentFromDouble(x, y, 0, i, n[i]);
      }
    }
  }
  return image;
}

void Test(bool withTangents, int method)
{
  const auto mesh = MakeMesh(withTangents);
  RELIEVO_CHECK((mesh->GetPointData()->GetTangents() != nullptr) == withTangents);
  SkinnedPair pair;
  pair.Set(mesh, MakeBentPose(0.7, 0.8, 1.), method);
  const std::string what =
    MethodName(method) + (withTangents ? ", tangents of the mesh" : ", tangents of the screen");
  const Layers plain(pair.GPU.Stage.Renderer, { "normal", "cell" });
  const auto before = Picture(pair.GPU.Stage.Window);
  vtkNew<vtkRelievoMaterial> material;
  material->SetNormalMap(MakeNormals());
  material->Attach(pair.CPU.Actor);
  material->Attach(pair.GPU.Actor);
  pair.CompareLayers(what);
  pair.ComparePictures(what, 2e-3);
  RELIEVO_CHECK(CountUnlike(before, Picture(pair.GPU.Stage.Window), 5) > 2000);
  // They are the map's, about 20 degrees off those of the mesh.
  const Layers mapped(pair.GPU.Stage.Renderer, { "normal", "cell" });
  double sum = 0.;
  int seen = 0;
  for (int y = 0; y < plain.Height; ++y)
  {
    for (int x = 0; x < plain.Width; ++x)
    {
      if (plain.Id("cell", x, y) >= 0)
      {
        sum += glm::distance(plain.Vector("normal", x, y), mapped.Vector("normal", x, y));
        ++seen;
      }
    }
  }
  RELIEVO_CHECK_THAT(seen > 1000 && sum / seen > 0.2 && sum / seen < 0.7,
    what + ": normals are " + std::to_string(sum / seen) + " off the mesh's");
  material->Detach(pair.CPU.Actor);
  material->Detach(pair.GPU.Actor);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinnedMaterials)
{
  relievoTest::Session session;
  for (const int method : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
  {
    Test(false, method);
    Test(true, method);
  }
  return session.Result();
}
}
