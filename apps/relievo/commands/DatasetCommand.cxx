// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "DatasetPoses.h"
#include "Errors.h"
#include "Lens.h"
#include "Messages.h"
#include "Options.h"
#include "SceneWork.h"
#include "Values.h"

#include "vtkActorCollection.h"
#include "vtkNew.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoDatasetWriter.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

namespace cli
{
namespace
{
// Whether it is an option of render that data sets refuse: of outputs, or of one view.
bool IsOfRender(const std::string& name)
{
  const vtkRelievoOption* option = scene::GetRenderCommand().Find(name);
  return option &&
    (option->OfOutputs ? !option->Has(vtkRelievoOption::OF_ALL_VIEWS)
                       : option->Has(vtkRelievoOption::OF_ONE_VIEW));
}

// Kinds of objects.
enum class DatasetParts
{
  File,
  Actor,
  Block
};

// Names objects by their files; actors without a file, such as a ground, only hide others.
void NameObjects(vtkRelievoDatasetWriter* writer, vtkRelievoScene* scene, DatasetParts kind)
{
  std::map<std::string, std::string> names; // by file
  std::map<std::string, int> parts;         // numbers of parts per file
  std::set<std::string> ofFiles, ofParts;   // names in use
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
    if (kind != DatasetParts::File)
    {
      do
      {
        name = names[file] + "_" + std::to_string(parts[file]++);
      } while (!ofParts.insert(name).second);
    }
    writer->SetObjectName(actor, name);
  }
  writer->SetObjectsByBlock(kind == DatasetParts::Block);
}

class DatasetCommand : public Command
{
public:
  DatasetCommand()
    : Command("dataset", "FILE...",
        "dataset writes views of the FILEs from many cameras as a data set for training or "
        "evaluation: pictures, depth, masks of each object, its boxes and poses, and the "
        "cameras. It takes the options of render that shape the scene and its look; --size, "
        "--view-angle and --lens apply to the cameras. Repeating an interrupted call "
        "continues it.")
  {
    this->Rows.Files = scene::GetRenderCommand().Files;
    vtkRelievoOption& poses = this->Add("--poses POSES",
      "orbit:N[,elevation=30][,distance=1], places around the objects; "
      "random:N[,lowest=0][,highest=90][,nearest=1][,farthest=1.5], random places between "
      "two elevations, in degrees, and two distances; a distance of 1 shows all objects; "
      "or a FILE.json, a list of {\"R\", \"t\"} or {\"position\", \"target\"}, or a "
      "transforms.json",
      [this](const std::string& value) {
        dataset::CheckDatasetPoses("--poses", value);
        this->Poses = value;
      });
    poses.Missing = "no cameras; give --poses orbit:N, random:N or FILE.json";
    poses.Words = { "orbit:", "random:" };
    poses.Files = "json";
    vtkRelievoOption& out =
      this->AddWord("--out DIR", "the folder: new, empty, or begun by the same call", this->Folder);
    out.Missing = "no folder to write to; give --out DIR";
    out.Files = "/";
    this
      ->Add("--layers A,B...",
        "layers to write as floats: in layers/NUMBER.exr, with npz as arrays; flow, motion "
        "and flow_valid refer to the previous view",
        [this](const std::string& value) { this->TakeLayers(value); })
      .Repeats = true;
    const std::vector<std::string> kinds = { "file", "actor", "block" };
    this
      ->Add("--objects KIND",
        "kind of objects: file, actor (a material or a part of a file) or block (file)",
        [this, kinds](const std::string& value) {
          this->Objects = static_cast<DatasetParts>(words::ParseChoice("--objects", value, kinds));
        })
      .Words = kinds;
    this
      ->Add("--category NAME=OBJECT,...",
        "for coco, yolo and kitti: the category of these objects; names may have * and ? (each "
        "object is a category)",
        [this](const std::string& value) { this->TakeCategory(value); })
      .Repeats = true;
    this->AddParameters(this->Writer->GetParameters(),
      { { "format", "--format FORMAT" }, { "depth_step", "--depth-step S" },
        { "mm_per_unit", "--mm-per-unit M" }, { "validation", "--validation SHARE" },
        { "shard_size", "--shard-size MB" }, { "up", "" } });
    this->AddPartOption("views");
    this->Add("--views A:B",
      "draws only the views from A to B - 1, as one of several processes (all)",
      [this](const std::string& value) { this->TakeRange(value); });
  }

