// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

#include "Actors.h"
#include "Errors.h"
#include "ModelOptions.h"
#include "ModelTextures.h"
#include "OptionRows.h"
#include "Progress.h"
#include "ReadContext.h"
#include "Readers.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoModelReader.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace reading
{
namespace
{
void SetColor(vtkActor* actor, vtkDataSet* mesh)
{
  vtkDataArray* color = mesh->GetFieldData()->GetArray("base_color");
  if (color && color->GetNumberOfComponents() == 4)
  {
    double c[4];
    color->GetTuple(0, c);
    for (double& part : c)
    {
      part = std::clamp(part, 0., 1.);
    }
    actor->GetProperty()->SetColor(c);
    if (c[3] > 0.) // some writers leave the opacity at 0
    {
      actor->GetProperty()->SetOpacity(c[3]);
    }
  }
}

// Whether the file has materials of its own for the block. Notes faulty images.
bool ApplyMaterial(vtkRelievoModelReader* reader, int block, vtkActor* actor,
  const std::string& path, ReadContext& context)
{
  if (!reader->GetProperty(block))
  {
    return false;
  }
  reader->ApplyMaterial(block, actor);
  try
  {
    context.Check(path);
  }
  catch (const WorkError& error)
  {
    const std::string what = error.what();
    const std::size_t named = what.rfind(path + ": ");
    context.Note(path + ": drawn without a texture: " +
      (named == std::string::npos ? what : what.substr(named + path.size() + 2)));
  }
  return true;
}

vtkSmartPointer<vtkPolyData> CopySkeleton(vtkRelievoModelReader* reader)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(reader->GetOutputDataObject(1));
  return copy;
}

// Throws UsageError for an animation or a bone missing from the file.
void CheckNames(vtkRelievoModelReader* reader, const ModelChoice& choice, const std::string& path,
  ReadContext& context)
{
  const auto lacks = [](vtkStringArray* names, const std::string& name) {
    return !name.empty() && names && names->GetNumberOfValues() > 0 && names->LookupValue(name) < 0;
  };
  if (lacks(reader->GetAnimationNames(), choice.Animation) ||
    lacks(reader->GetAnimationNames(), choice.Blend) ||
    lacks(reader->GetBoneNames(), choice.BoneWeight))
  {
    try
    {
      context.Check(path);
    }
    catch (const WorkError& error)
    {
      throw UsageError(error.what());
    }
  }
}

// Unlit lines in the colours of their axes.
vtkSmartPointer<vtkActor> MakeSkeletonActor(vtkRelievoModelReader* reader)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(CopySkeleton(reader));
  mapper->SetScalarModeToUseCellData();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(2.f);
  return actor;
}
}

//------------------------------------------------------------------------------
PosedModel ReadModel(
  const std::string& path, const ModelChoice& choice, bool smooth, ReadContext& context)
{
  Progress& progress = context.GetProgress();
  progress.Begin("reading " + path);
  PosedModel model;
  model.Path = path;
  model.Smooth = smooth;
  model.Reader = vtkSmartPointer<vtkRelievoModelReader>::New();
  vtkRelievoModelReader* reader = model.Reader;
  reader->SetFileName(path.c_str());
  for (const std::string& folder : context.GetFolders())
  {
    reader->AddAllowedFolder(folder.c_str());
  }
  reader->SetAnimation(choice.Animation.c_str());
  reader->SetBlendAnimation(choice.Blend.c_str());
  reader->SetBlendWeight(choice.BlendWeight);
  reader->SetLoop(choice.Loop);
  reader->SetSkeletonAxes(choice.Skeleton);
  reader->SetFirstBone(choice.FirstBone);
  reader->SetWeightsOf(choice.BoneWeight.c_str());
  if (!choice.Given && IsGLTF(path))
  {
    reader->SetPose(vtkRelievoModelReader::POSE_NODES); // the file's static pose
  }
  else if (choice.Skin == SkinChoice::Off)
  {
    reader->SetPose(vtkRelievoModelReader::POSE_BIND);
  }
  else
  {
    reader->SetMethod(static_cast<int>(choice.Skin) - static_cast<int>(SkinChoice::Linear));
  }
  progress.Observe(reader);
  if (choice.Time)
  {
    reader->UpdateTimeStep(*choice.Time);
  }
  else
  {
    reader->Update();
  }
  progress.End();
  for (int i = 0; i < reader->GetNumberOfFiles(); ++i)
  {
    context.AddFile(reader->GetFile(i));
  }
  CheckNames(reader, choice, path, context);
  context.Check(path, reader->GetErrorCode() != 0, NotAsNamed(path));
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    context.Note(path + ": " + reader->GetNote(i));
  }
  const std::pair<const char*, bool> ofAnimations[] = { { "--times", !choice.Times.empty() },
    { "--time", choice.Time && choice.Times.empty() }, { "--animation", !choice.Animation.empty() },
    { "--blend", !choice.Blend.empty() } };
  for (const auto& [option, given] : ofAnimations)
  {
    if (given && reader->GetNumberOfAnimations() == 0)
    {
      context.Note(path + ": " + option + " changed nothing: the file has no animation");
    }
  }
  vtkMultiBlockDataSet* output = reader->GetOutput();
  ModelTextures textures(reader, path, context);
  for (unsigned int i = 0; i < output->GetNumberOfBlocks(); ++i)
  {
    vtkDataSet* mesh = vtkDataSet::SafeDownCast(output->GetBlock(i));
    if (mesh && mesh->GetNumberOfCells() > 0)
    {
      const vtkSmartPointer<vtkActor> actor = MakeActor(mesh, smooth, path, context);
      std::optional<double> cutoff;
      if (ApplyMaterial(reader, static_cast<int>(i), actor, path, context))
      {
        cutoff = reader->GetAlphaCutoff(static_cast<int>(i));
      }
      else
      {
        SetColor(actor, mesh);
      }
      textures.Put(actor, mesh, cutoff);
      model.Parts.push_back({ i, actor });
    }
  }
  model.Skeleton = choice.Skeleton ? MakeSkeletonActor(reader) : nullptr;
  return model;
}

