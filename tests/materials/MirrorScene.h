// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MirrorScene.h
 * @brief A black wall in an environment, which it mirrors.
 */
#ifndef relievoTestMirrorScene_h
#define relievoTestMirrorScene_h

#include "GLCheck.h"
#include "Props.h"
#include "Stage.h"
#include "Surroundings.h"

#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoEnvironment.h>
#include <vtkRelievoMaterial.h>

#include <cmath>

namespace relievoTest
{
/** A square through the origin that faces `normal`, 20 wide, with normals and coordinates. */
inline vtkSmartPointer<vtkPolyData> Wall(const glm::dvec3& normal)
{
  const glm::dvec3 n = glm::normalize(normal);
  const glm::dvec3 u = 10. *
    glm::normalize(glm::cross(std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), n));
  const glm::dvec3 v = glm::cross(n, u);
  auto mesh = MakePolygons({ -u - v, u - v, u + v, v - u });
  const vtkIdType quad[4] = { 0, 1, 2, 3 };
  mesh->GetPolys()->InsertNextCell(4, quad);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  for (int i = 0; i < 4; ++i)
  {
    normals->InsertNextTuple3(n.x, n.y, n.z);
    places->InsertNextTuple2(i == 1 || i == 2 ? 1. : 0., i > 1 ? 1. : 0.);
  }
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->SetTCoords(places);
  return mesh;
}

/** A black wall before the camera, lit by nothing. */
struct MirrorScene
{
  relievoTest::Stage Stage{ 160, 120 };
  vtkRenderer* Renderer = this->Stage.Renderer;
  vtkNew<vtkLight> Lamp;
  vtkNew<vtkRelievoEnvironment> Environment;
  vtkNew<vtkRelievoMaterial> Material;
  vtkSmartPointer<vtkActor> Actor;
  GLCheck Watch{ this->Stage.Window };

  MirrorScene(const Light& light, int projection, int n, vtkPolyData* mesh)
    : Actor(AddActor(this->Renderer, mesh))
  {
    this->Lamp->SetIntensity(0.);
    this->Lamp->SetLightTypeToSceneLight();
    this->Renderer->AddLight(this->Lamp);
    vtkProperty* look = this->Actor->GetProperty();
    look->SetInterpolationToPhong();
    look->SetColor(0., 0., 0.);
    look->SetAmbient(0.);
    this->Environment->SetImage(MakeEnvironment(light, projection, n));
    this->Material->SetEnvironment(this->Environment);
    this->Material->SetReflectivity(1.);
    this->Material->Attach(this->Actor);
  }
  ~MirrorScene() { this->Material->Detach(this->Actor); }

  void LookAt(const glm::dvec3& normal, double viewAngle)
  {
    LookAlong(this->Renderer, 4. * glm::normalize(normal), -normal, viewAngle);
  }
  double Worst(const Light& truth) { return WorstDifference(this->Renderer, truth); }
};
}

#endif