  // The command's own options, and those of render for the scene.
  vtkRelievoCommand DescribeAll() override
  {
    vtkRelievoCommand all = this->Rows;
    for (vtkRelievoOption& option : all.Options)
    {
      if (option.Name != "--out" && option.Name != "--views" && option.Name != "--part")
      {
        option.Take = [this, option](const std::string& value) {
          this->Words.push_back(option.IsFlag() ? option.Name : option.Name + "=" + value);
          return option.Take(value);
        };
      }
    }
    for (vtkRelievoOption option : scene::GetRenderCommand().Options)
    {
      if (!this->Rows.Find(option.Name) && !IsOfRender(option.Name))
      {
        option.Take = [this, name = option.Name, isFlag = option.IsFlag()](
                        const std::string& value) {
          this->Scene.push_back(isFlag ? name : name + "=" + value);
          this->Words.push_back(this->Scene.back());
          return std::string();
        };
        all.Options.push_back(option);
      }
    }
    return all;
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->TakeAll(words);
    const reading::Messages::Scope scope;
    vtkRelievoScene* scene = GetScene();
    SetWords(scene, this->Scene);
    {
      const SceneSteps steps(scene);
      const bool done = scene->Update();
      CheckDone(done, scene->GetFailure(), scene->GetFailureText());
    }
    vtkRelievoDatasetWriter* writer = this->Writer;
    writer->SetRenderer(scene->GetRenderer());
    writer->SetDirectory(this->Folder);
    writer->SetUpAxis(scene->GetUpAxis());
    writer->SetRange(this->Range[0], this->Range[1]);
    writer->SetPart(this->Part.Number, this->Part.Count);
    writer->SetDescription(words::Join(this->Words, " "));
    NameObjects(writer, scene, this->Objects);
    this->AddViews();
    {
      reading::Progress progress;
      progress.Begin("writing " + this->Folder);
      progress.Observe(writer);
      const bool done = writer->Write();
      CheckDone(done, writer->GetFailure(), writer->GetFailureText());
    }
    const std::string part = this->IsPart ? ": " + this->Part.GetText() : "";
    const auto share = this->Part.GetRange(writer->GetNumberOfViews());
    std::printf("%s%s: %d of %d views written", this->Folder.c_str(), part.c_str(),
      writer->GetNumberOfViewsWritten(), static_cast<int>(share[1] - share[0]));
    if (writer->GetNumberOfViewsKept() > 0)
    {
      std::printf(", %d were there", writer->GetNumberOfViewsKept());
    }
    std::printf("\n");
    PrintMessages(scene);
    PrintWarnings();
    return 0;
  }

private:
  void TakeLayers(const std::string& value)
  {
    for (const std::string& layer : words::SplitEscaped(value, ','))
    {
      if (layer.empty())
      {
        words::RefuseValue("--layers", value, "names between commas, such as depth,normal");
      }
      this->Writer->AddLayer(layer);
    }
  }

  void TakeCategory(const std::string& value)
  {
    const std::size_t equals = value.find('=');
    const std::vector<std::string> objects = equals == std::string::npos
      ? std::vector<std::string>()
      : words::SplitEscaped(value.substr(equals + 1), ',');
    if (equals == 0 || objects.empty() ||
      std::find(objects.begin(), objects.end(), "") != objects.end())
    {
      words::RefuseValue(
        "--category", value, "a category and names of objects, such as mug=mug,mug_2");
    }
    for (const std::string& object : objects)
    {
      this->Writer->SetCategory(object, value.substr(0, equals));
    }
  }

  void TakeRange(const std::string& value)
  {
    const std::string name = "--views";
    const std::vector<std::string> parts = words::Split(value, ':');
    if (parts.size() != 2)
    {
      words::RefuseValue(name, value, "A:B, from view A to before view B");
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      this->Range[i] =
        words::ParseWhole(name + " " + value, parts[i], 0, std::numeric_limits<int>::max());
    }
    if (this->Range[0] >= this->Range[1])
    {
      words::RefuseValue(name, value, "the first view to be before the end");
    }
  }

  void TakeAll(const std::vector<std::string>& words)
  {
    for (const std::string& word : words)
    {
      const std::string name = word.substr(0, word.find('='));
      if (IsOfRender(name))
      {
        throw words::UsageError(name +
          ": is an option of relievo render; for a data set, --poses sets the cameras, and "
          "--format and --out the output");
      }
      if (word == "--")
      {
        break;
      }
    }
    this->Take(words);
    if (this->Names.empty())
    {
      throw words::UsageError("dataset: no FILE given");
    }
    this->Scene.emplace_back("--");
    for (std::vector<std::string>* to : { &this->Scene, &this->Words })
    {
      to->insert(to->end(), this->Names.begin(), this->Names.end());
    }
    this->Render = scene::ParseOptions(this->Scene);
    scene::CheckLensScale(this->Render);
  }

  void AddViews()
  {
    vtkRelievoDatasetWriter* writer = this->Writer;
    const bool done = writer->AddViews(this->Poses, scene::MakeSensor(this->Render));
    const bool usage = writer->GetFailure() == vtkRelievoScene::USAGE_FAILURE;
    CheckDone(done, writer->GetFailure(), (usage ? "--" : "") + writer->GetFailureText());
    const int views = writer->GetNumberOfViews();
    if (this->Range[1] > views)
    {
      words::RefuseValue("--views",
        std::to_string(this->Range[0]) + ":" + std::to_string(this->Range[1]),
        "views from 0 to " + std::to_string(views) + ": there are " + std::to_string(views));
    }
  }

  vtkNew<vtkRelievoDatasetWriter> Writer;
  std::vector<std::string> Scene; // files and options, as words of render
  std::vector<std::string> Words; // all words except the output folder and the range of views
  scene::RenderOptions Render;    // parsed words
  std::string Poses;              // "orbit:N", "random:N", or a file
  std::string Folder;
  DatasetParts Objects = DatasetParts::File;
  std::array<int, 2> Range = { 0, -1 }; // first view, and the one after the last; -1: all
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeDataset()
{
  return std::make_unique<DatasetCommand>();
}
}
