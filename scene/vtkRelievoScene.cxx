// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoScene.h"

#include "Bands.h"
#include "Baseline.h"
#include "Display.h"
#include "Errors.h"
#include "FrameList.h"
#include "Lens.h"
#include "Messages.h"
#include "Options.h"
#include "Outcome.h"
#include "OutputOptions.h"
#include "Progress.h"
#include "ReadContext.h"
#include "StyledScene.h"
#include "WriteOutputs.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoCalibration.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRelievoScene);

struct vtkRelievoScene::Internals : public reading::ProgressListener
{
  explicit Internals(vtkRelievoScene* owner)
    : Owner(owner)
  {
  }

  void Say(const std::string& what, double share) override
  {
    this->Doing = what;
    this->Owner->InvokeEvent(vtkCommand::ProgressEvent, &share);
  }
  bool IsStopped() override { return this->Owner->Abort; }

  void MakeWindow();
  void Read(reading::Progress& progress);
  void Update(reading::Progress& progress, int bandRows = 0);
  void EndBands();
  scene::Bands GetBands() const
  {
    return { this->Options.Size, this->IsOwnWindow ? this->BandRows : 0 };
  }

  vtkRelievoScene* Owner;
  vtkNew<vtkStringArray> Words, InputFiles, Notes, Warnings;
  scene::RenderOptions Options; // parsed words
  scene::Settings Settings;
  vtkSmartPointer<vtkRenderWindow> Window;
  bool IsOwnWindow = false;
  std::exception_ptr NoWindow;     // why no window could be made while reading a file
  std::array<int, 2> Size{};       // size given to the own window
  int BandRows = 0;                // while bands are drawn; 0: the whole picture
  std::string ReadingKey;          // of the files read; empty: none
  bool Played = false;             // a sequence has moved the models from the time of reading
  std::vector<std::string> Opened; // while reading
  scene::StyledScene Styled;
  std::string Certificate, Doing;
};

namespace
{
// Rethrows errors of work on files as WorkError about a file.
template <typename Work>
auto OnFiles(Work work)
{
  try
  {
    return work();
  }
  catch (const words::WorkError& error)
  {
    throw words::FileError(error.what());
  }
}

// Throws UsageError for frames, other than all, that a sequence does not have or a film lacks.
void CheckFrames(const int frames[2], const scene::RenderOptions& options)
{
  const bool isToEnd = frames[1] == VTK_INT_MAX;
  if (frames[0] == 0 && isToEnd)
  {
    return;
  }
  const int all = std::max(1, scene::CountFrames(options));
  if (frames[0] < 0 || frames[0] >= all || frames[1] <= frames[0] || (!isToEnd && frames[1] > all))
  {
    throw words::UsageError("Frames: got " + std::to_string(frames[0]) + " " +
      std::to_string(frames[1]) +
      ", expected a first frame and an end that is behind it, from 0 to " + std::to_string(all));
  }
  if (!options.Motion.Video.empty() && (frames[0] > 0 || (!isToEnd && frames[1] < all)))
  {
    throw words::UsageError(
      "Frames and --video: a film has all frames: leave out --video or draw all frames");
  }
}

bool IsTiled(vtkRenderWindow* window)
{
  const int* scale = window->GetTileScale();
  return scale[0] > 1 || scale[1] > 1;
}
}

//------------------------------------------------------------------------------
vtkRelievoScene::vtkRelievoScene()
  : Internal(new Internals(this))
{
}

