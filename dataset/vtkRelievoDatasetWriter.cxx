// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDatasetWriter.h"

#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "DatasetObjects.h"
#include "DatasetParts.h"
#include "DatasetPoses.h"
#include "DatasetView.h"
#include "Errors.h"
#include "Messages.h"
#include "Numbers.h"
#include "Outcome.h"
#include "Values.h"
#include "WorkFolder.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoOption.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRelievoScene.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fnmatch.h>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

vtkStandardNewMacro(vtkRelievoDatasetWriter);

static_assert(static_cast<int>(vtkRelievoScene::USAGE_FAILURE) == reading::Outcome::Usage &&
    static_cast<int>(vtkRelievoScene::FILE_FAILURE) == reading::Outcome::File &&
    static_cast<int>(vtkRelievoScene::DRAW_FAILURE) == reading::Outcome::Draw,
  "one word for a failure");

namespace fs = std::filesystem;

namespace
{
using Json = nlohmann::ordered_json;

// The largest depth of a bounds' corner in any camera.
double FindFarthest(
  const std::vector<vtkSmartPointer<vtkRelievoCameraModel>>& cameras, const vtkBoundingBox& box)
{
  double farthest = 0.0;
  for (const auto& camera : cameras)
  {
    double center[3];
    for (int i = 0; i < 3; ++i)
    {
      center[i] = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        center[i] -= camera->GetRotation()[3 * k + i] * camera->GetTranslation()[k];
      }
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      double point[3];
      box.GetCorner(corner, point);
      farthest = std::max(farthest, camera->GetDepth(center, point));
    }
  }
  return farthest;
}

std::vector<std::string> GetNames(const dataset::DatasetObjects& objects)
{
  std::vector<std::string> names;
  for (const dataset::DatasetObject& object : objects.Get())
  {
    names.push_back(object.Name);
  }
  return names;
}
}

struct vtkRelievoDatasetWriter::Internals
{
  vtkSmartPointer<vtkRenderer> Renderer;
  std::string Directory, Description;
  Json Variation;
  std::vector<vtkSmartPointer<vtkRelievoCameraModel>> Cameras;
  std::vector<std::string> Layers;
  std::map<int, std::string> Names;
  std::vector<std::pair<std::string, std::string>> Categories; // pattern of objects, category

  std::string GetRecord(std::size_t view) const
  {
    return dataset::GetDatasetRecord(this->Directory, view);
  }

  // Complete views.
  std::vector<std::size_t> FindRecords() const
  {
    std::vector<std::size_t> views;
    for (std::size_t view = 0; view < this->Cameras.size(); ++view)
    {
      if (fs::exists(this->GetRecord(view)))
      {
        views.push_back(view);
      }
    }
    return views;
  }

  Json ReadRecord(const dataset::DatasetStyle& style, std::size_t view, std::size_t objects) const;

  void Check(const dataset::DatasetFormat& format, double validation, bool varies) const;
  std::vector<std::string> GetCategories(const std::vector<std::string>& objects) const;
  void CheckIsPinhole() const;
  static void CheckObjects(
    const dataset::DatasetObjects& objects, const std::vector<std::string>& names, int view);
  double GetDepthStep(const dataset::DatasetObjects& objects) const;
  void WriteIndex(
    const dataset::DatasetStyle& style, const std::vector<std::string>& objects) const;
};

//------------------------------------------------------------------------------
vtkRelievoDatasetWriter::vtkRelievoDatasetWriter()
  : Internal(new Internals)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  vtkRelievoParameterList& list = this->Parameters;
  std::vector<std::string> names;
  for (const auto& format : dataset::GetDatasetFormats())
  {
    names.push_back(format->Name);
  }
  list.AddChoice(
    "format", this->Format, [this](int format) { this->SetFormat(format); }, names,
    "Layout of the files in the folder.");
  list.AddNumber(
    "depth_step", this->DepthStep, [this](double units) { this->SetDepthStep(units); }, 0.0,
    infinity, "",
    "World units per step of 16-bit depth; 0: the largest depth of the scene is the last "
    "step.");
  list
    .AddNumber(
      "mm_per_unit", this->MillimetersPerUnit,
      [this](double millimeters) { this->SetMillimetersPerUnit(millimeters); }, 0.0, infinity, "",
      "For bop: millimetres per world unit.")
    .Open = true;
  list.AddNumber(
    "validation", this->Validation, [this](double share) { this->SetValidation(share); }, 0.0, 1.0,
    "", "For coco, nerf, yolo and kitti: share of the views for validation, spread evenly.");
  list.AddNumber(
    "shard_size", this->ShardSize, [this](double megabytes) { this->SetShardSize(megabytes); },
    0.001, 1e6, "megabytes", "For webdataset: the largest size of an archive of several views.");
  list.AddWhole(
    "seed", this->Seed, [this](int seed) { this->SetSeed(seed); }, least, most, "",
    "Seed of random poses and suns.");
  list.AddFlag(
    "random_sun", this->RandomSun, [this](bool on) { this->SetRandomSun(on); },
    "Moves the sun in each view.");
  list.AddChoice(
    "up", this->UpAxis, [this](int axis) { this->SetUpAxis(axis); }, { "x", "y", "z" },
    "The axis that points up.");
}

