// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObjMaterials.h"

#include "Errors.h"
#include "Images.h"
#include "Messages.h"
#include "MtlLibrary.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoMaterial.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace scene
{
namespace
{
const char* const CellIds = "vtkOriginalCellIds";

//------------------------------------------------------------------------------
// What an OBJ file says of materials. VTK's reader has it as well, but forgets the first one of
// faces without texture coordinates.
struct Named
{
  std::vector<std::string> Libraries;
  std::vector<std::string> Names;
  std::vector<int> OfFace; // place in Names; -1: none
};

Named ReadNames(const std::string& path)
{
  Named named;
  int current = -1;
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);)
  {
    line.erase(0, line.find_first_not_of(" \t"));
    const std::string::size_type end = std::min(line.find_first_of(" \t"), line.size());
    const std::string word = line.substr(0, end);
    if (word == "f")
    {
      named.OfFace.push_back(current);
    }
    else if (word == "usemtl")
    {
      const std::string name = TrimLine(line.substr(end));
      const auto known = std::find(named.Names.begin(), named.Names.end(), name);
      current = static_cast<int>(known - named.Names.begin());
      if (known == named.Names.end())
      {
        named.Names.push_back(name);
      }
    }
    else if (word == "mtllib")
    {
      named.Libraries.push_back(TrimLine(line.substr(end)));
    }
  }
  return named;
}

//------------------------------------------------------------------------------
std::map<std::string, MtlMaterial> ReadLibraries(
  const std::vector<std::string>& libraries, const std::string& path)
{
  std::map<std::string, MtlMaterial> materials;
  const auto read = [&](const std::string& name) {
    const std::filesystem::path library = std::filesystem::path(path).parent_path() / name;
    std::error_code trouble;
    const bool there = std::filesystem::is_regular_file(library, trouble);
    if (there)
    {
      ReadMtlLibrary(library.string(), materials);
    }
    return there;
  };
  for (const std::string& line : libraries)
  {
    // One name, which may have blanks, or several names.
    if (read(line))
    {
      continue;
    }
    std::istringstream names(line);
    for (std::string name; names >> name;)
    {
      if (!read(name))
      {
        Messages::Note(path + ": drawn without the materials of " + line + ", which is not there");
        break;
      }
    }
  }
  return materials;
}

//------------------------------------------------------------------------------
// These cells; `vtkOriginalCellIds` says which they are in the file.
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
  auto* before = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray(CellIds));
  vtkNew<vtkIdList> points;
  for (const vtkIdType cell : cells)
  {
    mesh->GetCellPoints(cell, points);
    const vtkIdType next = part->InsertNextCell(mesh->GetCellType(cell), points);
    part->GetCellData()->CopyData(mesh->GetCellData(), cell, next);
    original->InsertNextValue(before ? before->GetValue(cell) : cell);
  }
  part->GetCellData()->AddArray(original);
  return part;
}

//------------------------------------------------------------------------------
// Of each cell of the mesh, which may lack some of the file's; empty if VTK reads other faces than
// the file lists.
std::vector<int> FindMaterials(vtkPolyData* mesh, vtkPolyData* file, const std::vector<int>& ofFace)
{
  // VTK counts points and lines before faces.
  const vtkIdType others = file->GetNumberOfVerts() + file->GetNumberOfLines();
  if (file->GetNumberOfCells() != others + static_cast<vtkIdType>(ofFace.size()))
  {
    return {};
  }
  auto* before = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray(CellIds));
  std::vector<int> ofCell(mesh->GetNumberOfCells(), -1);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const vtkIdType inFile = before ? before->GetValue(cell) : cell;
    if (inFile >= others)
    {
      ofCell[cell] = ofFace[inFile - others];
    }
  }
  return ofCell;
}

//------------------------------------------------------------------------------
void Wear(vtkActor* actor, const MtlMaterial& material, const std::string& path, Progress& progress)
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
  try
  {
    CheckImage("map_Kd", material.Texture);
    const vtkSmartPointer<vtkImageData> image = ReadImage(material.Texture, progress);
    const vtkSmartPointer<vtkTexture> texture = MakeTexture(image);
    const auto& [scaleU, scaleV] = material.TextureScale;
    const auto& [offsetU, offsetV] = material.TextureOffset;
    if (scaleU != 1.0 || scaleV != 1.0 || offsetU != 0.0 || offsetV != 0.0)
    {
      vtkNew<vtkTransform> transform;
      transform->Translate(offsetU, offsetV, 0.0);
      transform->Scale(scaleU, scaleV, 1.0);
      texture->SetTransform(transform);
    }
    if (!material.TextureWithout.empty())
    {
      Messages::Note(
        path + ": " + material.Texture + " is drawn without " + material.TextureWithout);
    }
    actor->SetTexture(texture);
    if (const double cutoff = FindCutoff(image, actor))
    {
      vtkNew<vtkRelievoMaterial> cut;
      cut->SetAlphaCutoff(cutoff);
      cut->Attach(actor);
    }
  }
  catch (const std::exception& error)
  {
    Messages::Note(path + ": drawn without a texture: " + error.what());
  }
}
}

//------------------------------------------------------------------------------
std::vector<ObjPart> SplitByMaterials(
  vtkActor* actor, vtkDataObject* file, const std::string& path, Progress& progress)
{
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  auto* whole = vtkPolyData::SafeDownCast(file);
  if (ExtensionOf(path) != ".obj" || !mesh || !whole)
  {
    return {};
  }
  const Named named = ReadNames(path);
  const std::map<std::string, MtlMaterial> materials = ReadLibraries(named.Libraries, path);
  if (materials.empty())
  {
    return {};
  }
  const std::vector<int> ofCell = FindMaterials(mesh, whole, named.OfFace);
  if (ofCell.empty() && mesh->GetNumberOfCells() > 0)
  {
    Messages::Note(path + ": drawn without its materials: VTK reads other faces than are listed");
    return {};
  }
  std::vector<ObjPart> parts;
  std::vector<std::vector<vtkIdType>> cellsOf(named.Names.size() + 1); // the first: of none
  for (std::size_t cell = 0; cell < ofCell.size(); ++cell)
  {
    cellsOf[ofCell[cell] + 1].push_back(static_cast<vtkIdType>(cell));
  }
  for (int id = -1; id < static_cast<int>(named.Names.size()); ++id)
  {
    if (cellsOf[id + 1].empty())
    {
      continue;
    }
    const vtkSmartPointer<vtkPolyData> cells = Extract(mesh, cellsOf[id + 1]);
    const std::optional<std::string> material =
      id < 0 ? std::nullopt : std::optional(named.Names[id]);
    const std::string name = material.value_or("");
    // The reader has the coordinates of each material in an array of its name's first word.
    const std::string first = name.substr(0, name.find_first_of(" \t"));
    vtkDataArray* coordinates = cells->GetPointData()->GetArray(first.c_str());
    if (coordinates && coordinates->GetNumberOfComponents() == 2)
    {
      cells->GetPointData()->SetActiveTCoords(first.c_str());
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(cells);
    auto part = vtkSmartPointer<vtkActor>::New();
    part->SetMapper(mapper);
    part->GetProperty()->DeepCopy(actor->GetProperty());
    const auto known = materials.find(name);
    if (material && known != materials.end())
    {
      Wear(part, known->second, path, progress);
    }
    else if (material)
    {
      Messages::Note(path + ": no library has the material '" + name + "'");
    }
    parts.push_back({ part, material });
  }
  return parts;
}
}
