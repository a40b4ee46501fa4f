// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "DataSets.h"
#include "Errors.h"
#include "Messages.h"
#include "Outputs.h"
#include "Progress.h"
#include "ReadContext.h"
#include "Readers.h"
#include "SightFiles.h"
#include "Values.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoViewFactors.h"
#include "vtkStaticPointLocator.h"
#include "vtkTable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <sstream>

namespace cli
{
namespace
{
constexpr const char* Group = "group"; // the cell array of groups
const std::string Array = "array:";

// The number of each cell's connected part, from `first`, by places of points. Returns the number
// after the last.
int FindParts(vtkPolyData* mesh, int first, vtkIntArray* parts)
{
  if (mesh->GetNumberOfCells() == 0)
  {
    return first;
  }
  std::vector<vtkIdType> place(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  locator->MergePoints(0.0, place.data());
  std::vector<vtkIdType> root(place.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](vtkIdType point) {
    auto at = static_cast<std::size_t>(point);
    while (root[at] != static_cast<vtkIdType>(at))
    {
      at = static_cast<std::size_t>(root[at] = root[static_cast<std::size_t>(root[at])]);
    }
    return static_cast<vtkIdType>(at);
  };
  vtkNew<vtkIdList> points;
  const auto placeOf = [&](vtkIdType corner) {
    return place[static_cast<std::size_t>(points->GetId(corner))];
  };
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, points);
    for (vtkIdType corner = 1; corner < points->GetNumberOfIds(); ++corner)
    {
      root[static_cast<std::size_t>(find(placeOf(corner)))] = find(placeOf(0));
    }
  }
  std::map<vtkIdType, int> numbers;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, points);
    const vtkIdType part = points->GetNumberOfIds() > 0 ? find(placeOf(0)) : -1;
    parts->SetValue(
      cell, numbers.emplace(part, first + static_cast<int>(numbers.size())).first->second);
  }
  return first + static_cast<int>(numbers.size());
}

class ViewFactorsCommand : public Command
{
public:
  ViewFactorsCommand()
    : Command("view-factors", "FILE...",
        "view-factors finds the share of the light or heat that leaves one group of cells and "
        "arrives at another, by rays, with a bound of its error, and writes a table. Cells "
        "radiate and receive at their fronts, where their points run counter-clockwise.")
  {
    this->Rows.Files = words::Join(reading::GetExtensions(), "|");
    this->AddOutput("-o FILE.csv", "the table: from, to, factor, bound, area", this->File).Missing =
      "no file to write; give -o FILE.csv";
    this->AddOutput("--json FILE.json", "the factors as matrices", this->JSON);
    this->AddOutput("--mesh FILE.vtp",
      "the mesh with the cell arrays group, factors and bounds, with a component for each group",
      this->Mesh);
    this
      ->Add("--groups KIND",
        "files: each FILE is a group; parts: each connected part of the files; array:NAME: cells "
        "with equal whole numbers in this cell array; those with negative numbers have no group "
        "(files)",
        [this](const std::string& value) { this->TakeGroups(value); })
      .Words = { "files", "parts", Array };
    vtkRelievoOption& occluder = this->Add("--occluder FILE",
      "a mesh that hides groups from each other without being one; repeatable (none)",
      [this](const std::string& value) { this->Occluders.push_back(value); });
    occluder.Files = this->Rows.Files;
    occluder.Repeats = true;
    this->AddFolderOption();
    this->AddParameters(this->Factors->GetParameters(), { { "groups", "" } });
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->TakeMeshes(words);
    for (const std::string& file : this->Occluders)
    {
      reading::CheckExtension(file);
    }
    const reading::Messages::Scope scope;
    reading::Outputs outputs;
    std::vector<std::string> inputs = this->Names;
    inputs.insert(inputs.end(), this->Occluders.begin(), this->Occluders.end());
    for (const auto& [option, path] : { std::pair("-o", &this->File),
           std::pair("--json", &this->JSON), std::pair("--mesh", &this->Mesh) })
    {
      if (!path->empty())
      {
        outputs.Add(option, *path, inputs);
      }
    }
    reading::Progress progress;
    const vtkSmartPointer<vtkPolyData> mesh = this->ReadGroups(progress);
    this->Factors->SetGroups(Group);
    this->Factors->SetInputData(mesh);
    for (const std::string& file : this->Occluders)
    {
      this->Factors->AddInputDataObject(1, ReadMesh(file, this->AllowedFolders, progress));
    }
    progress.Begin("following rays");
    progress.Observe(this->Factors);
    this->Factors->Update();
    reading::Messages::Check("view-factors");
    this->TakeResult();
    WriteText(this->MakeTable(), "-o", this->File, outputs);
    if (!this->JSON.empty())
    {
      WriteText(this->MakeJSON(), "--json", this->JSON, outputs);
    }
    if (!this->Mesh.empty())
    {
      this->AddArrays(mesh);
      WriteMesh(mesh, "--mesh", this->Mesh, outputs, progress);
    }
    outputs.Commit();
    progress.End();
    double largest = 0.;
    for (const Row& row : this->Result)
    {
      largest = std::max(largest, *std::max_element(row.Bounds.begin(), row.Bounds.end()));
    }
    std::printf("%s: %zu group%s; errors of the factors are below %.2g with a confidence of 99.9 "
                "%%\n",
      this->File.c_str(), this->Result.size(), this->Result.size() == 1 ? "" : "s", largest);
    return 0;
  }

private:
  // The factors from a group: to nothing, to others, and to each group.
  struct Row
  {
    int Group;
    double Area;
    std::vector<double> Factors, Bounds;
  };