//------------------------------------------------------------------------------
vtkRelievoDatasetWriter::~vtkRelievoDatasetWriter() = default;

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetFormat(int format)
{
  const int known =
    std::clamp(format, 0, static_cast<int>(dataset::GetDatasetFormats().size()) - 1);
  if (this->Format != known)
  {
    this->Format = known;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoDatasetWriter::Try(const std::function<void()>& work)
{
  this->Abort = false;
  const reading::Outcome outcome = reading::Try(work);
  this->Failure = outcome.Kind;
  this->FailureText = outcome.Text;
  for (const std::string& warning : reading::Messages::TakeWarnings())
  {
    vtkWarningMacro(<< warning);
  }
  if (this->Failure != reading::Outcome::Done)
  {
    vtkErrorMacro(<< this->FailureText);
  }
  return this->Failure == reading::Outcome::Done;
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetRenderer(vtkRenderer* renderer)
{
  this->Internal->Renderer = renderer;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoDatasetWriter::GetRenderer()
{
  return this->Internal->Renderer;
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetDirectory(RELIEVO_TEXT directory)
{
  this->Internal->Directory = directory;
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoDatasetWriter::GetDirectory()
{
  return this->Internal->Directory;
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::AddView(vtkRelievoCameraModel* camera)
{
  if (!camera)
  {
    vtkErrorMacro("AddView was given no camera.");
    return;
  }
  this->Internal->Cameras.push_back(
    vtkSmartPointer<vtkRelievoCameraModel>::Take(camera->NewInstance()));
  this->Internal->Cameras.back()->Copy(camera);
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoDatasetWriter::AddViews(RELIEVO_TEXT words, vtkRelievoCameraModel* like)
{
  return this->Try([this, &words, like] {
    if (!like)
    {
      throw words::UsageError("poses: there is no camera that has their size and intrinsics");
    }
    dataset::DatasetSurroundings around = { {}, this->UpAxis, this->Seed };
    if (this->Internal->Renderer)
    {
      const dataset::DatasetObjects objects(
        this->Internal->Renderer, this->Internal->Names, this->ObjectsByBlock);
      around.Box = objects.GetBounds();
    }
    const auto made = dataset::MakeDatasetPoses("poses", words, like, around);
    this->Internal->Cameras.insert(this->Internal->Cameras.end(), made.begin(), made.end());
    this->Modified();
  });
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::RemoveAllViews()
{
  this->Internal->Cameras.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoDatasetWriter::GetNumberOfViews()
{
  return static_cast<int>(this->Internal->Cameras.size());
}

//------------------------------------------------------------------------------
vtkRelievoCameraModel* vtkRelievoDatasetWriter::GetView(int i)
{
  return i >= 0 && i < this->GetNumberOfViews() ? this->Internal->Cameras[i].GetPointer() : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::AddLayer(RELIEVO_TEXT name)
{
  std::vector<std::string>& layers = this->Internal->Layers;
  if (std::find(layers.begin(), layers.end(), name) == layers.end())
  {
    layers.push_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::RemoveAllLayers()
{
  this->Internal->Layers.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetObjectName(int actor, RELIEVO_TEXT name)
{
  this->Internal->Names[actor] = name;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetCategory(RELIEVO_TEXT pattern, RELIEVO_TEXT category)
{
  this->Internal->Categories.emplace_back(pattern, category);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::RemoveAllCategories()
{
  this->Internal->Categories.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetDescription(RELIEVO_TEXT text)
{
  this->Internal->Description = text;
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoDatasetWriter::GetDescription()
{
  return this->Internal->Description;
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::Internals::Check(
  const dataset::DatasetFormat& format, double validation, bool varies) const
{
  const auto refuse = [&format](const std::string& what, bool dataset::DatasetFormat::*has) {
    std::vector<std::string> others;
    for (const auto& other : dataset::GetDatasetFormats())
    {
      if ((*other).*has)
      {
        others.push_back(other->Name);
      }
    }
    throw words::UsageError(what + ": cannot be written in the format " + format.Name +
      "; expected the format " + vtkRelievoEither(others));
  };
  if (!this->Categories.empty() && !format.HasCategories)
  {
    refuse("category " + this->Categories[0].second, &dataset::DatasetFormat::HasCategories);
  }
  if (validation > 0.0 && !format.HasSplit)
  {
    refuse("validation", &dataset::DatasetFormat::HasSplit);
  }
  if (!this->Renderer)
  {
    throw words::UsageError("there is no renderer; give one by SetRenderer");
  }
  if (this->Directory.empty())
  {
    throw words::UsageError("there is no folder to write to; give one by SetDirectory");
  }
  if (this->Cameras.empty())
  {
    throw words::UsageError("there are no views; give some by AddView or AddViews");
  }
  double viewport[4];
  this->Renderer->GetViewport(viewport);
  if (viewport[0] != 0.0 || viewport[1] != 0.0 || viewport[2] != 1.0 || viewport[3] != 1.0)
  {
    throw words::UsageError(
      "the renderer's viewport is a part of its window; give one that fills it");
  }
  for (const std::string& layer : this->Layers)
  {
    format.CheckLayer(layer);
  }
  const auto flow = std::find_if(this->Layers.begin(), this->Layers.end(),
    [](const std::string& layer) { return vtkRelievoRayLayers::IsFlow(layer.c_str()); });
  for (std::size_t i = 0; i < this->Cameras.size(); ++i)
  {
    const std::string view = "view " + std::to_string(i);
    dataset::CheckDatasetCamera(format, this->Cameras[i], this->Cameras[0], view);
    // Flow goes to the previous view; the first view has none and uses itself.
    const bool isGoal = i == 0 || i + 1 < this->Cameras.size();
    if (flow != this->Layers.end() && varies)
    {
      throw words::UsageError("layer " + *flow +
        ": got a scene that varies between views, expected layers without flow, which leads to "
        "the previous view of one scene");
    }
    if (flow != this->Layers.end() && isGoal && !this->Cameras[i]->HasPlaces())
    {
      throw words::UsageError(view + ": layer " + *flow +
        " refers to places in a picture, which this lidar does not have between its beams; "
        "expected another sensor, or layers without flow");
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::Internals::CheckIsPinhole() const
{
  for (std::size_t i = 0; i < this->Cameras.size(); ++i)
  {
    auto* lens = vtkRelievoLensCamera::SafeDownCast(this->Cameras[i]);
    if (!lens || lens->GetLens() != vtkRelievoLensCamera::PINHOLE)
    {
      throw words::UsageError("view " + std::to_string(i) +
        ": volumes that are solid need pinhole cameras: a lens and other sensors trace rays, which "
        "volumes are not in; switch solid of the stage volumes off");
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::Internals::CheckObjects(
  const dataset::DatasetObjects& objects, const std::vector<std::string>& names, int view)
{
  const std::vector<std::string> found = GetNames(objects);
  if (found != names)
  {
    throw words::UsageError("view " + std::to_string(view) + ": got the objects " +
      words::Join(found, ", ") + ", expected those of view 0, " + words::Join(names, ", ") +
      ": a scene that varies keeps its visible actors");
  }
}

//------------------------------------------------------------------------------
// The category of each object. Throws UsageError for patterns without an object.
std::vector<std::string> vtkRelievoDatasetWriter::Internals::GetCategories(
  const std::vector<std::string>& objects) const
{
  std::vector<std::string> categories = objects;
  for (const auto& [pattern, category] : this->Categories)
  {
    if (category.empty() || pattern.empty())
    {
      throw words::UsageError("category: got '" + category + "' for the objects '" + pattern +
        "', expected a category and a name or pattern that are not empty");
    }
    std::string escaped; // only * and ? are special
    for (const char letter : pattern)
    {
      escaped += letter == '[' || letter == '\\' ? "\\" : "";
      escaped += letter;
    }
    bool isFound = false;
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
      if (pattern == objects[i] || fnmatch(escaped.c_str(), objects[i].c_str(), 0) == 0)
      {
        categories[i] = category;
        isFound = true;
      }
    }
    if (!isFound)
    {
      throw words::UsageError("category " + category + ": no object is called " + pattern +
        "; expected a name or pattern of " + words::Join(objects, ", "));
    }
  }
  return categories;
}

//------------------------------------------------------------------------------
double vtkRelievoDatasetWriter::Internals::GetDepthStep(
  const dataset::DatasetObjects& objects) const
{
  const vtkBoundingBox box = objects.GetOpaqueBounds();
  const double farthest = box.IsValid() ? FindFarthest(this->Cameras, box) : 0.0;
  return farthest > 0.0 ? farthest / dataset::MostDepthSteps : 1.0; // without depth
}

//------------------------------------------------------------------------------
// Throws FileError for a damaged record, UsageError for one of another camera.
Json vtkRelievoDatasetWriter::Internals::ReadRecord(
  const dataset::DatasetStyle& style, std::size_t view, std::size_t objects) const
{
  const std::string path = this->GetRecord(view);
  Json record = dataset::ReadWorkJson(path);
  if (!dataset::IsDatasetRecord(*style.Format, record, objects) || record["view"] != view)
  {
    throw words::FileError(path + ": is no record of view " + std::to_string(view) +
      "; remove it, and the same call draws the view again");
  }
  const Json camera = dataset::DescribeDatasetCamera(this->Cameras[view]);
  if (record["camera"] != Json::parse(dataset::WriteDatasetJson(camera)))
  {
    throw words::UsageError(this->Directory + ": view " + std::to_string(view) +
      " was written from another camera; give another folder, or the poses of before");
  }
  return record;
}

//------------------------------------------------------------------------------
// The process that ends last must index all views, so look again for views added meanwhile.
void vtkRelievoDatasetWriter::Internals::WriteIndex(
  const dataset::DatasetStyle& style, const std::vector<std::string>& objects) const
{
  std::vector<std::size_t> views = this->FindRecords();
  std::vector<std::size_t> written;
  while (views != written)
  {
    std::vector<Json> records;
    for (const std::size_t view : views)
    {
      records.push_back(this->ReadRecord(style, view, objects.size()));
    }
    dataset::WriteDatasetIndex(style, objects, records);
    written = views;
    views = this->FindRecords();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoDatasetWriter::Write()
{
  this->NumberOfViewsWritten = 0;
  this->NumberOfViewsKept = 0;
  return this->Try([this] { this->WriteViews(); });
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetPart(int part, int parts)
{
  if (parts < 1 || part < 1 || part > parts)
  {
    vtkErrorMacro("SetPart: got " << part << " of " << parts
                                  << ", expected a part from 1 to the number of parts.");
    return;
  }
  this->Part = part;
  this->NumberOfParts = parts;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoDatasetWriter::Merge(RELIEVO_TEXT directory)
{
  const std::string folder = directory;
  return this->Try([&folder] { dataset::MergeDataset(folder); });
}

//------------------------------------------------------------------------------
int vtkRelievoDatasetWriter::Verify(RELIEVO_TEXT directory)
{
  constexpr int different = 3; // as of relievo compare
  const std::string folder = directory;
  bool isWhole = false;
  const bool done = this->Try([&] {
    const dataset::WorkState state = dataset::VerifyDataset(folder, dataset::WorkCheck::Files);
    this->Verdict = state.GetText(folder);
    isWhole = state.IsWhole();
  });
  return !done ? -1 : isWhole ? 0 : different;
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::SetVariation(RELIEVO_TEXT json)
{
  const std::string text = json;
  Json described = Json::parse(text, nullptr, false);
  if (described.is_discarded())
  {
    vtkErrorMacro("SetVariation: got '" << text << "', expected JSON.");
    return;
  }
  this->Internal->Variation = std::move(described);
}

//------------------------------------------------------------------------------
// Lets observers change the scene for a view.
void vtkRelievoDatasetWriter::Vary(int view)
{
  this->Internal->Variation = nullptr;
  this->InvokeEvent(vtkCommand::StartEvent, &view);
  if (this->Abort)
  {
    throw words::WorkError(
      this->Internal->Directory + ": stopped before view " + std::to_string(view));
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::WriteViews()
{
  Internals& self = *this->Internal;
  const dataset::DatasetFormat& format =
    *dataset::GetDatasetFormats()[static_cast<std::size_t>(this->Format)];
  self.Check(format, this->Validation, this->SceneVaries);
  const int views = this->GetNumberOfViews();
  const dataset::WorkPart part{ this->Part, this->NumberOfParts };
  const bool isPart = part.Count > 1;
  int begin = this->Range[0];
  int end = this->Range[1] < 0 ? views : this->Range[1];
  const std::string range = "views: got " + std::to_string(begin) + ":" + std::to_string(end);
  if (isPart && (begin > 0 || end < views))
  {
    throw words::UsageError(
      range + " and " + part.GetText() + "; expected a range of views or a part of all of them");
  }
  if (begin >= end)
  {
    throw words::UsageError(range + ", expected the first view to be before the end");
  }
  if (begin < 0 || end > views)
  {
    throw words::UsageError(range + ", expected views from 0 to " + std::to_string(views) +
      ": there are " + std::to_string(views));
  }
  const auto takeObjects = [this, &self] {
    return dataset::DatasetObjects(self.Renderer, self.Names, this->ObjectsByBlock);
  };
  if (this->SceneVaries)
  {
    this->Vary(0); // so that equal calls have equal settings, whatever the scene was like before
  }
  dataset::DatasetObjects objects = takeObjects();
  if (objects.HasVolumes())
  {
    self.CheckIsPinhole();
  }
  const std::vector<std::string> names = GetNames(objects);
  dataset::DatasetStyle style;
  style.Folder = self.Directory;
  style.Format = &format;
  style.DepthStep = this->DepthStep > 0.0 ? this->DepthStep : self.GetDepthStep(objects);
  style.MillimetersPerUnit = this->MillimetersPerUnit;
  style.Layers = self.Layers;
  const std::vector<std::string> categories = self.GetCategories(names);
  style.SetCategories(categories);
  style.Validation = this->Validation;
  style.ShardBytes = dataset::BytesOfMegabyte * this->ShardSize;
  int validation = 0;
  for (int view = 0; view < views; ++view)
  {
    validation += style.IsValidation(static_cast<std::size_t>(view)) ? 1 : 0;
  }
  if (style.Validation > 0.0 && (validation == 0 || validation == views))
  {
    throw words::UsageError("validation: got " + words::WriteNumber(style.Validation) +
      ", which is " + std::to_string(validation) + " of " + std::to_string(views) +
      " views; expected 0, or a share that leaves views for training and for validation");
  }
  Json described = { { "version", RELIEVO_VERSION }, { "format", format.Name }, { "views", views },
    { "objects", names }, { "categories", categories }, { "validation", style.Validation },
    { "layers", self.Layers }, { "depth_step", style.DepthStep },
    { "mm_per_unit", this->MillimetersPerUnit }, { "random_sun", this->RandomSun },
    { "seed", this->Seed }, { "up_axis", std::string(1, "xyz"[this->UpAxis]) },
    { "scene", self.Description } };
  if (this->SceneVaries)
  {
    described["scene_varies"] = true;
  }
  if (std::string(format.Name) == "webdataset")
  {
    described["shard_size"] = this->ShardSize;
  }
  const std::string settings =
    dataset::OpenWorkFolder(self.Directory, dataset::DatasetSettings, described);
  if (isPart)
  {
    const auto share = part.GetRange(views);
    begin = static_cast<int>(share[0]);
    end = static_cast<int>(share[1]);
  }
  dataset::PartProgress progress(self.Directory, part, "views");
  dataset::DatasetPainter painter(self.Renderer, objects, self.Layers, format.NeedsSilhouettes);
  const auto describe = [&](int i) {
    const auto number = static_cast<std::size_t>(i);
    dataset::DatasetShot shot;
    shot.Camera = self.Cameras[number];
    shot.Before = i > 0 ? self.Cameras[number - 1].GetPointer() : nullptr;
    if (this->RandomSun)
    {
      shot.Sun = dataset::MakeDatasetSun(this->Seed, i, this->UpAxis);
    }
    return shot;
  };
  bool isSingle = false; // views drawn together have failed
  // This view, and those after it that have no record and are drawn together with it.
  const auto findShots = [&](int i) {
    std::vector<dataset::DatasetShot> shots = { describe(i) };
    const std::size_t most =
      this->SceneVaries || isSingle ? 1 : painter.GetNumberTogether(shots.front().Camera);
    const int* size = shots.front().Camera->GetSize();
    for (int next = i + 1; next < end && shots.size() < most; ++next)
    {
      const dataset::DatasetShot shot = describe(next);
      if (painter.GetNumberTogether(shot.Camera) == 1 ||
        !std::equal(size, size + 2, shot.Camera->GetSize()) ||
        fs::exists(self.GetRecord(static_cast<std::size_t>(next))))
      {
        break;
      }
      shots.push_back(shot);
    }
    return shots;
  };
  std::deque<dataset::DatasetView> drawn; // this view and those after it
  std::size_t beyond = 0;
  for (int i = begin; i < end; ++i)
  {
    const auto number = static_cast<std::size_t>(i);
    vtkRelievoCameraModel* camera = self.Cameras[number];
    const std::string path = self.GetRecord(number);
    Json before;
    if (fs::exists(path))
    {
      before = self.ReadRecord(style, number, names.size());
    }
    if (!before.is_null() && before.value("settings", Json()) == settings &&
      dataset::FindDamage(self.Directory, before).empty())
    {
      ++this->NumberOfViewsKept;
    }
    else
    {
      Json record = { { "view", i }, { "camera", dataset::DescribeDatasetCamera(camera) } };
      if (this->SceneVaries)
      {
        painter.RestoreLights(); // which the scene may replace
        this->Vary(i);
        objects = takeObjects();
        self.CheckObjects(objects, names, i);
        if (!self.Variation.is_null())
        {
          record["variation"] = self.Variation;
        }
      }
      if (this->RandomSun)
      {
        record["sun"] = *describe(i).Sun;
      }
      if (drawn.empty())
      {
        const std::vector<dataset::DatasetShot> shots = findShots(i);
        std::vector<dataset::DatasetView> together;
        try
        {
          together = painter.Draw(shots);
        }
        catch (const words::WorkError&)
        {
          if (shots.size() == 1)
          {
            throw;
          }
          isSingle = true; // one needs less memory, and those before a failing one are written
          together = painter.Draw({ shots.front() });
        }
        std::move(together.begin(), together.end(), std::back_inserter(drawn));
      }
      beyond += dataset::WriteDatasetView(style, drawn.front(), objects, camera, number, record);
      if (i == 0)
      {
        format.WriteModels(style, self.Renderer, objects); // their hashes are in the first record
      }
      record["version"] = RELIEVO_VERSION;
      record["settings"] = settings;
      record["files"] = style.Hashes;
      dataset::CheckSettings(self.Directory, dataset::DatasetSettings, settings);
      dataset::WriteWhole(path, dataset::WriteDatasetJson(record));
      ++this->NumberOfViewsWritten;
    }
    if (!drawn.empty()) // also of a view that another process has drawn meanwhile
    {
      drawn.pop_front();
    }
    style.Hashes.clear();
    if (isPart && this->NumberOfViewsWritten > 0)
    {
      progress.Update(i + 1 - begin, end - begin, this->NumberOfViewsKept);
    }
    double share = static_cast<double>(i + 1 - begin) / (end - begin);
    this->InvokeEvent(vtkCommand::ProgressEvent, &share);
    if (this->Abort)
    {
      throw words::WorkError(self.Directory + ": stopped after view " + std::to_string(i) +
        "; the same call goes on from there");
    }
  }
  if (!isPart)
  {
    self.WriteIndex(style, names);
  }
  if (beyond > 0)
  {
    reading::Messages::Warn(self.Directory + ": " + std::to_string(beyond) +
      " pixels are farther than 65535 steps of depth, or behind the camera's plane, and "
      "are 0; a larger depth step covers the former");
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDatasetWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Internal->Renderer << "\n";
  os << indent << "Directory: " << this->Internal->Directory << "\n";
  os << indent << "Views: " << this->Internal->Cameras.size() << "\n";
  os << indent << "Layers: " << words::Join(this->Internal->Layers, ", ") << "\n";
  for (const auto& [pattern, category] : this->Internal->Categories)
  {
    os << indent << "Category: " << category << " of " << pattern << "\n";
  }
  os << indent << "SceneVaries: " << this->SceneVaries << "\n";
  os << indent << "ObjectsByBlock: " << this->ObjectsByBlock << "\n";
  this->Parameters.Print(os, indent);
  os << indent << "Range: " << this->Range[0] << ", " << this->Range[1] << "\n";
  os << indent << "Part: " << this->Part << " of " << this->NumberOfParts << "\n";
}
