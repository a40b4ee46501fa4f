// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CodedScenes.h"

#include "FrameBench.h"
#include "MadeMeshes.h"

#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>

#include <cmath>

namespace relievoBench
{
namespace
{
using relievoTest::ReferenceScene;

// Collects shapes in one mesh.
class Shapes
{
public:
  void AddSphere(double x, double y, double z, double radius)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(x, y, z);
    sphere->SetRadius(radius);
    sphere->SetThetaResolution(96);
    sphere->SetPhiResolution(48);
    this->Append->AddInputConnection(sphere->GetOutputPort());
  }

  // Adds a pole that stands on the ground.
  void AddPole(double x, double z, double radius, double height)
  {
    vtkNew<vtkCylinderSource> pole;
    pole->SetCenter(x, 0.5 * height, z);
    pole->SetRadius(radius);
    pole->SetHeight(height);
    pole->SetResolution(24);
    this->Append->AddInputConnection(pole->GetOutputPort());
  }

  // Adds a slab with its bottom at a height, turned about the y axis.
  void AddSlab(double bottom, double thickness, double width, double degrees)
  {
    vtkNew<vtkCubeSource> slab;
    slab->SetXLength(width);
    slab->SetYLength(thickness);
    slab->SetZLength(width);
    slab->SetCenter(0., bottom + 0.5 * thickness, 0.);
    vtkNew<vtkTransform> turn;
    turn->RotateY(degrees);
    vtkNew<vtkTransformFilter> turned;
    turned->SetTransform(turn);
    turned->SetInputConnection(slab->GetOutputPort());
    this->Append->AddInputConnection(turned->GetOutputPort());
  }

  // A mesh of points in float and polygons.
  vtkSmartPointer<vtkPolyData> Mesh()
  {
    this->Append->Update();
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Append->GetOutput()->GetPoints());
    mesh->SetPolys(this->Append->GetOutput()->GetPolys());
    return mesh;
  }

private:
  vtkNew<vtkAppendPolyData> Append;
};

vtkSmartPointer<vtkPolyData> Spheres()
{
  Shapes shapes;
  for (int i = 0; i < 9; ++i)
  {
    const double radius = 0.08 + 0.03 * i;
    const double x = -1.5 + 1.5 * (i % 3);
    const double z = -1.5 + 1.5 * static_cast<int>(i / 3);
    // Every second sphere floats; the others touch the ground.
    shapes.AddSphere(x, radius + (i % 2) * 0.3, z, radius);
    shapes.AddPole(x + 0.7, z + 0.4, 0.01 + 0.005 * i, 1.2);
  }
  return shapes.Mesh();
}

constexpr double HorizonHalf = 200.;

vtkSmartPointer<vtkPolyData> Poles()
{
  Shapes shapes;
  for (double z = 2.; z > 4. - HorizonHalf; z -= 4.)
  {
    shapes.AddPole(-2.5, z, 0.12, 3.);
    shapes.AddPole(2.5, z, 0.05, 3.);
  }
  return shapes.Mesh();
}

vtkSmartPointer<vtkPolyData> Slabs()
{
  Shapes shapes;
  shapes.AddSlab(0., 0.4, 2.4, 0.);
  for (int i = 0; i < 6; ++i)
  {
    shapes.AddSlab(0.4 + 0.01 * i, 0.01, 2. - 0.3 * i, 25. * (i + 1));
  }
  return shapes.Mesh();
}

void MakeHorizon(const ReferenceScene& scene, vtkPolyData* ground)
{
  vtkPolyDataMapper::SafeDownCast(scene.GroundActor->GetMapper())->SetInputData(ground);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.5, 1.7, 8.);
  camera->SetFocalPoint(-0.5, 0.5, -10.);
  camera->SetViewAngle(45.);
  camera->SetClippingRange(0.5, 500.);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ShadowSceneMesh(const std::string& name)
{
  return name == SpheresScene ? Spheres()
    : name == HorizonScene    ? Poles()
    : name == SlabsScene      ? Slabs()
    : name == FinsScene       ? relievoTest::MakeFins()
    : name == FoldsScene      ? relievoTest::MakeFolds()
    : name == ArrowsScene     ? relievoTest::MakeArrows()
    : name == TreeScene       ? relievoTest::MakeTree()
                              : SceneMesh(name);
}

//------------------------------------------------------------------------------
ReferenceScene MakeShadowScene(const std::string& name, vtkPolyData* mesh, const ShadowLight& light)
{
  ReferenceScene scene = relievoTest::MakeReferenceScene(mesh, light.Kind);
  if (name == HorizonScene)
  {
    scene.Ground = relievoTest::MakeGround(HorizonHalf);
    MakeHorizon(scene, scene.Ground);
  }
  for (vtkActor* actor : { scene.MeshActor.Get(), scene.GroundActor.Get() })
  {
    actor->GetProperty()->SetColor(1., 1., 1.);
    actor->GetProperty()->SetAmbient(0.);
    actor->GetProperty()->SetDiffuse(1.);
    actor->GetProperty()->SetSpecular(0.);
  }
  scene.Light->SetExponent(0.);
  if (light.Elevation > 0.)
  {
    const double* at = scene.Light->GetPosition();
    const double height =
      std::hypot(at[0], at[2]) * std::tan(vtkMath::RadiansFromDegrees(light.Elevation));
    scene.Light->SetPosition(at[0], height, at[2]);
  }
  return scene;
}
}