  void TakeGroups(const std::string& value)
  {
    const bool ofArray = value.rfind(Array, 0) == 0 && value.size() > Array.size();
    if (!ofArray && value != "files" && value != "parts")
    {
      words::RefuseValue("--groups", value, "files, parts or array:NAME");
    }
    this->Groups = value;
  }

  // The meshes of all files, with the array Group.
  vtkSmartPointer<vtkPolyData> ReadGroups(reading::Progress& progress)
  {
    for (const std::string& folder : this->AllowedFolders)
    {
      reading::CheckFolder(folder);
    }
    vtkNew<vtkAppendPolyData> all;
    bool found = false; // the array
    int next = 0;       // the number of the next group
    for (const std::string& file : this->Names)
    {
      reading::CheckReadable(file);
      reading::ReadContext context(progress, this->AllowedFolders);
      vtkIdType polygons = 0;
      reading::ForEachDataSet(
        reading::ReadSurface(file, false, false, context), [&](vtkDataSet* data) {
          vtkNew<vtkPolyData> piece;
          piece->CopyStructure(data);
          polygons += piece->GetNumberOfPolys() + piece->GetNumberOfStrips();
          vtkNew<vtkIntArray> groups;
          groups->SetName(Group);
          groups->SetNumberOfValues(piece->GetNumberOfCells());
          if (this->Groups == "files")
          {
            groups->Fill(next);
          }
          else if (this->Groups == "parts")
          {
            next = FindParts(piece, next, groups);
          }
          else
          {
            found = this->CopyGroups(data, file, groups) || found;
          }
          piece->GetCellData()->AddArray(groups);
          all->AddInputData(piece);
        });
      if (polygons == 0)
      {
        throw words::WorkError(file + ": it has no surface");
      }
      next += this->Groups == "files" ? 1 : 0;
    }
    if (this->Groups.rfind(Array, 0) == 0 && !found)
    {
      throw words::WorkError("--groups " + this->Groups + ": no file has such a cell array");
    }
    all->Update();
    return all->GetOutput();
  }

  // Whether the data have the array of groups.
  bool CopyGroups(vtkDataSet* data, const std::string& file, vtkIntArray* groups)
  {
    groups->Fill(-1);
    vtkDataArray* given = data->GetCellData()->GetArray(this->Groups.substr(Array.size()).c_str());
    if (!given)
    {
      return false;
    }
    for (vtkIdType cell = 0; cell < given->GetNumberOfTuples(); ++cell)
    {
      const double number = given->GetComponent(cell, 0);
      if (given->GetNumberOfComponents() != 1 || !(number <= VTK_INT_MAX) ||
        std::floor(number) != number)
      {
        std::ostringstream text;
        text << "--groups " << this->Groups << ": " << file << " has "
             << given->GetNumberOfComponents() << " component(s), such as " << number
             << ", expected a whole number for each cell";
        throw words::WorkError(text.str());
      }
      groups->SetValue(cell, number < 0. ? -1 : static_cast<int>(number));
    }
    return true;
  }

