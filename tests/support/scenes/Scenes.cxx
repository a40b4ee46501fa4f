// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "Check.h"
#include "EmbreeScene.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoOFFReader.h>

#include <algorithm>

namespace relievoTest
{
namespace
{
struct MeshFile
{
  const char* Name;
  const char* File;
  bool ZUp;
  bool Reference;
};

const MeshFile MeshFiles[] = {
  { "bunny", "bunny.off", false, true },
  { "motorBike", "motorBike.obj", true, true },
  { "buildings", "buildings.obj", true, true },
  { "armadillo", "armadillo.off", false, false },
  { "elephant", "elephant.off", false, false },
};

const MeshFile* Find(const std::string& name)
{
  const MeshFile* found = std::find_if(std::begin(MeshFiles), std::end(MeshFiles),
    [&](const MeshFile& mesh) { return name == mesh.Name; });
  if (found == std::end(MeshFiles))
  {
    Fail(__FILE__, __LINE__, "there is no real mesh named '" + name + "'");
    return nullptr;
  }
  return found;
}

std::vector<std::string> Names(bool reference)
{
  std::vector<std::string> names;
  for (const MeshFile& mesh : MeshFiles)
  {
    if (mesh.Reference == reference)
    {
      names.emplace_back(mesh.Name);
    }
  }
  return names;
}

vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.1);
  return actor;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> ReferenceMeshes()
{
  return Names(true);
}

//------------------------------------------------------------------------------
std::vector<std::string> OtherMeshes()
{
  return Names(false);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> LoadMesh(const std::string& name)
{
  const MeshFile* file = Find(name);
  const std::string path = file ? DataFile(file->File) : std::string();
  if (path.empty())
  {
    return nullptr;
  }
  vtkSmartPointer<vtkPolyData> read;
  if (path.substr(path.size() - 4) == ".off")
  {
    vtkNew<vtkRelievoOFFReader> reader;
    reader->SetFileName(path.c_str());
    reader->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    reader->Update();
    read = reader->GetOutput();
  }
  else
  {
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    read = reader->GetOutput();
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(read->GetPoints());
  mesh->SetPolys(read->GetPolys());
  if (!Check(mesh->GetNumberOfPolys() > 0, __FILE__, __LINE__, path + " holds no polygons"))
  {
    return nullptr;
  }
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PlaceMesh(vtkPolyData* mesh, bool zUp)
{
  const auto turned = [&](vtkIdType id, double p[3]) {
    mesh->GetPoint(id, p);
    if (zUp)
    {
      const double y = p[1];
      p[1] = p[2];
      p[2] = -y;
    }
  };
  // Bounds of the points that polygons use: files may contain others.
  double low[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  vtkDataArray* used = mesh->GetPolys()->GetConnectivityArray();
  double p[3];
  for (vtkIdType i = 0; i < used->GetNumberOfTuples(); ++i)
  {
    turned(static_cast<vtkIdType>(used->GetTuple1(i)), p);
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  const double longest = std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  const double scale = 2. / longest;
  const double origin[3] = { 0.5 * (low[0] + high[0]), low[1], 0.5 * (low[2] + high[2]) };

  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    turned(i, p);
    points->SetPoint(
      i, scale * (p[0] - origin[0]), scale * (p[1] - origin[1]), scale * (p[2] - origin[2]));
  }
  auto placed = vtkSmartPointer<vtkPolyData>::New();
  placed->SetPoints(points);
  placed->SetPolys(mesh->GetPolys());
  return placed;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeGround(double half)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->InsertNextPoint(-half, 0., half);
  points->InsertNextPoint(half, 0., half);
  points->InsertNextPoint(half, 0., -half);
  points->InsertNextPoint(-half, 0., -half);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  auto ground = vtkSmartPointer<vtkPolyData>::New();
  ground->SetPoints(points);
  ground->SetPolys(polys);
  return ground;
}

//------------------------------------------------------------------------------
void SetReferenceCamera(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(2.5, 3., 6.);
  camera->SetFocalPoint(0., 0.5, 0.);
  camera->SetViewUp(0., 1., 0.);
  camera->SetViewAngle(30.);
  camera->SetClippingRange(2., 14.);
}

//------------------------------------------------------------------------------
ReferenceScene MakeReferenceScene(vtkPolyData* mesh, SceneLight light)
{
  ReferenceScene scene;
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();
  scene.Mesh = mesh;
  scene.Ground = MakeGround();
  scene.MeshActor = MakeActor(mesh);
  scene.GroundActor = MakeActor(scene.Ground);
  scene.Renderer->AddActor(scene.MeshActor);
  scene.Renderer->AddActor(scene.GroundActor);
  scene.Renderer->SetBackground(0.2, 0.25, 0.3);

  scene.Light = vtkSmartPointer<vtkLight>::New();
  scene.Light->SetLightTypeToSceneLight();
  scene.Light->SetPosition(3., 5., 2.);
  scene.Light->SetFocalPoint(0., 0., 0.);
  scene.Light->SetPositional(light != SceneLight::Sun);
  if (light != SceneLight::Sun)
  {
    // From 90 degrees on, VTK treats a positional light as one that shines everywhere.
    scene.Light->SetConeAngle(light == SceneLight::Spot ? 60. : 90.);
  }
  scene.Renderer->SetAutomaticLightCreation(false);
  scene.Renderer->AddLight(scene.Light);
  SetReferenceCamera(scene.Renderer);
  return scene;
}

//------------------------------------------------------------------------------
ReferenceScene MakeReferenceScene(const std::string& name, SceneLight light)
{
  const vtkSmartPointer<vtkPolyData> mesh = LoadMesh(name);
  if (!mesh)
  {
    return ReferenceScene();
  }
  return MakeReferenceScene(PlaceMesh(mesh, Find(name)->ZUp), light);
}

//------------------------------------------------------------------------------
std::shared_ptr<EmbreeScene> ReferenceScene::MakeTruth() const
{
  auto truth = std::make_shared<EmbreeScene>();
  truth->AddActor(this->Mesh, this->MeshActor->GetMatrix());
  truth->AddActor(this->Ground, this->GroundActor->GetMatrix());
  return truth;
}
}
