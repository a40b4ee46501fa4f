// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFormulas.h"
#include "vtkRelievoGltfGeometry.h"
#include "vtkRelievoModelFacets.h"
#include "vtkRelievoSkinNames.h"
#include "vtkRelievoSkinOrigin.h"
#include "vtkRelievoVTKVersions.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace relievo
{
namespace
{
// Without an inverse, a pose cannot lead back to the file's points.
bool IsFlat(const glm::dmat4& place)
{
  const glm::dmat3 axes(place);
  const double size = glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
  return !(std::abs(glm::determinant(axes)) > 1e-12 * size) || size < 1e-30;
}

vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, int components, std::size_t count)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

// Arrays shared by all nodes with this primitive.
struct SharedArrays
{
  vtkSmartPointer<vtkFloatArray> Coordinates;
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  vtkSmartPointer<vtkIntArray> Joints; // of points that follow their node
  vtkSmartPointer<vtkFloatArray> Weights;
};

// The points' colours times the base colour, as VTK's shader expects; alpha is not multiplied.
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(
  const GltfGeometry& geometry, const ModelMaterial& material)
{
  if (geometry.Colors.empty())
  {
    return nullptr;
  }
  // VTK's PBR decodes by a power, and unlit colours are multiplied with a texture's coded texels;
  // those of other unlit surfaces are drawn as they are.
  const bool drawn = material.IsUnlit && material.BaseColorTexture.Image.empty();
  const bool coded = material.IsUnlit || RELIEVO_VTK_PBR_SRGB_VERTEX_COLORS;
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("RGBA");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(geometry.Colors.size()));
  unsigned char* to = colors->GetPointer(0);
  for (const glm::dvec4& own : geometry.Colors)
  {
    const glm::dvec4 color = own * glm::dvec4(glm::dvec3(material.BaseColor), 1.);
    for (int i = 0; i < 3; ++i)
    {
      const double level = drawn ? f64::relievoSrgbFromLinear(color[i])
        : coded                  ? std::pow(color[i], 1. / 2.2)
                                 : color[i];
      *to++ = static_cast<unsigned char>(std::lround(255. * std::clamp(level, 0., 1.)));
    }
    const double alpha = material.Alpha == AlphaMode::Opaque ? 1. : color.a;
    *to++ = static_cast<unsigned char>(std::lround(255. * std::clamp(alpha, 0., 1.)));
  }
  return colors;
}

SharedArrays MakeShared(const GltfGeometry& geometry, const ModelMaterial& material)
{
  SharedArrays shared;
  if (!geometry.Coordinates.empty())
  {
    shared.Coordinates = MakeArray("TextureCoordinates", 2, geometry.Coordinates.size());
    for (std::size_t i = 0; i < geometry.Coordinates.size(); ++i)
    {
      shared.Coordinates->SetTuple2(
        static_cast<vtkIdType>(i), geometry.Coordinates[i].x, geometry.Coordinates[i].y);
    }
  }
  else if (material.Emission != glm::dvec3(0.) && !material.IsUnlit)
  {
    // VTK's shader adds emission only from a texture, which then has one texel.
    shared.Coordinates = MakeArray("TextureCoordinates", 2, geometry.Points.size());
    shared.Coordinates->Fill(0.5);
  }
  shared.Colors = MakeColors(geometry, material);
  shared.Joints = vtkSmartPointer<vtkIntArray>::New();
  shared.Joints->SetName(JointsArray);
  shared.Joints->SetNumberOfTuples(static_cast<vtkIdType>(geometry.Points.size()));
  shared.Joints->Fill(0.);
  shared.Weights = MakeArray(WeightsArray, 1, geometry.Points.size());
  shared.Weights->Fill(1.);
  return shared;
}

// Whether floats would lose digits of the file: far from the origin, at rest or at the joints.
bool IsFar(const GltfGeometry& geometry, const glm::dmat4& place, const GltfSkin* skin,
  const std::vector<glm::dmat4>& worlds)
{
  SkinBox box;
  for (const glm::dvec3& point : geometry.Points)
  {
    box.Add(glm::dvec3(place * glm::dvec4(point, 1.)));
  }
  bool far = GetFarOrigin(box, 1000.) != glm::dvec3(0.);
  for (std::size_t i = 0; skin && i < skin->Nodes.size() && !far; ++i)
  {
    const glm::dmat4 m = worlds[static_cast<std::size_t>(skin->Nodes[i])] * skin->Offsets[i];
    SkinBox moved;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 at((corner & 1 ? box.High : box.Low).x, (corner & 2 ? box.High : box.Low).y,
        (corner & 4 ? box.High : box.Low).z);
      moved.Add(glm::dvec3(m * glm::dvec4(at, 1.)));
    }
    far = GetFarOrigin(moved, 1000.) != glm::dvec3(0.);
  }
  return far;
}