  // Takes the rows of the filter's table, which begin with others and nothing.
  void TakeResult()
  {
    vtkTable* table = this->Factors->GetOutput();
    const auto value = [table](vtkIdType row, const char* column) {
      return vtkDataArray::SafeDownCast(table->GetColumnByName(column))->GetComponent(row, 0);
    };
    for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
    {
      const auto from = static_cast<int>(value(i, "from"));
      if (this->Result.empty() || this->Result.back().Group != from)
      {
        this->Result.push_back({ from, value(i, "area"), {}, {} });
      }
      this->Result.back().Factors.push_back(value(i, "factor"));
      this->Result.back().Bounds.push_back(value(i, "bound"));
    }
  }

  std::string GetName(int group) const
  {
    return this->Groups == "files" ? this->Names[static_cast<std::size_t>(group)]
                                   : std::to_string(group);
  }

  std::string MakeTable() const
  {
    const auto quote = [](const std::string& name) {
      if (name.find_first_of(",\"\n") == std::string::npos)
      {
        return name;
      }
      std::string quoted;
      for (char c : name)
      {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
      }
      return '"' + quoted + '"';
    };
    std::vector<std::string> names = { "others", "nothing" };
    for (const Row& row : this->Result)
    {
      names.push_back(quote(this->GetName(row.Group)));
    }
    std::ostringstream out;
    out.precision(9);
    out << "from,to,factor,bound,area\n";
    for (const Row& row : this->Result)
    {
      for (std::size_t to = 0; to < names.size(); ++to)
      {
        out << quote(this->GetName(row.Group)) << ',' << names[to] << ',' << row.Factors[to] << ','
            << row.Bounds[to] << ',' << row.Area << '\n';
      }
    }
    return out.str();
  }

  std::string MakeJSON() const
  {
    using Json = nlohmann::ordered_json;
    Json made = { { "groups", Json::array() }, { "factors", Json::array() },
      { "bounds", Json::array() }, { "nothing", Json::array() }, { "others", Json::array() } };
    for (const Row& row : this->Result)
    {
      made["groups"].push_back({ { "name", this->GetName(row.Group) }, { "area", row.Area } });
      made["factors"].push_back(std::vector<double>(row.Factors.begin() + 2, row.Factors.end()));
      made["bounds"].push_back(std::vector<double>(row.Bounds.begin() + 2, row.Bounds.end()));
      made["others"].push_back(row.Factors[0]);
      made["nothing"].push_back(row.Factors[1]);
    }
    return made.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  }

  // Adds the arrays factors and bounds, 0 for cells without a group.
  void AddArrays(vtkPolyData* mesh) const
  {
    std::map<int, const Row*> rowOf;
    for (const Row& row : this->Result)
    {
      rowOf[row.Group] = &row;
    }
    vtkDataArray* groups = mesh->GetCellData()->GetArray(Group);
    for (const auto& [name, values] :
      { std::pair("factors", &Row::Factors), std::pair("bounds", &Row::Bounds) })
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      array->SetNumberOfComponents(static_cast<int>(this->Result.size()));
      array->SetNumberOfTuples(mesh->GetNumberOfCells());
      array->Fill(0.);
      int component = 0;
      for (const auto& each : rowOf)
      {
        array->SetComponentName(component++, ("to " + this->GetName(each.first)).c_str());
      }
      for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
      {
        const auto found = rowOf.find(static_cast<int>(groups->GetComponent(cell, 0)));
        if (found != rowOf.end())
        {
          array->SetTuple(cell, (found->second->*values).data() + 2);
        }
      }
      mesh->GetCellData()->AddArray(array);
    }
  }

  vtkNew<vtkRelievoViewFactors> Factors;
  std::string Groups = "files"; // or "parts", or "array:NAME"
  std::vector<std::string> Occluders;
  std::string JSON;        // "": none
  std::string Mesh;        // "": none
  std::vector<Row> Result; // by group
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeViewFactors()
{
  return std::make_unique<ViewFactorsCommand>();
}
}
