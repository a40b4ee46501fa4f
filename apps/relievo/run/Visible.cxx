// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Visible.h"

#include "DatasetPoses.h"
#include "Lens.h"
#include "Messages.h"
#include "Outputs.h"
#include "Progress.h"
#include "SightFiles.h"
#include "VisibleOptions.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoVisibility.h"

#include <cstdio>

namespace cli
{
namespace
{
void AddCameras(const VisibleOptions& options, int up, vtkRelievoVisibility* visibility)
{
  const auto like = scene::MakeSensor(options.Render);
  scene::DatasetSurroundings around;
  around.Box = vtkBoundingBox(vtkPolyData::SafeDownCast(visibility->GetInput())->GetBounds());
  around.UpAxis = up;
  around.Seed = options.Seed;
  for (const auto& camera : scene::MakeDatasetPoses("--poses", options.Poses, like, around))
  {
    visibility->AddCamera(camera);
  }
}
}

//------------------------------------------------------------------------------
void Visible(const VisibleOptions& options)
{
  const scene::Messages::Scope scope;
  scene::Outputs outputs;
  outputs.Add("-o", options.File, options.Files);
  if (!options.Cloud.empty())
  {
    outputs.Add("--cloud", options.Cloud, options.Files);
  }
  scene::Progress progress;
  vtkNew<vtkRelievoVisibility> visibility;
  const int up = ReadMeshes(options.Files, options.AllowedFolders, visibility, progress);
  AddCameras(options, options.Up < 0 ? up : options.Up, visibility);
  visibility->SetCloud(!options.Cloud.empty());
  progress.Begin("following rays");
  progress.Observe(visibility);
  visibility->Update();
  scene::Messages::Check("visible");
  WriteMesh(visibility->GetOutput(), "-o", options.File, outputs, progress);
  if (!options.Cloud.empty())
  {
    WriteMesh(visibility->GetOutput(1), "--cloud", options.Cloud, outputs, progress);
  }
  outputs.Commit();
  progress.End();
  vtkDataArray* seen = visibility->GetOutput()->GetCellData()->GetArray("seen");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < seen->GetNumberOfTuples(); ++i)
  {
    count += seen->GetTuple1(i) > 0. ? 1 : 0;
  }
  std::printf("%s: %lld of %lld cells are seen by %d camera%s\n", options.File.c_str(),
    static_cast<long long>(count), static_cast<long long>(seen->GetNumberOfTuples()),
    visibility->GetNumberOfCameras(), visibility->GetNumberOfCameras() == 1 ? "" : "s");
}
}
