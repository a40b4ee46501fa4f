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

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoCover.h"

#include <cstdio>

namespace cli
{
namespace
{
// The points of a file, with their vectors, or normals, as directions.
vtkSmartPointer<vtkPolyData> ReadCandidates(
  const std::string& file, const std::vector<std::string>& folders, reading::Progress& progress)
{
  reading::CheckReadable(file);
  reading::CheckExtension(file);
  reading::ReadContext context(progress, folders);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> directions;
  directions->SetName("directions");
  directions->SetNumberOfComponents(3);
  reading::ForEachDataSet(reading::ReadPoints(file, context), [&](vtkDataSet* data) {
    vtkPointData* arrays = data->GetPointData();
    vtkDataArray* given = arrays->GetVectors() ? arrays->GetVectors() : arrays->GetNormals();
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(data->GetPoint(i));
      if (given)
      {
        directions->InsertNextTuple(given->GetTuple(i));
      }
    }
  });
  auto candidates = vtkSmartPointer<vtkPolyData>::New();
  candidates->SetPoints(points);
  if (directions->GetNumberOfTuples() == points->GetNumberOfPoints()) // in all blocks
  {
    candidates->GetPointData()->SetVectors(directions);
  }
  return candidates;
}

class CoverCommand : public Command
{
public:
  CoverCommand()
    : Command("cover", "FILE...",
        "cover chooses, among candidate places of cameras, the places that together see most of a "
        "mesh, and writes the mesh with the arrays covered and candidates: for each cell the "
        "number of chosen places that see it, and the number of all candidates that do. The first "
        "FILE is the mesh, the others hide it.")
  {
    vtkRelievoOption& candidates = this->AddWord("--candidates FILE",
      "the points of this mesh are the candidates; its point vectors, or else its normals, are the "
      "directions of cameras",
      this->Candidates);
    candidates.Missing = "no candidates; give --candidates FILE";
    this->AddMeshOptions(".vtp");
    candidates.Files = this->Rows.Files;
    this->AddOutput("--chosen FILE.vtp", "writes the chosen places as points", this->Chosen);
    this->AddParameters(this->Cover->GetParameters(),
      { { "number_of_places", "--places N" }, { "weights", "--weights ARRAY" } });
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->TakeMeshes(words);
    const reading::Messages::Scope scope;
    reading::Outputs outputs;
    std::vector<std::string> inputs = this->Names;
    inputs.push_back(this->Candidates);
    outputs.Add("-o", this->File, inputs);
    if (!this->Chosen.empty())
    {
      outputs.Add("--chosen", this->Chosen, inputs);
    }
    reading::Progress progress;
    ReadMeshes(this->Names, this->AllowedFolders, this->RayFile, this->Cover, progress);
    this->Cover->SetInputDataObject(
      2, ReadCandidates(this->Candidates, this->AllowedFolders, progress));
    progress.Begin("following rays");
    progress.Observe(this->Cover);
    this->Cover->Update();
    reading::Messages::Check("cover");
    WriteMesh(this->Cover->GetOutput(), "-o", this->File, outputs, progress);
    if (!this->Chosen.empty())
    {
      WriteMesh(this->Cover->GetOutput(1), "--chosen", this->Chosen, outputs, progress);
    }
    outputs.Commit();
    progress.End();
    vtkFieldData* fields = this->Cover->GetOutput()->GetFieldData();
    const auto percent = [fields](const char* name) {
      return 100.0 * fields->GetArray(name)->GetTuple1(0);
    };
    std::printf("%s: %lld places cover %.1f %% of the surface; no choice of %d covers more than "
                "%.1f %%, all candidates %.1f %%\n",
      this->File.c_str(), static_cast<long long>(this->Cover->GetOutput(1)->GetNumberOfPoints()),
      percent("share"), this->Cover->GetNumberOfPlaces(), percent("bound"), percent("reachable"));
    return 0;
  }

private:
  vtkNew<vtkRelievoCover> Cover;
  std::string Candidates;
  std::string Chosen; // "": none
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeCover()
{
  return std::make_unique<CoverCommand>();
}
}
