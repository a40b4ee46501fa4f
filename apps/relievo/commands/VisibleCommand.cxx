// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "DatasetFormats.h"
#include "DatasetPoses.h"
#include "Errors.h"
#include "FileHash.h"
#include "Lens.h"
#include "MeshParts.h"
#include "Messages.h"
#include "Options.h"
#include "Outputs.h"
#include "Progress.h"
#include "SightFiles.h"
#include "Values.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoCalibration.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoVisibility.h"

#include <cstdio>
#include <limits>

namespace cli
{
namespace
{
class VisibleCommand : public Command
{
public:
  VisibleCommand()
    : Command("visible", "FILE...",
        "visible finds by rays which cells of a mesh are visible to cameras, in how many "
        "pixels and under which solid angle, and writes the mesh with the arrays seen, "
        "pixels and solid_angle. The first FILE is the mesh, the others hide it.")
  {
    vtkRelievoOption& poses = this->Add("--poses POSES",
      "cameras, as in dataset: orbit:N, random:N or a FILE.json", [this](const std::string& value) {
        dataset::CheckDatasetPoses("--poses", value);
        this->Poses = value;
      });
    poses.Missing = "no cameras; give --poses orbit:N, random:N or FILE.json";
    poses.Words = { "orbit:", "random:" };
    poses.Files = "json";
    this->AddMeshOptions(".vtp");
    this->AddUpOption();
    this->AddOutput(
      "--cloud FILE.vtp", "writes the surface points seen in the pixels", this->Cloud);
    this->AddOfRender("--size", "pixels of each camera (1024x768)");
    this->AddOfRender("--view-angle", "full vertical angle of each camera (30)");
    this->AddOfRender("--lens",
      words::Join(vtkRelievoCalibration::GetNames(), ", ") +
        "; or a file, as in render; orthographic with its PIXELS (pinhole)");
    this->AddPartOption("cells");
    this->Add("--seed N", "seed of random poses (0)", [this](const std::string& value) {
      this->Seed = words::ParseWhole(
        "--seed", value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    });
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->TakeMeshes(words);
    this->Render = scene::ParseOptions(this->OfCameras);
    scene::CheckLensScale(this->Render);
    const reading::Messages::Scope scope;
    reading::Outputs outputs;
    outputs.Add("-o", this->File, this->Names);
    if (!this->Cloud.empty())
    {
      outputs.Add("--cloud", this->Cloud, this->Names);
    }
    if (this->IsPart && !this->Cloud.empty())
    {
      throw words::UsageError(
        "--cloud: got a part of the cells, expected no --part: the points belong to pixels");
    }
    reading::Progress progress;
    MeshParts parts(MeshParts::GetFolder(this->File));
    vtkNew<vtkRelievoVisibility> visibility;
    const int up =
      ReadMeshes(this->Names, this->AllowedFolders, this->RayFile, visibility, progress);
    this->AddCameras(this->Up < 0 ? up : this->Up, visibility);
    visibility->SetCloud(!this->Cloud.empty());
    if (this->IsPart &&
      !parts.Begin(this->Rows.Name, this->DescribeCameras(visibility), visibility, this->Part))
    {
      return 0;
    }
    progress.Begin("following rays");
    progress.Observe(visibility);
    visibility->Update();
    reading::Messages::Check("visible");
    if (this->IsPart)
    {
      parts.End(visibility, this->Part, progress);
      return 0;
    }
    WriteMesh(visibility->GetOutput(), "-o", this->File, outputs, progress);
    if (!this->Cloud.empty())
    {
      WriteMesh(visibility->GetOutput(1), "--cloud", this->Cloud, outputs, progress);
    }
    outputs.Commit();
    progress.End();
    vtkDataArray* seen = visibility->GetOutput()->GetCellData()->GetArray("seen");
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < seen->GetNumberOfTuples(); ++i)
    {
      count += seen->GetTuple1(i) > 0. ? 1 : 0;
    }
    std::printf("%s: %lld of %lld cells are seen by %d camera%s\n", this->File.c_str(),
      static_cast<long long>(count), static_cast<long long>(seen->GetNumberOfTuples()),
      visibility->GetNumberOfCameras(), visibility->GetNumberOfCameras() == 1 ? "" : "s");
    return 0;
  }

private:
  // Adds an option of render that describes cameras.
  void AddOfRender(const std::string& name, const std::string& help)
  {
    vtkRelievoOption option = *scene::GetRenderCommand().Find(name);
    option.Help = help;
    option.Take = [this, name](const std::string& value) {
      this->OfCameras.push_back(name + "=" + value);
      return std::string();
    };
    this->Rows.Options.push_back(option);
  }

  // The words, and the cameras, which may come from a file.
  std::string DescribeCameras(vtkRelievoVisibility* visibility) const
  {
    std::string words = this->GetWords();
    for (int i = 0; i < visibility->GetNumberOfCameras(); ++i)
    {
      words += " " + dataset::DescribeDatasetCamera(visibility->GetCamera(i)).dump();
    }
    return dataset::FileHash::Of(words);
  }

  void AddCameras(int up, vtkRelievoVisibility* visibility) const
  {
    const auto like = scene::MakeSensor(this->Render);
    dataset::DatasetSurroundings around;
    around.Box = vtkBoundingBox(vtkPolyData::SafeDownCast(visibility->GetInput())->GetBounds());
    around.UpAxis = up;
    around.Seed = this->Seed;
    for (const auto& camera : dataset::MakeDatasetPoses("--poses", this->Poses, like, around))
    {
      visibility->AddCamera(camera);
    }
  }

  std::vector<std::string> OfCameras; // as words of render
  scene::RenderOptions Render;        // parsed words
  std::string Poses;                  // "orbit:N", "random:N", or a file
  std::string Cloud;                  // "": none
  int Seed = 0;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeVisible()
{
  return std::make_unique<VisibleCommand>();
}
}