glm::dvec3 GetUnit(const glm::dvec3& v, const glm::dvec3& otherwise)
{
  const double length = glm::length(v);
  return std::isfinite(length) && length > 0. ? v / length : otherwise;
}

void AddDirections(const GltfGeometry& geometry, const glm::dmat4& place, vtkPolyData* output)
{
  const glm::dmat3 axes(place);
  const glm::dmat3 turn = f64::relievoNormalMatrix(axes);
  if (!geometry.Normals.empty())
  {
    const auto normals = MakeArray("Normals", 3, geometry.Normals.size());
    for (std::size_t i = 0; i < geometry.Normals.size(); ++i)
    {
      const glm::dvec3 n = GetUnit(turn * geometry.Normals[i], glm::dvec3(0., 0., 1.));
      normals->SetTuple3(static_cast<vtkIdType>(i), n.x, n.y, n.z);
    }
    output->GetPointData()->SetNormals(normals);
  }
  if (!geometry.Tangents.empty())
  {
    // The bitangent points towards growing v.
    const auto tangents = MakeArray("Tangents", 3, geometry.Tangents.size());
    for (std::size_t i = 0; i < geometry.Tangents.size(); ++i)
    {
      const glm::dvec3 t = GetUnit(axes * glm::dvec3(geometry.Tangents[i]), glm::dvec3(1., 0., 0.));
      tangents->SetTuple3(static_cast<vtkIdType>(i), t.x, t.y, t.z);
    }
    output->GetPointData()->SetTangents(tangents);
  }
}

void AddCells(const GltfGeometry& geometry, bool turned, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(geometry.Corners.size());
  const vtkIdType size = geometry.CellSize;
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count / size + 1);
  for (vtkIdType i = 0; i <= count / size; ++i)
  {
    offsets->SetValue(i, i * size);
  }
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(count);
  std::copy(geometry.Corners.begin(), geometry.Corners.end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  if (size == 1)
  {
    output->SetVerts(cells);
  }
  else if (size == 2)
  {
    output->SetLines(cells);
  }
  else
  {
    output->SetPolys(cells);
    if (turned)
    {
      TurnFaces(output);
    }
  }
}

// The offsets of morph targets for points and directions transformed by a node.
std::vector<ModelMorph> PlaceTargets(const GltfGeometry& geometry, const glm::dmat4& place)
{
  const glm::dmat3 axes(place);
  const glm::dmat3 turn = f64::relievoNormalMatrix(axes);
  const auto add = [](std::vector<float>& to, const glm::dvec3& v) {
    for (int i = 0; i < 3; ++i)
    {
      to.push_back(std::isfinite(v[i]) ? static_cast<float>(v[i]) : 0.f);
    }
  };
  std::vector<ModelMorph> morphs;
  for (const GltfTarget& target : geometry.Targets)
  {
    ModelMorph morph;
    for (const glm::dvec3& change : target.Points)
    {
      add(morph.Points, axes * change);
    }
    // Directions at rest have length 1: their offsets are scaled equally.
    for (std::size_t i = 0; i < target.Normals.size(); ++i)
    {
      const double length = glm::length(turn * geometry.Normals[i]);
      add(morph.Normals, turn * target.Normals[i] / (length > 0. ? length : 1.));
    }
    for (std::size_t i = 0; i < target.Tangents.size(); ++i)
    {
      const double length = glm::length(axes * glm::dvec3(geometry.Tangents[i]));
      add(morph.Tangents, axes * target.Tangents[i] / (length > 0. ? length : 1.));
    }
    morphs.push_back(std::move(morph));
  }
  return morphs;
}

void AddField(const char* name, std::initializer_list<double> numbers, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(numbers.size()));
  std::vector<float> values(numbers.begin(), numbers.end());
  array->InsertNextTuple(values.data());
  output->GetFieldData()->AddArray(array);
}

void AddField(const char* name, const std::string& text, vtkPolyData* output)
{
  if (!text.empty())
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    output->GetFieldData()->AddArray(array);
  }
}

void AddFields(const ModelMaterial& material, vtkPolyData* output)
{
  const glm::dvec4& color = material.BaseColor;
  AddField("base_color", { color.r, color.g, color.b, color.a }, output);
  AddField("base_color_texture", material.BaseColorTexture.Image, output);
  AddField("normal_texture", material.NormalTexture.Image, output);
  if (!material.NormalTexture.Image.empty())
  {
    AddField("normal_strength", { material.NormalScale }, output);
  }
}

// A node that shows a primitive.
struct Showing
{
  std::size_t Node; // in the file
  int Number = 0;   // in the model
  const GltfSkin* Skin = nullptr;
  std::string Name;
};

