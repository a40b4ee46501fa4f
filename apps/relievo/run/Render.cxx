// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render.h"

#include "Display.h"
#include "Errors.h"
#include "Frame.h"
#include "Messages.h"
#include "Options.h"
#include "Outputs.h"
#include "Progress.h"
#include "Scene.h"
#include "Shadows.h"
#include "StandardError.h"
#include "Surface.h"
#include "Values.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>

namespace cli
{
namespace
{
// An EXR file without a word about layers holds the colour and the depth.
const std::vector<std::string> DefaultLayers = { "depth" };

// GPU times are read a frame or more later and never waited for, so a report needs a few frames.
constexpr int FramesUntilTimed = 4;

// Throws UsageError if nothing that is drawn can have the layer.
void CheckLayer(const std::string& option, const std::string& name, const Scene& scene)
{
  if (vtkRelievoLayerCatalogue::GetIsLayer(name) || scene.Arrays.count(name) != 0 ||
    scene.Placed.count(name) != 0)
  {
    return;
  }
  const std::vector<std::string> arrays(scene.Arrays.begin(), scene.Arrays.end());
  RefuseValue(option, name,
    "one of " + vtkRelievoLayerCatalogue::GetLayerNames() +
      (arrays.empty() ? "; the files hold no arrays" : ", or an array: " + Join(arrays, ", ")));
}

// The layer that is shown as the picture, if one is.
void CheckShownLayer(const RenderOptions& options, const Scene& scene)
{
  for (const StageChoice& stage : options.Stages)
  {
    for (const auto& [parameter, value] : stage.Parameters)
    {
      if (stage.Name == "display" && parameter == "layer" && !value.empty())
      {
        CheckLayer(stage.Option + " display:layer", value, scene);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> LayersToCapture(const RenderOptions& options, const Scene& scene)
{
  std::vector<std::string> layers;
  if (!options.EXR.empty())
  {
    layers.push_back(vtkRelievoLayerCatalogue::GetPicture().Name);
  }
  const bool unnamed = options.Layers.empty() && !options.EXR.empty();
  for (const std::string& name : unnamed ? DefaultLayers : options.Layers)
  {
    CheckLayer("--layers", name, scene);
    if (std::find(layers.begin(), layers.end(), name) == layers.end())
    {
      layers.push_back(name);
    }
  }
  return layers;
}

//------------------------------------------------------------------------------
void WritePNG(
  vtkRenderWindow* window, const RenderOptions& options, const Outputs& outputs, Progress& progress)
{
  progress.Begin("writing " + options.PNG);
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(outputs.Temporary(options.PNG).c_str());
  progress.Observe(writer);
  {
    const SilentLibraries silence; // libpng prints what the writer says
    writer->Write();
  }
  progress.End();
  Messages::Check(options.PNG, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
}

//------------------------------------------------------------------------------
void WriteEXR(
  vtkImageData* image, const RenderOptions& options, const Outputs& outputs, Progress& progress)
{
  progress.Begin("writing " + options.EXR);
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(outputs.Temporary(options.EXR).c_str());
  progress.Observe(writer);
  writer->Write();
  progress.End();
  Messages::Check(options.EXR, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
}

//------------------------------------------------------------------------------
void WriteReport(vtkRelievoPass* pass, const RenderOptions& options, const Outputs& outputs)
{
  std::ofstream file(outputs.Temporary(options.Report), std::ios::binary);
  file << pass->GetFrameReport() << '\n';
  file.close();
  if (!file)
  {
    throw WorkError(options.Report + ": cannot be written; is the disk full?");
  }
}

//------------------------------------------------------------------------------
std::string Certify(vtkRelievoPass* pass, int rays)
{
  vtkRelievoShadowCertificate* certificate = pass->GetShadowStage()->Certify(rays);
  Messages::Check("--certify");
  return certificate->GetWords();
}

//------------------------------------------------------------------------------
// Somebody who asks for a stage should not have to guess why nothing of it is seen.
void NoteIdleStages(vtkRelievoPass* pass, const std::vector<StageChoice>& stages)
{
  for (const StageChoice& choice : stages)
  {
    vtkRelievoStage* stage = pass->GetStage(choice.Name);
    if (stage->GetReasonCode() != "ran")
    {
      const std::string asked =
        choice.Option + (choice.Option == StageChoice().Option ? " " + choice.Name : "");
      Messages::Note(asked + " changed nothing: " + stage->GetReason());
    }
  }
}

//------------------------------------------------------------------------------
void AddOutputs(
  const RenderOptions& options, const std::vector<std::string>& inputs, Outputs& outputs)
{
  const std::pair<const char*, const std::string&> places[] = { { "--png", options.PNG },
    { "--exr", options.EXR }, { "--report", options.Report } };
  for (const auto& [option, path] : places)
  {
    if (!path.empty())
    {
      outputs.Add(option, path, inputs);
    }
  }
}

//------------------------------------------------------------------------------
// The options of one frame of a sequence: its time, and the names of its files.
RenderOptions FrameOptions(const RenderOptions& options, int frame)
{
  RenderOptions own = options;
  own.Model.Time = options.Model.Times[static_cast<std::size_t>(frame)];
  for (std::string RenderOptions::*name :
    { &RenderOptions::PNG, &RenderOptions::EXR, &RenderOptions::Report })
  {
    own.*name = (own.*name).empty() ? "" : GetFrameName(own.*name, frame);
  }
  return own;
}

//------------------------------------------------------------------------------
// Draws the scene as it is and writes what is asked for, whole.
void DrawFrame(const Scene& scene, vtkRelievoPass* pass, const std::vector<std::string>& layers,
  const RenderOptions& options, Outputs& outputs, Progress& progress, const std::string& what)
{
  progress.Begin(what);
  if (!options.Report.empty())
  {
    pass->GetFrameReport(); // from now on frames are timed, whatever the OpenGL
  }
  for (int frame = 1; !options.Report.empty() && frame < FramesUntilTimed; ++frame)
  {
    scene.Window->Render();
    progress.Update(double(frame) / FramesUntilTimed);
  }
  vtkNew<vtkRelievoLayerSource> source;
  if (!options.EXR.empty())
  {
    source->SetRenderer(scene.Renderer);
    source->SetHDR(options.HDR);
    for (const std::string& name : layers)
    {
      source->AddLayer(name);
    }
    source->Update();
  }
  if (options.EXR.empty() || (options.HDR && !options.PNG.empty())) // which leaves the window alone
  {
    scene.Window->Render();
  }
  progress.End();
  Messages::Check(what);
  NoteIdleStages(pass, options.Stages);

  try
  {
    if (!options.PNG.empty())
    {
      WritePNG(scene.Window, options, outputs, progress);
    }
    if (!options.EXR.empty())
    {
      // The image and not the source's port: a source of layers draws anew whenever it is asked.
      WriteEXR(source->GetOutput(), options, outputs, progress);
    }
    if (!options.Report.empty())
    {
      WriteReport(pass, options, outputs);
    }
    for (const std::string& warning : Messages::TakeWarnings())
    {
      Messages::Warn(outputs.WithGivenNames(warning));
    }
  }
  catch (const WorkError& error)
  {
    throw WorkError(outputs.WithGivenNames(error.what()));
  }
}
}

//------------------------------------------------------------------------------
void Render(const RenderOptions& options)
{
  // What can be refused at once is refused before the long work.
  const std::vector<std::string> inputs = CheckInputs(options);
  const int frames = static_cast<int>(options.Model.Times.size());
  auto outputs = std::make_unique<Outputs>();
  AddOutputs(frames > 0 ? FrameOptions(options, 0) : options, inputs, *outputs);

  Messages::Collect();
  Progress progress;
  Scene scene = BuildScene(options, progress);
  SetSurface(scene.Renderer, options, progress);
  const FramePoints points = ReadFramePoints(options, progress);
  const std::vector<std::string> layers = LayersToCapture(options, scene);
  CheckShownLayer(options, scene);
  const int lights = CountLights(scene.Renderer);
  CheckShadowLayers(options, lights, lights == 1 ? "light" : "lights");
  CheckDisplay(scene.Window);

  const std::string size = std::to_string(options.Size[0]) + "x" + std::to_string(options.Size[1]);
  progress.Begin("rendering " + size);
  vtkRelievoPass* pass = nullptr;
  if (NeedsFrame(options) || !layers.empty() || !options.Report.empty() || options.Certify)
  {
    pass = vtkRelievoPass::Attach(scene.Renderer);
  }
  for (const std::string& name : layers)
  {
    if (name !=
      vtkRelievoLayerCatalogue::GetPicture()
        .Name) // the source's own: the picture as it is drawn anyway
    {
      pass->RequestLayer(name);
    }
  }
  CheckSize(scene.Window, options.Size);
  if (pass)
  {
    SetFrame(pass, scene.Renderer, options, points);
  }
  if (frames == 0)
  {
    DrawFrame(scene, pass, layers, options, *outputs, progress, "rendering " + size);
  }
  const std::string certificate = options.Certify ? Certify(pass, *options.Certify) : "";
  if (frames == 0)
  {
    outputs->Commit();
  }
  for (int frame = 0; frame < frames; ++frame)
  {
    const RenderOptions own = FrameOptions(options, frame);
    if (frame > 0)
    {
      outputs.reset(); // before the next one, which may have the same temporary names
      outputs = std::make_unique<Outputs>();
      AddOutputs(own, inputs, *outputs);
      PlayScene(scene, options, *own.Model.Time, progress);
    }
    DrawFrame(scene, pass, layers, own, *outputs, progress,
      "rendering " + size + ", frame " + std::to_string(frame + 1) + " of " +
        std::to_string(frames));
    outputs->Commit();
  }

  if (options.Certify)
  {
    std::printf("relievo: certified shadows: %s\n", certificate.c_str());
  }
  for (const std::string& note : Messages::TakeNotes())
  {
    std::fprintf(StandardError(), "relievo: %s\n", note.c_str());
  }
  for (const std::string& warning : Messages::TakeWarnings())
  {
    std::fprintf(StandardError(), "relievo: warning: %s\n", warning.c_str());
  }
}
}
