// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normal textures of a glTF model (Debian's assimp-testmodels), as maps of vtkRelievoMaterial: each
// pixel's normal against that of the glTF specification, computed in double from the file's arrays.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkGLTFReader.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageReader2Collection.h>
#include <vtkImageReader2Factory.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoMaterial.h>
#include <vtkRelievoTangents.h>
#include <vtkRelievoVTKVersions.h>
#include <vtkRenderer.h>
#ifdef RELIEVO_VTK_GLTF_TEXTURE_OBJECTS
#include <vtkGLTFTexture.h>
#endif

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace testMaterialGLTF
{
namespace
{
using namespace relievoTest;

constexpr int Size = 300;

glm::dvec3 Tuple3(vtkDataArray* array, vtkIdType i)
{
  return { array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
}

// Between the centres of four texels, the image repeated. v counts upwards, as VTK's rows do.
glm::dvec3 Mapped(vtkImageData* image, const glm::dvec2& uv)
{
  const int* size = image->GetDimensions();
  vtkDataArray* bytes = image->GetPointData()->GetScalars();
  const glm::dvec2 at(uv.x * size[0] - 0.5, uv.y * size[1] - 0.5);
  const glm::dvec2 low = glm::floor(at);
  const auto texel = [&](int dx, int dy) {
    const int i = ((static_cast<int>(low.x) + dx) % size[0] + size[0]) % size[0];
    const int j = ((static_cast<int>(low.y) + dy) % size[1] + size[1]) % size[1];
    return Tuple3(bytes, static_cast<vtkIdType>(j) * size[0] + i);
  };
  const glm::dvec2 part = at - low;
  const glm::dvec3 mean = glm::mix(
    glm::mix(texel(0, 0), texel(1, 0), part.x), glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
  return 2. * mean / 255. - 1.;
}

// A triangle of the file: the specification's values at a place on it.
struct Face
{
  glm::dvec3 P[3], N[3];
  glm::dvec2 T[3]; // v counts downwards

  Face(vtkPolyData* mesh, vtkIdType cell)
  {
    vtkNew<vtkIdList> points;
    mesh->GetCellPoints(cell, points);
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType point = points->GetId(i);
      mesh->GetPoint(point, &this->P[i][0]);
      this->N[i] = Tuple3(mesh->GetPointData()->GetNormals(), point);
      vtkDataArray* texture = mesh->GetPointData()->GetTCoords();
      this->T[i] = { texture->GetComponent(point, 0), texture->GetComponent(point, 1) };
    }
  }

  glm::dvec3 Truth(const glm::dvec3& place, vtkImageData* image) const
  {
    const glm::dvec3 a = this->P[1] - this->P[0];
    const glm::dvec3 b = this->P[2] - this->P[0];
    const glm::dvec3 c = place - this->P[0];
    const glm::dvec3 area = glm::cross(a, b);
    const double s = glm::dot(glm::cross(c, b), area) / glm::dot(area, area);
    const double t = glm::dot(glm::cross(a, c), area) / glm::dot(area, area);
    const glm::dvec2 uv = (1. - s - t) * this->T[0] + s * this->T[1] + t * this->T[2];
    const glm::dvec3 n =
      glm::normalize((1. - s - t) * this->N[0] + s * this->N[1] + t * this->N[2]);
    // Along u, and against the file's v: the map's green counts upwards.
    const glm::dvec2 ta = this->T[1] - this->T[0];
    const glm::dvec2 tb = this->T[2] - this->T[0];
    const double det = ta.x * tb.y - ta.y * tb.x;
    const glm::dvec3 alongU = (a * tb.y - b * ta.y) / det;
    const glm::dvec3 up = -(b * ta.x - a * tb.x) / det;
    const glm::dvec3 tangent = glm::normalize(alongU - n * glm::dot(n, alongU));
    glm::dvec3 bitangent = glm::cross(n, tangent);
    bitangent *= glm::dot(bitangent, up) < 0. ? -1. : 1.;
    const glm::dvec3 mapped = Mapped(image, { uv.x, 1. - uv.y });
    return glm::normalize(tangent * mapped.x + bitangent * mapped.y + n * mapped.z);
  }
};

struct Errors
{
  double Mean = 0., Worst = 0., Bent = 0.; // degrees; Bent: how far the map bends normals, mean
};

// The map's normals as floats, which count as they are.
vtkSmartPointer<vtkImageData> AsFloats(vtkImageData* image)
{
  auto floats = vtkSmartPointer<vtkImageData>::New();
  floats->SetDimensions(image->GetDimensions());
  vtkDataArray* bytes = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < bytes->GetNumberOfTuples(); ++i)
  {
    const glm::dvec3 n = 2. * Tuple3(bytes, i) / 255. - 1.;
    values->InsertNextTuple3(n.x, n.y, n.z);
  }
  floats->GetPointData()->SetScalars(values);
  return floats;
}

// `mesh` is drawn with `map`; the truth is computed from `file`, with the same cells, and `image`.
Errors ErrorsOf(vtkPolyData* mesh, vtkImageData* map, vtkPolyData* file, vtkImageData* image)
{
  Stage stage(Size, Size);
  const vtkSmartPointer<vtkActor> actor = AddActor(stage.Renderer, mesh);
  const GLCheck watch(stage.Window);
  double bounds[6];
  mesh->GetBounds(bounds);
  const double middle[2] = { (bounds[0] + bounds[1]) / 2., (bounds[2] + bounds[3]) / 2. };
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(middle[0], middle[1], bounds[5] + 5.);
  camera->SetFocalPoint(middle[0], middle[1], bounds[5]);
  camera->SetViewUp(0., 1., 0.);
  camera->SetClippingRange(1., 10.);
  camera->SetParallelScale(0.05 * (bounds[3] - bounds[2])); // some pixels to the texel

  vtkNew<vtkRelievoMaterial> material;
  material->SetNormalMap(map);
  material->SetTextureScale(1., -1.); // glTF counts v downwards from the image's top
  material->SetTextureOffset(0., 1.);
  material->Attach(actor);
  const Layers layers(stage.Renderer, { "cell", "position", "normal" });
  material->Detach(actor);
  Errors errors;
  int count = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const int cell = layers.Id("cell", x, y);
      if (cell < 0)
      {
        continue;
      }
      const Face face(file, cell);
      const glm::dvec3 truth = face.Truth(layers.Vector("position", x, y), image);
      const glm::dvec3 seen = layers.Vector("normal", x, y);
      const double degrees = 57.295779513082320877 *
        std::atan2(glm::length(glm::cross(seen, truth)), glm::dot(seen, truth));
      errors.Mean += degrees;
      errors.Worst = std::max(errors.Worst, degrees);
      errors.Bent += 57.295779513082320877 * std::acos(std::min(1., glm::dot(truth, face.N[0])));
      ++count;
    }
  }
  RELIEVO_CHECK(count > Size * Size / 2);
  errors.Mean /= count;
  errors.Bent /= count;
  return errors;
}