//------------------------------------------------------------------------------
void PlayModel(PosedModel& model, double time, ReadContext& context)
{
  model.Reader->UpdateTimeStep(time);
  context.Check(model.Path, model.Reader->GetErrorCode() != 0, NotAsNamed(model.Path));
  for (const PosedModel::Part& part : model.Parts)
  {
    const vtkSmartPointer<vtkDataObject> surface = MakeSurface(
      model.Reader->GetOutput()->GetBlock(part.Block), model.Smooth, model.Path, context);
    part.Actor->GetMapper()->SetInputDataObject(surface);
  }
  if (model.Skeleton)
  {
    model.Skeleton->GetMapper()->SetInputDataObject(CopySkeleton(model.Reader));
  }
}

//------------------------------------------------------------------------------
void AddModelOptions(OptionRows& rows, ModelChoice& model)
{
  rows
    .Add("--time", "T", "the time of models with bones, in seconds (the animation's start)", model,
      TakeTime)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES);
  rows
    .Add("--times", "START:END:STEP",
      "draws a frame for each of these times, including the end; the names of --png, --exr "
      "and --report must contain %d or %04d, the frame number from 0. The fitted camera "
      "sees all frames, and each frame's files are written before the next frame is drawn",
      model, TakeTimes)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES |
      OptionRows::Option::OF_ONE_VIEW);
  rows
    .Add("--animation", "NAME", "the animation of the models to play (the first)", model,
      TakeAnimation)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES)
    .NamedIn("Scene", "Animation");
  rows
    .Add("--blend", "NAME=W", "blends in another animation with weight W, 0 to 1", model, TakeBlend)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES);
  rows
    .Add("--loop", "",
      "times after the end of an animation start again from its beginning (the end holds)", model,
      TakeLoop)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES)
    .NamedIn("Scene", "Start anew after the end");
  rows
    .AddChoice("--skin", "METHOD", { "linear", "dual-quaternion", "key-matrix", "off" },
      "how bones move points: linear, dual-quaternion, key-matrix, or off for the mesh at "
      "rest (linear)",
      [&model](std::size_t place) {
        constexpr SkinChoice kinds[] = { SkinChoice::Linear, SkinChoice::DualQuaternion,
          SkinChoice::KeyMatrix, SkinChoice::Off };
        model.Skin = kinds[place];
        model.Given = true;
      })
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES)
    .NamedIn("Scene", "Skinning");
  rows
    .Add("--skeleton", "",
      "draws the bones, and the axes of their joints in red, green and blue; --opacity "
      "affects only the mesh",
      model, TakeSkeleton)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES)
    .NamedIn("Scene", "Show the bones");
  rows
    .Add("--bone-weight", "BONE",
      "colours by the weight of one bone; --color-by first_bone colours by the strongest", model,
      TakeBoneWeight)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES);
}
}
