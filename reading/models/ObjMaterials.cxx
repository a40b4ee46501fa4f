// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObjMaterials.h"

#include "Actors.h"
#include "Errors.h"
#include "Images.h"
#include "MaterialMaps.h"
#include "MtlLibrary.h"
#include "ReadContext.h"
#include "Readers.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAllowedFolders.h"
#include "vtkStringArray.h"
#include "vtkTexture.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace reading
{
namespace
{
const char* const CellIds = "vtkOriginalCellIds";
const char* const PolygonIds = "vtkRelievoPolygonIds";

//------------------------------------------------------------------------------
std::vector<std::string> GetStrings(vtkPolyData* mesh, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name));
  std::vector<std::string> strings;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    strings.push_back(array->GetValue(i));
  }
  return strings;
}

//------------------------------------------------------------------------------
std::map<std::string, MtlMaterial> ReadLibraries(const std::vector<std::string>& libraries,
  const std::string& path, const vtkRelievoAllowedFolders& allowed, ReadContext& context)
{
  std::map<std::string, MtlMaterial> materials;
  const auto read = [&](const std::string& name) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return ReadMtlLibrary(FindNamedFile(name, folder, allowed), allowed, materials, context);
  };
  for (const std::string& line : libraries)
  {
    // One name, which may contain blanks, or several names.
    const std::string ofLine = read(line);
    if (ofLine.empty())
    {
      continue;
    }
    std::istringstream words(line);
    std::vector<std::pair<std::string, std::string>> unread;
    std::size_t count = 0;
    for (std::string name; words >> name; ++count)
    {
      if (const std::string ofName = read(name); !ofName.empty())
      {
        unread.emplace_back(name, ofName);
      }
    }
    if (unread.size() == count)
    {
      unread = { { line, ofLine } };
    }
    for (const auto& [name, reason] : unread)
    {
      context.Note(path + ": drawn without the materials of " + name + ": " + reason);
    }
  }
  return materials;
}

// Several scanners write Tr 1 without d for opaque materials.
void MendTransparency(
  std::map<std::string, MtlMaterial>& materials, const std::string& path, ReadContext& context)
{
  std::string first;
  int count = 0;
  for (auto& [name, material] : materials)
  {
    if (!material.Dissolves && material.Opacity == 0.0)
    {
      material.Opacity = 1.0;
      first = count++ == 0 ? name : first;
    }
  }
  if (count > 0)
  {
    context.Note(path + ": drawn as opaque in spite of Tr 1, as several scanners mean it: " +
      std::to_string(count) + (count == 1 ? " material" : " materials, such as") + " '" + first +
      "'; d 0 makes one invisible");
  }
}

//------------------------------------------------------------------------------
vtkIdTypeArray* GetIds(vtkPolyData* mesh, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(name));
}

// Extracts these cells; `vtkOriginalCellIds` gives their numbers in the file, and
// `vtkRelievoPolygonIds` counts the part's own polygons.
vtkSmartPointer<vtkPolyData> Extract(vtkPolyData* mesh, const std::vector<vtkIdType>& cells)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(mesh->GetPoints());
  part->GetPointData()->ShallowCopy(mesh->GetPointData());
  const auto count = static_cast<vtkIdType>(cells.size());
  part->AllocateEstimate(count, 4);
  part->GetCellData()->CopyAllocate(mesh->GetCellData(), count);
  vtkNew<vtkIdTypeArray> original;
  original->SetName(CellIds);
  vtkNew<vtkIdTypeArray> own;
  own->SetName(PolygonIds);
  vtkIdTypeArray* polygons = GetIds(mesh, PolygonIds);
  vtkIdTypeArray* before = GetIds(mesh, CellIds) ? GetIds(mesh, CellIds) : polygons;
  vtkNew<vtkIdList> points;
  vtkIdType last = -1;
  vtkIdType number = -1;
  for (const vtkIdType cell : cells)
  {
    mesh->GetCellPoints(cell, points);
    const vtkIdType next = part->InsertNextCell(mesh->GetCellType(cell), points);
    part->GetCellData()->CopyData(mesh->GetCellData(), cell, next);
    original->InsertNextValue(before ? before->GetValue(cell) : cell);
    const vtkIdType polygon = polygons ? polygons->GetValue(cell) : cell;
    number += polygon != last ? 1 : 0;
    last = polygon;
    own->InsertNextValue(number);
  }
  part->GetCellData()->AddArray(original);
  if (polygons)
  {
    part->GetCellData()->AddArray(own);
  }
  return part;
}

//------------------------------------------------------------------------------
// VTK gives faces without texture coordinates 0 0 if other faces have some.
void DropFlatTextureCoordinates(vtkPolyData* part)
{
  vtkDataArray* coordinates = part->GetPointData()->GetTCoords();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; coordinates && cell < part->GetNumberOfCells(); ++cell)
  {
    part->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const double* place = coordinates->GetTuple2(corners->GetId(i));
      if (place[0] != 0. || place[1] != 0.)
      {
        return;
      }
    }
  }
  part->GetPointData()->SetTCoords(nullptr);
}