class MeshMaker
{
public:
  MeshMaker(GltfDocument& document, const GltfNodes& nodes, int weights, Model& result)
    : Document(document)
    , Nodes(nodes)
    , Weights(weights)
    , Result(result)
  {
    std::vector<glm::dmat4> locals;
    for (const ModelNode& node : result.Nodes)
    {
      locals.push_back(node.Rest);
    }
    this->Worlds = GetWorldMatrices(result.Nodes, locals);
  }

  ModelMesh Make(const GltfValue& primitive, GltfGeometry& geometry, const SharedArrays& shared,
    const Showing& at)
  {
    const ModelMaterial& material = this->Result.Materials[geometry.Material];
    const glm::dmat4& world = this->Worlds[static_cast<std::size_t>(at.Number)];
    const bool isSkinned = at.Skin && !geometry.Influences.empty();
    const bool isFlat = IsFlat(world);
    const glm::dmat4 place = isSkinned || isFlat ? glm::dmat4(1.) : world;
    ModelMesh mesh;
    mesh.Name = at.Name;
    mesh.Node = at.Number;
    mesh.Material = static_cast<int>(geometry.Material);
    mesh.IsPlaced = !isSkinned && !isFlat;
    mesh.IsSkinned = isSkinned;
    mesh.IsFaceted = geometry.IsFaceted();
    mesh.Data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(
      IsFar(geometry, place, isSkinned ? at.Skin : nullptr, this->Worlds) ? VTK_DOUBLE : VTK_FLOAT);
    points->SetNumberOfPoints(static_cast<vtkIdType>(geometry.Points.size()));
    for (std::size_t i = 0; i < geometry.Points.size(); ++i)
    {
      const glm::dvec4 moved = place * glm::dvec4(geometry.Points[i], 1.);
      points->SetPoint(static_cast<vtkIdType>(i), moved.x, moved.y, moved.z);
    }
    mesh.Data->SetPoints(points);
    AddCells(geometry, glm::determinant(glm::dmat3(place)) < 0., mesh.Data);
    AddDirections(geometry, place, mesh.Data);
    if (mesh.IsFaceted)
    {
      GiveFaceNormals(mesh.Data);
    }
    if (shared.Coordinates)
    {
      mesh.Data->GetPointData()->SetTCoords(shared.Coordinates);
    }
    if (shared.Colors)
    {
      mesh.Data->GetPointData()->AddArray(shared.Colors);
    }
    AddFields(material, mesh.Data);
    mesh.Morphs = PlaceTargets(geometry, place);
    ModelBones bones;
    if (isSkinned)
    {
      this->AddJoints(primitive, geometry, at, bones, mesh);
    }
    else
    {
      bones.Add(at.Number, isFlat ? glm::dmat4(1.) : glm::inverse(world));
      bones.GiveTo(mesh.Data);
      mesh.Data->GetPointData()->AddArray(shared.Joints);
      mesh.Data->GetPointData()->AddArray(shared.Weights);
    }
    return mesh;
  }

private:
  void AddJoints(const GltfValue& primitive, GltfGeometry& geometry, const Showing& at,
    ModelBones& bones, ModelMesh& mesh)
  {
    const auto joints = static_cast<int>(at.Skin->Nodes.size());
    for (std::size_t i = 0; i < at.Skin->Nodes.size(); ++i)
    {
      this->Result.Nodes[static_cast<std::size_t>(at.Skin->Nodes[i])].IsBone = true;
      bones.Add(at.Skin->Nodes[i], at.Skin->Offsets[i]);
    }
    for (const std::vector<ModelInfluence>& own : geometry.Influences)
    {
      for (const ModelInfluence& influence : own)
      {
        if (influence.Bone >= joints)
        {
          primitive.Get("attributes")
            .Fail("name joint " + std::to_string(influence.Bone) + ", and the skin of nodes[" +
              std::to_string(at.Node) + "] has " + std::to_string(joints) + " joints");
        }
      }
    }
    ModelWeightFaults faults = geometry.Faults;
    std::vector<std::vector<ModelInfluence>> influences = geometry.Influences;
    GiveWeights(mesh.Name, this->Weights, influences, bones, at.Number, glm::dmat4(1.), false,
      faults, mesh.Data, this->Result);
  }

  GltfDocument& Document;
  const GltfNodes& Nodes;
  int Weights;
  Model& Result;
  std::vector<glm::dmat4> Worlds;
};