void TestTexture(vtkPolyData* mesh, vtkImageData* image, const std::string& name)
{
  if (!RELIEVO_CHECK(
        image && image->GetNumberOfPoints() > 1 && image->GetScalarType() == VTK_UNSIGNED_CHAR))
  {
    return;
  }
  // Graphics cards may mix bytes to bytes: half a step of 1 / 255 is 0.2 degrees.
  const Errors bytes = ErrorsOf(mesh, image, mesh, image);
  RELIEVO_CHECK_AT_MOST(bytes.Mean, 0.3, name + ": mean, degrees");
  RELIEVO_CHECK_AT_MOST(bytes.Worst, 1., name + ": worst, degrees");
  RELIEVO_CHECK_AT_MOST(10., bytes.Bent, name + ": ten degrees, against what the map bends by");
  const vtkSmartPointer<vtkImageData> floats = AsFloats(image);
  const Errors exact = ErrorsOf(mesh, floats, mesh, image);
  RELIEVO_CHECK_AT_MOST(exact.Mean, 0.02, name + " as floats: mean, degrees");
  vtkNew<vtkRelievoTangents> tangents;
  tangents->SetInputData(mesh);
  tangents->Update();
  const Errors smooth = ErrorsOf(tangents->GetOutput(), floats, mesh, image);
  RELIEVO_CHECK_AT_MOST(
    smooth.Mean, 0.2, name + " as floats, vtkRelievoTangents against faces: mean, degrees");
}

void TestModel()
{
  const std::string path = DataFile("ClearCoatTest/ClearCoatTest.gltf");
  if (path.empty())
  {
    return;
  }
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(path.c_str());
  {
    // The model's clear coats, which VTK leaves out.
    const ExpectMessage expect("KHR_materials_clearcoat");
    reader->Update();
  }
  // The first mesh with each of the images.
  std::map<vtkImageData*, vtkPolyData*> images;
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(reader->GetOutput()->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    vtkPolyData* mesh = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    vtkDataArray* index = mesh ? mesh->GetFieldData()->GetArray("NormalTextureIndex") : nullptr;
    if (index)
    {
      const auto texture = static_cast<vtkIdType>(index->GetComponent(0, 0));
#ifdef RELIEVO_VTK_GLTF_TEXTURE_OBJECTS
      images.emplace(reader->GetTexture(texture)->Image.GetPointer(), mesh);
#else
      images.emplace(reader->GetGLTFTexture(texture).Image.GetPointer(), mesh);
#endif
    }
  }
  RELIEVO_CHECK_THAT(images.size() == 2, "images: " + std::to_string(images.size()));
  for (const auto& [image, mesh] : images)
  {
    TestTexture(mesh, image, std::to_string(image->GetDimensions()[0]) + " texels");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMaterialGLTF)
{
  // Made once by VTK and kept until the process ends: not to be counted as forgotten.
  {
    vtkNew<vtkImageReader2Collection> readers;
    vtkImageReader2Factory::GetRegisteredReaders(readers);
  }
  Session session;
  TestModel();
  return session.Result();
}
}