//------------------------------------------------------------------------------
// `key`: names the texture in messages.
void PutTexture(vtkActor* actor, const MtlMaterial& material, const std::string& key,
  const std::string& path, const vtkRelievoAllowedFolders& allowed, ReadContext& context)
{
  try
  {
    CheckAllowed(material.Texture, allowed);
    CheckImage(key, material.Texture);
    MaterialMaps maps;
    maps.Color = ReadImage(material.Texture, context);
    maps.Scale = material.TextureScale;
    maps.Offset = material.TextureOffset;
    if (!material.TextureWithout.empty())
    {
      context.Note(path + ": " + material.Texture + " is drawn without " + material.TextureWithout);
    }
    MaterialPainter().Put(actor, maps);
  }
  catch (const std::exception& error)
  {
    context.Note(path + ": drawn without a texture: " + error.what());
  }
}

//------------------------------------------------------------------------------
void ApplyMaterial(vtkActor* actor, const MtlMaterial& material, const std::string& path,
  const vtkRelievoAllowedFolders& allowed, ReadContext& context)
{
  vtkProperty* property = actor->GetProperty();
  property->SetDiffuseColor(material.Diffuse);
  property->SetSpecularColor(material.Specular);
  const double strongest = *std::max_element(material.Specular, material.Specular + 3);
  property->SetSpecular(material.Highlights && strongest > 0.0 ? 1.0 : 0.0);
  property->SetSpecularPower(material.Exponent);
  property->SetOpacity(material.Opacity);
  if (material.Texture.empty())
  {
    return;
  }
  PutTexture(actor, material, "map_Kd", path, allowed, context);
}
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkActor>> DrawTextured(
  vtkDataObject* surface, const std::string& path, ReadContext& context)
{
  auto* mesh = vtkPolyData::SafeDownCast(surface);
  const std::vector<std::string> names =
    mesh ? GetStrings(mesh, "TextureFiles") : std::vector<std::string>();
  if (ExtensionOf(path) != ".ply" || names.empty())
  {
    return {};
  }
  if (names.size() > 1 || !mesh->GetPointData()->GetTCoords())
  {
    context.Note(path + ": drawn without " +
      (names.size() > 1 ? "its " + std::to_string(names.size()) + " textures, expected one"
                        : names[0] + ", for want of texture coordinates"));
    return {};
  }
  const vtkRelievoAllowedFolders allowed = context.GetAllowed(path);
  // Vertex colours would multiply the texture; they remain as arrays.
  vtkNew<vtkPolyData> plain;
  plain->ShallowCopy(mesh);
  plain->GetPointData()->SetActiveScalars(nullptr);
  plain->GetCellData()->SetActiveScalars(nullptr);
  const vtkSmartPointer<vtkActor> actor = DrawSurface(plain);
  MtlMaterial material;
  material.Texture = FindNamedFile(names[0], std::filesystem::path(path).parent_path(), allowed);
  PutTexture(actor, material, "TextureFile", path, allowed, context);
  return actor->GetTexture() ? std::vector<vtkSmartPointer<vtkActor>>{ actor }
                             : std::vector<vtkSmartPointer<vtkActor>>();
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkActor>> SplitByMaterials(
  vtkDataObject* surface, const std::string& path, ReadContext& context)
{
  auto* mesh = vtkPolyData::SafeDownCast(surface);
  auto* ids =
    mesh ? vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("MaterialIds")) : nullptr;
  if (ExtensionOf(path) != ".obj" || !mesh)
  {
    return {};
  }
  const vtkRelievoAllowedFolders allowed = context.GetAllowed(path);
  auto materials = ReadLibraries(GetStrings(mesh, "MaterialLibraries"), path, allowed, context);
  MendTransparency(materials, path, context);
  if (!ids || materials.empty())
  {
    return {};
  }
  const std::vector<std::string> names = GetStrings(mesh, "MaterialNames");
  std::vector<std::vector<vtkIdType>> cellsOf(names.size() + 1); // first: without a material
  for (vtkIdType cell = 0; cell < ids->GetNumberOfValues(); ++cell)
  {
    cellsOf[static_cast<std::size_t>(ids->GetValue(cell) + 1)].push_back(cell);
  }
  std::vector<vtkSmartPointer<vtkActor>> parts;
  for (std::size_t i = 0; i < cellsOf.size(); ++i)
  {
    if (cellsOf[i].empty())
    {
      continue;
    }
    const vtkSmartPointer<vtkPolyData> cells = Extract(mesh, cellsOf[i]);
    DropFlatTextureCoordinates(cells);
    const vtkSmartPointer<vtkActor> part = DrawSurface(cells);
    const auto known = i > 0 ? materials.find(names[i - 1]) : materials.end();
    if (known != materials.end())
    {
      ApplyMaterial(part, known->second, path, allowed, context);
      if (known->second.Opacity == 0.0)
      {
        context.Note(path + ": the material '" + names[i - 1] + "' is invisible, by its d 0");
      }
    }
    else if (i > 0)
    {
      context.Note(path + ": no library has the material '" + names[i - 1] + "'");
    }
    parts.push_back(part);
  }
  return parts;
}
}
