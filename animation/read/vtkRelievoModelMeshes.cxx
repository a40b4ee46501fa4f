// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelParts.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoModelFacets.h"
#include "vtkRelievoSkinOrigin.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
bool IsFinite(const aiVector3D& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Whether the node puts the mesh so far from the origin that floats would lose digits.
bool IsFar(const aiMesh* mesh, const glm::dmat4& place)
{
  SkinBox box;
  for (unsigned int i = 0; i < mesh->mNumVertices; ++i)
  {
    const aiVector3D& v = mesh->mVertices[i];
    if (IsFinite(v))
    {
      box.Add(glm::dvec3(place * glm::dvec4(v.x, v.y, v.z, 1.)));
    }
  }
  return GetFarOrigin(box, 1000.) != glm::dvec3(0.);
}

void ReadPoints(const aiMesh* mesh, const std::string& name, const glm::dmat4& place,
  vtkPolyData* output, Model& model)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(IsFar(mesh, place) ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(mesh->mNumVertices);
  unsigned int unfit = 0;
  for (unsigned int i = 0; i < mesh->mNumVertices; ++i)
  {
    const aiVector3D& v = mesh->mVertices[i];
    const glm::dvec4 at =
      place * (IsFinite(v) ? glm::dvec4(v.x, v.y, v.z, 1.) : glm::dvec4(0., 0., 0., 1.));
    unfit += IsFinite(v) ? 0 : 1;
    points->SetPoint(i, at.x, at.y, at.z);
  }
  if (unfit > 0)
  {
    model.Notes.push_back("mesh '" + name + "': " + std::to_string(unfit) +
      " points are not finite, and lie at its origin");
  }
  output->SetPoints(points);
}

// Whether the mesh is one of Assimp's solid bones, made for files without meshes.
bool IsStandIn(const aiScene* scene, const aiMesh* mesh)
{
  return scene->mMaterials && mesh->mMaterialIndex < scene->mNumMaterials &&
    scene->mMaterials[mesh->mMaterialIndex]->GetName() == aiString("SkeletonMaterial");
}

// The normals of stand-ins point against their winding, so VTK would draw them black.
void ReadNormals(
  const aiScene* scene, const aiMesh* mesh, const glm::dmat4& place, vtkPolyData* output)
{
  const glm::dmat3 turned =
    f64::relievoNormalMatrix(glm::dmat3(place)) * (IsStandIn(scene, mesh) ? -1. : 1.);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(mesh->mNumVertices);
  for (unsigned int i = 0; i < mesh->mNumVertices; ++i)
  {
    const aiVector3D& v = mesh->mNormals[i];
    const glm::dvec3 n = turned * glm::dvec3(v.x, v.y, v.z);
    const double length = glm::length(n);
    const bool fit = std::isfinite(length) && length > 0.;
    normals->SetTuple3(
      i, fit ? n.x / length : 0., fit ? n.y / length : 0., fit ? n.z / length : 1.);
  }
  output->GetPointData()->SetNormals(normals);
}

void ReadCoordinatesAndColors(const aiMesh* mesh, vtkPolyData* output)
{
  if (mesh->HasTextureCoords(0))
  {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("TextureCoordinates");
    coordinates->SetNumberOfComponents(2);
    coordinates->SetNumberOfTuples(mesh->mNumVertices);
    for (unsigned int i = 0; i < mesh->mNumVertices; ++i)
    {
      coordinates->SetTuple2(i, mesh->mTextureCoords[0][i].x, mesh->mTextureCoords[0][i].y);
    }
    output->GetPointData()->SetTCoords(coordinates);
  }
  if (mesh->HasVertexColors(0))
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("RGBA");
    colors->SetNumberOfComponents(4);
    colors->SetNumberOfTuples(mesh->mNumVertices);
    const aiColor4D* first = mesh->mColors[0];
    const bool opaque =
      std::none_of(first, first + mesh->mNumVertices, [](const aiColor4D& c) { return c.a > 0.f; });
    for (unsigned int i = 0; i < mesh->mNumVertices; ++i)
    {
      const aiColor4D& c = first[i];
      const float parts[4] = { c.r, c.g, c.b, opaque ? 1.f : c.a }; // some writers leave alpha at 0
      for (int j = 0; j < 4; ++j)
      {
        const float level = std::isfinite(parts[j]) ? 255.f * parts[j] : 0.f;
        colors->SetTypedComponent(
          i, j, static_cast<unsigned char>(std::clamp(std::round(level), 0.f, 255.f)));
      }
    }
    output->GetPointData()->SetScalars(colors);
  }
}

// Reads faces by kind, leaving out those with missing points.
void ReadFaces(const aiMesh* mesh, const std::string& name, vtkPolyData* output, Model& model)
{
  vtkNew<vtkCellArray> cells[3];
  int invalid = 0;
  for (unsigned int i = 0; i < mesh->mNumFaces; ++i)
  {
    const aiFace& face = mesh->mFaces[i];
    const bool fit = face.mNumIndices > 0 &&
      std::all_of(face.mIndices, face.mIndices + face.mNumIndices,
        [mesh](unsigned int point) { return point < mesh->mNumVertices; });
    if (!fit)
    {
      ++invalid;
      continue;
    }
    vtkCellArray* kind = cells[std::min(face.mNumIndices, 3u) - 1u];
    kind->InsertNextCell(static_cast<int>(face.mNumIndices));
    for (unsigned int j = 0; j < face.mNumIndices; ++j)
    {
      kind->InsertCellPoint(face.mIndices[j]);
    }
  }
  output->SetVerts(cells[0]);
  output->SetLines(cells[1]);
  output->SetPolys(cells[2]);
  if (invalid > 0)
  {
    model.Notes.push_back("mesh '" + name + "': " + std::to_string(invalid) +
      " faces name points that are not there, and are left out");
  }
}
}

//------------------------------------------------------------------------------
void ReadMesh(const aiScene* scene, const aiMesh* mesh, int node, const glm::dmat4& place,
  const NodeNumbers& numbers, int weights, Model& model)
{
  if (!mesh->mVertices || mesh->mNumVertices == 0)
  {
    return;
  }
  ModelMesh result;
  result.Name = GetMeshName(mesh, node, model);
  result.Node = node;
  result.Data = vtkSmartPointer<vtkPolyData>::New();
  ReadPoints(mesh, result.Name, place, result.Data, model);
  if (mesh->HasNormals())
  {
    ReadNormals(scene, mesh, place, result.Data);
  }
  ReadCoordinatesAndColors(mesh, result.Data);
  ReadFaces(mesh, result.Name, result.Data, model);
  if (glm::determinant(glm::dmat3(place)) < 0.)
  {
    TurnFaces(result.Data);
  }
  if (scene->mMaterials && mesh->mMaterialIndex < scene->mNumMaterials)
  {
    ReadMaterial(scene, scene->mMaterials[mesh->mMaterialIndex], result.Data, model);
  }
  ReadBones(mesh, node, place, numbers, weights, result.Data, model);
  model.Meshes.push_back(result);
}
}
