// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Errors.h"
#include "MeshParts.h"
#include "Messages.h"
#include "Outputs.h"
#include "Progress.h"
#include "SightFiles.h"
#include "Values.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoViewshed.h"

#include <cstdio>

namespace cli
{
namespace
{
class ViewshedCommand : public Command
{
public:
  ViewshedCommand()
    : Command("viewshed", "FILE...",
        "viewshed counts by rays the observers that see each cell of a terrain, and writes the "
        "numbers as a raster on the terrain's grid, or at its points as a mesh. The first "
        "FILE is the terrain, a GeoTIFF or a mesh with heights along z; the others hide it.")
  {
    vtkRelievoOption& observers = this->Add("--observer X,Y,HEIGHT",
      "an observer, by coordinates of the terrain and the height above it; repeatable",
      [this](const std::string& value) { this->AddObserver(value); });
    observers.Missing = "no observer; give --observer X,Y,HEIGHT";
    observers.Repeats = true;
    this->AddMeshOptions(".tif", ".vtp");
    this->AddParameters(this->Viewshed->GetParameters(), {});
    this->AddPartOption("points");
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->TakeMeshes(words);
    const reading::Messages::Scope scope;
    reading::Outputs outputs;
    outputs.Add("-o", this->File, this->Names);
    reading::Progress progress;
    MeshParts parts(MeshParts::GetFolder(this->File));
    ReadMeshes(this->Names, this->AllowedFolders, this->RayFile, this->Viewshed, progress);
    CheckRaster(this->Viewshed, this->File);
    if (this->IsPart && !parts.Begin(this->Rows.Name, this->GetWords(), this->Viewshed, this->Part))
    {
      return 0;
    }
    progress.Begin("following lines of sight");
    progress.Observe(this->Viewshed);
    this->Viewshed->Update();
    reading::Messages::Check("viewshed");
    if (this->IsPart)
    {
      parts.End(this->Viewshed, this->Part, progress);
      return 0;
    }
    vtkPolyData* mesh = this->Viewshed->GetOutput();
    WriteMesh(mesh, "-o", this->File, outputs, progress);
    outputs.Commit();
    progress.End();
    vtkDataArray* seen = mesh->GetPointData()->GetArray("seen");
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < seen->GetNumberOfTuples(); ++i)
    {
      count += seen->GetTuple1(i) > 0. ? 1 : 0;
    }
    const int observers = this->Viewshed->GetNumberOfViewpoints();
    std::printf("%s: %lld of %lld points are seen by %d observer%s\n", this->File.c_str(),
      static_cast<long long>(count), static_cast<long long>(seen->GetNumberOfTuples()), observers,
      observers == 1 ? "" : "s");
    return 0;
  }

private:
  void AddObserver(const std::string& value)
  {
    const std::vector<double> place = words::ParseNumbers("--observer", value, 3, "X,Y,HEIGHT");
    if (place[2] < 0.)
    {
      words::RefuseValue("--observer", value, "a height above the ground of at least 0");
    }
    this->Viewshed->AddViewpoint(place[0], place[1], place[2]);
  }

  vtkNew<vtkRelievoViewshed> Viewshed;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeViewshed()
{
  return std::make_unique<ViewshedCommand>();
}
}
