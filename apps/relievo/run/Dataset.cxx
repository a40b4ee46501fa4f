// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Dataset.h"

#include "DatasetOptions.h"
#include "Errors.h"
#include "Lens.h"
#include "Messages.h"
#include "SceneWork.h"
#include "Values.h"

#include "vtkActorCollection.h"
#include "vtkNew.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoDatasetWriter.h"
#include "vtkRenderer.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

namespace cli
{
namespace
{
// Objects are called by their files; what is of no file, such as a ground, hides and no more.
void NameObjects(
  vtkRelievoDatasetWriter* writer, vtkRelievoScene* scene, const DatasetOptions& options)
{
  std::map<std::string, std::string> names; // by file
  std::map<std::string, int> parts;         // of a file, so far
  std::set<std::string> ofFiles, ofParts;   // that are taken
  for (int actor = 0; actor < scene->GetRenderer()->GetActors()->GetNumberOfItems(); ++actor)
  {
    const std::string file = scene->GetFileOf(actor);
    if (file.empty())
    {
      writer->SetObjectName(actor, "");
      continue;
    }
    if (names.count(file) == 0)
    {
      const std::string stem = std::filesystem::path(file).stem().string();
      std::string name = stem;
      for (int same = 2; !ofFiles.insert(name).second; ++same)
      {
        name = stem + "_" + std::to_string(same);
      }
      names[file] = name;
    }
    std::string name = names[file];
    if (options.Objects != DatasetParts::File)
    {
      do
      {
        name = names[file] + "_" + std::to_string(parts[file]++);
      } while (!ofParts.insert(name).second);
    }
    writer->SetObjectName(actor, name);
  }
  writer->SetObjectsByBlock(options.Objects == DatasetParts::Block);
}

void AddViews(vtkRelievoDatasetWriter* writer, const DatasetOptions& options)
{
  const bool done = writer->AddViews(options.Poses, scene::MakeSensor(options.Render));
  const bool usage = writer->GetFailure() == vtkRelievoScene::USAGE_FAILURE;
  CheckDone(done, writer->GetFailure(), (usage ? "--" : "") + writer->GetFailureText());
  const int views = writer->GetNumberOfViews();
  if (options.Range[1] > views)
  {
    scene::RefuseValue("--views",
      std::to_string(options.Range[0]) + ":" + std::to_string(options.Range[1]),
      "views from 0 to " + std::to_string(views) + ": there are " + std::to_string(views));
  }
}
}

//------------------------------------------------------------------------------
void Dataset(const DatasetOptions& options)
{
  const scene::Messages::Scope scope;
  vtkNew<vtkRelievoScene> scene;
  SetWords(scene, options.Scene);
  {
    const SceneSteps steps(scene);
    const bool done = scene->Update();
    CheckDone(done, scene->GetFailure(), scene->GetFailureText());
  }
  vtkNew<vtkRelievoDatasetWriter> writer;
  writer->SetRenderer(scene->GetRenderer());
  writer->SetDirectory(options.Folder);
  writer->SetFormat(options.Format);
  writer->SetDepthStep(options.DepthStep);
  writer->SetMillimetersPerUnit(options.MillimetersPerUnit);
  writer->SetSeed(options.Seed);
  writer->SetRandomSun(options.RandomSun);
  writer->SetUpAxis(scene->GetUpAxis());
  writer->SetRange(options.Range[0], options.Range[1]);
  writer->SetDescription(scene::Join(options.Words, " "));
  for (const std::string& layer : options.Layers)
  {
    writer->AddLayer(layer);
  }
  NameObjects(writer, scene, options);
  AddViews(writer, options);
  {
    scene::Progress progress;
    progress.Begin("writing " + options.Folder);
    progress.Observe(writer);
    const bool done = writer->Write();
    CheckDone(done, writer->GetFailure(), writer->GetFailureText());
  }
  std::printf("%s: %d of %d views written", options.Folder.c_str(),
    writer->GetNumberOfViewsWritten(), writer->GetNumberOfViews());
  if (writer->GetNumberOfViewsKept() > 0)
  {
    std::printf(", %d were there", writer->GetNumberOfViewsKept());
  }
  std::printf("\n");
  PrintMessages(scene);
  PrintWarnings();
}
}