// A mesh's weights at rest, which its node can override.
void ReadWeights(const GltfValue& node, int number, const GltfValue& mesh, Model& model)
{
  const GltfValue primitives = mesh.Get("primitives");
  const std::size_t count =
    primitives.GetSize() > 0 ? primitives.At(0).Get("targets").GetSize() : 0;
  const GltfValue given = node.Get("weights").IsThere() ? node.Get("weights") : mesh.Get("weights");
  for (std::size_t i = 0; i < primitives.GetSize(); ++i)
  {
    const GltfValue targets = primitives.At(i).Get("targets");
    if (targets.GetSize() != count)
    {
      primitives.At(i).Fail("has " + std::to_string(targets.GetSize()) +
        " targets, and the mesh's first primitive has " + std::to_string(count) +
        "; expected as many");
    }
  }
  if (count == 0)
  {
    return;
  }
  const std::vector<double> numbers = given.GetNumbers(std::vector<double>(count, 0.));
  model.Weights.resize(model.Nodes.size());
  model.Weights[static_cast<std::size_t>(number)] = ModelWeights(numbers.data(), numbers.size());
}

// Throws before memory is allocated.
void CheckSize(const GltfDocument& document, const GltfValue& primitive, std::size_t nodes,
  std::size_t& allPoints, std::size_t& allCorners)
{
  std::size_t points = 0;
  std::size_t corners = 0;
  CountGltfGeometry(document, primitive, points, corners);
  const auto check = [&](std::size_t own, std::size_t most, std::size_t& all, const char* what) {
    if (own > most || (own > 0 && nodes > (most - std::min(all, most)) / own))
    {
      primitive.Fail("has " + std::to_string(own) + " " + what + " and is shown by " +
        std::to_string(nodes) + " nodes; at most " + std::to_string(most) +
        " are read of a file, with those of morph targets");
    }
    all += own * nodes;
  };
  check(points, gltf::MostPoints, allPoints, "points");
  check(corners, gltf::MostCorners, allCorners, "corners");
}
}

//------------------------------------------------------------------------------
void ReadGltfMeshes(GltfDocument& document, const GltfNodes& nodes, int weights,
  const std::function<bool(double)>& progress, Model& model)
{
  const GltfValue meshes = document.Get("meshes");
  const GltfValue skins = document.Get("skins");
  std::vector<std::vector<Showing>> showings(meshes.GetSize());
  std::map<int, GltfSkin> skinsRead;
  std::map<int, std::size_t> order; // by the model's nodes
  for (const int place : nodes.Shown)
  {
    const auto i = static_cast<std::size_t>(place);
    const GltfValue node = document.Get("nodes").At(i);
    const int mesh = node.Get("mesh").GetIndex("meshes", meshes.GetSize());
    const int skin = node.Get("skin").GetIndex("skins", skins.GetSize());
    if (mesh < 0)
    {
      continue;
    }
    Showing showing;
    showing.Node = i;
    showing.Number = nodes.Get(i);
    if (skin >= 0)
    {
      const auto known = skinsRead.find(skin);
      showing.Skin = known != skinsRead.end()
        ? &known->second
        : &skinsRead.emplace(skin, ReadGltfSkin(document, nodes, static_cast<std::size_t>(skin)))
             .first->second;
    }
    const GltfValue value = meshes.At(static_cast<std::size_t>(mesh));
    showing.Name = value.Get("name").GetText("");
    showing.Name = showing.Name.empty() ? model.Nodes[static_cast<std::size_t>(showing.Number)].Name
                                        : showing.Name;
    ReadWeights(node, showing.Number, value, model);
    order.emplace(showing.Number, order.size());
    showings[static_cast<std::size_t>(mesh)].push_back(showing);
  }
  std::size_t points = 0;
  std::size_t corners = 0;
  for (std::size_t i = 0; i < showings.size(); ++i)
  {
    const GltfValue primitives = meshes.At(i).Get("primitives");
    for (std::size_t j = 0; j < primitives.GetSize() && !showings[i].empty(); ++j)
    {
      CheckSize(document, primitives.At(j), showings[i].size(), points, corners);
    }
  }
  MeshMaker maker(document, nodes, weights, model);
  for (std::size_t i = 0; i < showings.size(); ++i)
  {
    const GltfValue primitives = meshes.At(i).Get("primitives");
    for (std::size_t j = 0; j < primitives.GetSize() && !showings[i].empty(); ++j)
    {
      GltfGeometry geometry = ReadGltfGeometry(document, primitives.At(j), model);
      if (geometry.Points.empty())
      {
        continue;
      }
      const SharedArrays shared = MakeShared(geometry, model.Materials[geometry.Material]);
      for (const Showing& showing : showings[i])
      {
        model.Meshes.push_back(maker.Make(primitives.At(j), geometry, shared, showing));
      }
    }
    document.Forget();
    if (!progress(0.1 + 0.8 * static_cast<double>(i + 1) / static_cast<double>(showings.size())))
    {
      throw GltfError("reading it was stopped");
    }
  }
  // In the order of the scene's nodes.
  std::stable_sort(model.Meshes.begin(), model.Meshes.end(),
    [&order](const ModelMesh& a, const ModelMesh& b) { return order[a.Node] < order[b.Node]; });
}
}