//------------------------------------------------------------------------------
vtkRelievoScene::~vtkRelievoScene()
{
  if (vtkRenderer* renderer = this->GetRenderer())
  {
    vtkRelievoPass::Detach(renderer); // while there is a context
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoScene::Try(const std::function<void()>& work)
{
  this->Abort = false;
  const reading::Outcome outcome = reading::Try(work);
  this->Failure = outcome.Kind;
  this->FailureText = outcome.Text;
  const auto keep = [](const std::vector<std::string>& texts, vtkStringArray* list) {
    list->Initialize();
    for (const std::string& text : texts)
    {
      list->InsertNextValue(text);
    }
  };
  keep(reading::Messages::TakeNotes(), this->Internal->Notes);
  keep(reading::Messages::TakeWarnings(), this->Internal->Warnings);
  if (this->Failure != NO_FAILURE)
  {
    vtkErrorMacro(<< this->FailureText);
  }
  return this->Failure == NO_FAILURE;
}

//------------------------------------------------------------------------------
bool vtkRelievoScene::SetWords(vtkStringArray* words)
{
  return this->Try([this, words] {
    std::vector<std::string> given;
    for (vtkIdType i = 0; words && i < words->GetNumberOfValues(); ++i)
    {
      given.push_back(words->GetValue(i));
    }
    const scene::RenderOptions options = scene::ParseOptions(given);
    this->Internal->Settings = scene::Settings::FromWords(given);
    this->Internal->Options = options;
    this->Internal->Words->Initialize();
    for (const std::string& word : given)
    {
      this->Internal->Words->InsertNextValue(word);
    }
    std::vector<std::string> files = options.Files;
    files.insert(files.end(),
      { options.Surface.Environment, options.Surface.NormalMap, options.Surface.HeightMap,
        options.Motion.Path, vtkRelievoCalibration::IsFile(options.Lens) ? options.Lens : "" });
    for (const scene::PointsChoice& points : options.Points)
    {
      files.push_back(points.File);
    }
    this->Internal->InputFiles->Initialize();
    for (const std::string& file : files)
    {
      if (!file.empty())
      {
        this->Internal->InputFiles->InsertNextValue(file);
      }
    }
    this->Modified();
  });
}

//------------------------------------------------------------------------------
vtkStringArray* vtkRelievoScene::GetWords()
{
  return this->Internal->Words;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkRelievoScene::GetInputFiles()
{
  return this->Internal->InputFiles;
}

//------------------------------------------------------------------------------
void vtkRelievoScene::SetRenderWindow(vtkRenderWindow* window)
{
  if (this->Internal->Window != window)
  {
    vtkRenderer* renderer = this->GetRenderer();
    if (renderer && this->Internal->Window)
    {
      this->Internal->Window->RemoveRenderer(renderer);
    }
    if (renderer && window)
    {
      window->AddRenderer(renderer);
    }
    this->Internal->Window = window;
    this->Internal->IsOwnWindow = false;
    this->Internal->Size = {};
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkRelievoScene::GetRenderWindow()
{
  return this->Internal->Window;
}

//------------------------------------------------------------------------------
// Needed before the first use of its OpenGL.
void vtkRelievoScene::Internals::MakeWindow()
{
  if (!this->Window)
  {
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->IsOwnWindow = true;
  }
  scene::CheckDisplay(this->Window);
  const scene::Bands bands = this->GetBands();
  const std::array<int, 2> size = bands.GetWindowSize();
  const bool isSized =
    this->Size == size && std::equal(size.begin(), size.end(), this->Window->GetActualSize());
  if (this->IsOwnWindow && !isSized)
  {
    scene::CheckSize(this->Window, size, this->Options.Size);
    this->Size = size;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoScene::Internals::Read(reading::Progress& progress)
{
  // A layer of the strongest bones needs its array to be read, too.
  const std::string key =
    scene::GetReadingKey(this->Settings) + (this->Options.Model.FirstBone ? "first_bone" : "");
  if (key == this->ReadingKey && this->Styled.GetRenderer())
  {
    return;
  }
  // Starting OpenGL takes about as long as reading a mesh. Errors in files are reported first.
  this->NoWindow = nullptr;
  reading::ReadContext context(progress, this->Options.AllowedFolders);
  context.SetMeanwhile([this] {
    try
    {
      this->MakeWindow();
    }
    catch (const words::WorkError&)
    {
      this->NoWindow = std::current_exception();
    }
  });
  const scene::Scene read = OnFiles([&] { return scene::ReadScene(this->Options, context); });
  const scene::FramePoints points =
    OnFiles([&] { return scene::ReadFramePoints(this->Options, context); });
  if (vtkRenderer* before = this->Styled.GetRenderer())
  {
    vtkRelievoPass::Detach(before);
    this->Window->RemoveRenderer(before);
  }
  this->Styled = scene::StyledScene(read, points);
  this->ReadingKey = key;
  this->Played = false;
  this->Opened = context.GetFiles();
}

//------------------------------------------------------------------------------
void vtkRelievoScene::Internals::Update(reading::Progress& progress, int bandRows)
{
  if (this->Options.Files.empty())
  {
    throw words::UsageError("there is no file to show: give one among the words");
  }
  this->BandRows = bandRows;
  this->Read(progress);
  this->Options = scene::FollowFile(this->Options, this->Styled.GetScene());
  if (this->Played) // unchanged models keep the time of reading
  {
    scene::PlayScene(
      this->Styled.GetScene(), this->Options, this->Options.Model.Time.value_or(0.0), progress);
    this->Played = false;
  }
  if (this->NoWindow)
  {
    std::rethrow_exception(std::exchange(this->NoWindow, nullptr));
  }
  this->MakeWindow();
  vtkRenderer* renderer = this->Styled.GetRenderer();
  if (!this->Window->HasRenderer(renderer))
  {
    this->Window->AddRenderer(renderer);
  }
  if (this->IsOwnWindow && (bandRows > 0 || IsTiled(this->Window)))
  {
    this->GetBands().SetTiles(this->Window, renderer);
  }
  this->Styled.Update(this->Settings, this->Options, false, progress);
  if (!this->Options.View.Place && this->Options.Model.Times.size() > 1)
  {
    scene::FitTimes(this->Styled.GetScene(), this->Options, progress);
  }
}

//------------------------------------------------------------------------------
// The window and the renderer draw the whole picture again. Where OpenGL cannot, the window keeps
// its tiles until an Update() of a smaller picture.
void vtkRelievoScene::Internals::EndBands()
{
  vtkRenderer* renderer = this->Styled.GetRenderer();
  if (std::exchange(this->BandRows, 0) == 0 || !this->IsOwnWindow || !renderer)
  {
    return;
  }
  renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  try
  {
    this->MakeWindow();
    this->GetBands().SetTiles(this->Window, renderer);
  }
  catch (const std::exception&) // too large
  {
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoScene::Update()
{
  return this->Try([this] {
    OnFiles([this] { return scene::CheckInputs(this->Internal->Options); });
    reading::Progress progress(this->Internal.get());
    this->Internal->Update(progress);
  });
}

//------------------------------------------------------------------------------
bool vtkRelievoScene::Write()
{
  return this->Try([this] {
    // Refuses invalid requests before the long work.
    const scene::RenderOptions& options = this->Internal->Options;
    this->Internal->Certificate.clear();
    scene::CheckOutputs(options);
    OnFiles([&] { CheckFrames(this->Frames, options); });
    const scene::FrameRange frames{ this->Frames[0], this->Frames[1],
      [this](int frame) { this->InvokeEvent(FrameEvent, &frame); } };
    this->Internal->Options = scene::FollowProgram(options);
    std::vector<std::string> inputs = OnFiles([&options] { return scene::CheckInputs(options); });
    std::unique_ptr<reading::Outputs> outputs =
      OnFiles([&] { return scene::OpenOutputs(options, inputs, this->Frames[0]); });
    if (!options.Lens.empty())
    {
      this->Internal->Options = OnFiles([&options] { return scene::FollowLens(options); });
    }
    reading::Progress progress(this->Internal.get());
    const struct Afterwards
    {
      Internals& In;
      ~Afterwards() { this->In.EndBands(); }
    } afterwards{ *this->Internal };
    this->Internal->Update(progress, scene::ChooseBandRows(options, this->BandRows));
    this->Internal->Played = options.Model.Times.size() > 1;
    const std::vector<std::string>& opened = this->Internal->Opened;
    inputs.insert(inputs.end(), opened.begin(), opened.end());
    this->Internal->Certificate =
      scene::WriteOutputs(this->Internal->Styled, options, this->Internal->Settings,
        this->Internal->GetBands(), inputs, std::move(outputs), frames, progress);
  });
}

//------------------------------------------------------------------------------
bool vtkRelievoScene::CaptureBaseline(vtkImageData* image, bool portable)
{
  if (!image)
  {
    vtkErrorMacro("CaptureBaseline was given no image; give it a vtkImageData to fill.");
    return false;
  }
  image->Initialize();
  return this->Try([this, image, portable] {
    OnFiles([this] { return scene::CheckInputs(this->Internal->Options); });
    reading::Progress progress(this->Internal.get());
    this->Internal->Update(progress);
    progress.Begin("drawing the baseline");
    image->ShallowCopy(scene::MakeBaseline(
      this->Internal->Styled, this->Internal->Options, this->Internal->Settings, portable));
  });
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoScene::GetRenderer()
{
  return this->Internal->Styled.GetRenderer();
}

//------------------------------------------------------------------------------
vtkRelievoPass* vtkRelievoScene::GetPass()
{
  return this->Internal->Styled.GetFrame();
}

//------------------------------------------------------------------------------
int vtkRelievoScene::GetUpAxis()
{
  return this->Internal->Options.UpAxis;
}

//------------------------------------------------------------------------------
std::string vtkRelievoScene::GetFileOf(int actor)
{
  int end = 0;
  const std::vector<int>& counts = this->Internal->Styled.GetScene().Counts;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    end += counts[i];
    if (actor >= 0 && actor < end)
    {
      return this->Internal->Options.Files[i];
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkStringArray* vtkRelievoScene::GetNotes()
{
  return this->Internal->Notes;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkRelievoScene::GetWarnings()
{
  return this->Internal->Warnings;
}

//------------------------------------------------------------------------------
std::string vtkRelievoScene::GetCertificate()
{
  return this->Internal->Certificate;
}

//------------------------------------------------------------------------------
std::string vtkRelievoScene::GetProgressText()
{
  return this->Internal->Doing;
}

//------------------------------------------------------------------------------
std::string vtkRelievoScene::GetOptions()
{
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
  {
    all.push_back({ { "name", option.Name }, { "value", option.Form },
      { "repeats", option.Repeats }, { "outputs", option.OfOutputs }, { "help", option.Help } });
  }
  return all.dump();
}

//------------------------------------------------------------------------------
void vtkRelievoScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Words:";
  for (vtkIdType i = 0; i < this->Internal->Words->GetNumberOfValues(); ++i)
  {
    os << ' ' << this->Internal->Words->GetValue(i);
  }
  os << "\n" << indent << "Renderer: " << this->GetRenderer() << "\n";
  os << indent << "BandRows: " << this->BandRows << "\n";
  os << indent << "Frames: " << this->Frames[0] << " " << this->Frames[1] << "\n";
  os << indent << "RenderWindow: " << this->Internal->Window << "\n";
  os << indent << "Failure: " << this->Failure << "\n";
}
