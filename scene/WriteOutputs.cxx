// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WriteOutputs.h"

#include "Bands.h"
#include "Baseline.h"
#include "DataSets.h"
#include "Errors.h"
#include "Flow.h"
#include "Frame.h"
#include "FrameList.h"
#include "Lens.h"
#include "Messages.h"
#include "Numbers.h"
#include "Options.h"
#include "Outputs.h"
#include "Progress.h"
#include "Scene.h"
#include "SequenceOptions.h"
#include "ShadowOptions.h"
#include "Shadows.h"
#include "StandardError.h"
#include "StyledScene.h"
#include "Transparency.h"
#include "Values.h"
#include "VideoFile.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoGltfWriter.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoTiles.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace scene
{
namespace
{
// Without --layers, an EXR file holds the colour and the depth.
const std::vector<std::string> DefaultLayers = { "depth" };

// GPU times arrive a frame or more later without waiting, so a report needs a few frames.
constexpr int FramesUntilTimed = 4;

// Throws UsageError if no drawn prop can provide the layer.
void CheckLayer(const std::string& option, const std::string& name, const Scene& scene)
{
  if (vtkRelievoLayerCatalogue::GetIsLayer(name) || scene.Arrays.Names.count(name) != 0 ||
    scene.Arrays.Placed.count(name) != 0)
  {
    return;
  }
  if (option == "--layers" && vtkRelievoRayLayers::IsFlow(name.c_str()))
  {
    RefuseValue(option, name,
      "several times as well, as in --times 0:1:0.1: it goes from each frame to the "
      "previous one");
  }
  const std::vector<std::string> arrays(scene.Arrays.Names.begin(), scene.Arrays.Names.end());
  RefuseValue(option, name,
    "one of " + vtkRelievoLayerCatalogue::GetLayerNames() +
      (arrays.empty() ? "; the files hold no arrays" : ", or an array: " + Join(arrays, ", ")));
}

// The layer shown as the picture, if any.
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
    if (!IsFlowOfFrames(options, name))
    {
      CheckLayer("--layers", name, scene);
      if (!options.Lens.empty())
      {
        CheckLensLayer(name);
      }
    }
    if (std::find(layers.begin(), layers.end(), name) == layers.end())
    {
      layers.push_back(name);
    }
  }
  return layers;
}

//------------------------------------------------------------------------------
// Whether the picture shows nothing but background: each row has one colour, within the level of
// newer VTK versions' dithered gradients, and no prop is in view. A fitted camera leaves a margin
// of at least a pixel unless the picture is narrow; colours alone decide then.
bool ShowsNothing(vtkRenderWindow* window, vtkImageData* picture, const RenderOptions& options)
{
  if (std::any_of(options.Stages.begin(), options.Stages.end(),
        [](const StageChoice& stage) { return stage.Name == "display"; }))
  {
    return false;
  }
  const int* size = picture->GetDimensions();
  const auto components = static_cast<std::size_t>(picture->GetNumberOfScalarComponents());
  const auto length = components * static_cast<std::size_t>(size[0]);
  for (int y = 0; y < size[1]; ++y)
  {
    const auto* row = static_cast<const unsigned char*>(picture->GetScalarPointer(0, y, 0));
    for (std::size_t i = components; i < length; ++i)
    {
      if (std::abs(row[i] - row[i % components]) > 1)
      {
        return false;
      }
    }
  }
  if (!options.Lens.empty() ||
    (!options.View.Place && !options.View.ParallelScale && !options.View.Clip && size[0] >= 16))
  {
    return true;
  }
  std::vector<float> depths(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  return window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths.data()) == VTK_OK &&
    std::all_of(depths.begin(), depths.end(), [](float depth) { return depth >= 1.f; });
}

//------------------------------------------------------------------------------
// Whether the data has a polygon with area, a line or a point. If it brings its own colours, these
// must not all be transparent.
bool HasVisibleCells(vtkDataSet* data, bool isColored)
{
  auto* colors = vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetScalars()
      ? data->GetPointData()->GetScalars()
      : data->GetCellData()->GetScalars());
  if (isColored && colors && colors->GetNumberOfComponents() == 4 && colors->GetRange(3)[1] == 0.)
  {
    return false;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh || mesh->GetNumberOfLines() + mesh->GetNumberOfVerts() + mesh->GetNumberOfStrips() > 0)
  {
    return true;
  }
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(size, corners);
    double normal[3];
    vtkPolygon::ComputeNormal(mesh->GetPoints(), static_cast<int>(size), corners, normal);
    if (vtkMath::Norm(normal) > 0.)
    {
      return true;
    }
  }
  return false;
}

// Whether only the ground is visible: such a picture counts as not empty.
bool ShowsGroundAlone(const Scene& scene, const RenderOptions& options)
{
  if (!scene.Ground || scene.Grid || !options.Points.empty() ||
    scene.Renderer->GetVolumes()->GetNumberOfItems() > 0)
  {
    return false;
  }
  bool shown = false;
  vtkActorCollection* actors = scene.Renderer->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    vtkMapper* mapper = actor->GetMapper();
    vtkDataObject* data = mapper ? mapper->GetInputDataObject(0, 0) : nullptr;
    if (data && actor != scene.Ground && actor->GetVisibility() &&
      actor->GetProperty()->GetOpacity() > 0.)
    {
      const bool isColored =
        mapper->GetScalarVisibility() && mapper->GetScalarMode() == VTK_SCALAR_MODE_DEFAULT;
      ForEachDataSet(
        data, [&](vtkDataSet* part) { shown = shown || HasVisibleCells(part, isColored); });
    }
  }
  return !shown;
}

//------------------------------------------------------------------------------
// The window's picture, or that of its present band.
vtkSmartPointer<vtkImageData> Grab(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  int size[2];
  renderer->GetTiledSize(&size[0], &size[1]);
  if (window->GetTileScale()[1] == 1) // a program's window may have more renderers
  {
    std::copy_n(window->GetActualSize(), 2, size);
  }
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, window->GetDoubleBuffer() ? 0 : 1, bytes);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(bytes);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DrawOver(const Scene& scene, double grey)
{
  const Backdrop backdrop(scene, grey);
  scene.Renderer->GetRenderWindow()->Render();
  return Grab(scene.Renderer);
}

//------------------------------------------------------------------------------
// Inserts the chunk pHYs, pixels per metre, behind the header (Portable Network Graphics
// Specification, Third Edition, W3C 2025, 11.3.4.3).
void SetResolution(const std::string& path, double dpi)
{
  constexpr std::size_t header = 33; // bytes of the signature and of IHDR
  constexpr double inch = 0.0254;    // metres
  const auto perMetre = static_cast<std::uint32_t>(std::lround(dpi / inch));
  std::string chunk = "pHYs";
  const auto append = [&chunk](std::uint32_t number) {
    for (const int shift : { 24, 16, 8, 0 })
    {
      chunk += static_cast<char>(number >> shift & 0xFFU);
    }
  };
  append(perMetre);
  append(perMetre);
  chunk += '\x01';                 // the unit is the metre
  std::uint32_t crc = 0xFFFFFFFFU; // its Annex D
  for (const char byte : chunk)
  {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
    {
      crc = (crc & 1U) != 0 ? 0xEDB88320U ^ crc >> 1U : crc >> 1U;
    }
  }
  append(~crc);
  std::ifstream read(path, std::ios::binary);
  std::string bytes{ std::istreambuf_iterator<char>(read), std::istreambuf_iterator<char>() };
  read.close();
  if (bytes.size() > header)
  {
    bytes.insert(header, std::string({ 0, 0, 0, 9 }) + chunk);
    std::ofstream(path, std::ios::binary) << bytes;
  }
}

//------------------------------------------------------------------------------
void WritePNG(const Scene& scene, vtkImageData* picture, bool isEmpty, const RenderOptions& options,
  const Outputs& outputs, Progress& progress)
{
  progress.Begin("writing " + options.PNG);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(outputs.Temporary(options.PNG).c_str());
  progress.Observe(writer);
  {
    const SilentLibraries silence; // libpng prints errors that the writer reports
    writer->Write();
  }
  if (options.Look.Print.Width > 0.0 && writer->GetErrorCode() == 0)
  {
    SetResolution(outputs.Temporary(options.PNG), options.Look.Print.DPI);
  }
  Messages::Check(options.PNG, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
  if (ShowsGroundAlone(scene, options))
  {
    Messages::Note(options.PNG +
      ": shows only the ground: everything else is fully transparent, or has no area");
  }
  else if (isEmpty)
  {
    Messages::Note(options.PNG + ": shows only the background: " +
      (options.Look.Opacity == 0.0 ? "--opacity 0 makes surfaces invisible"
                                   : "everything else is out of view, thinner than a pixel, or has "
                                     "the background's colour"));
  }
}

//------------------------------------------------------------------------------
void WriteEXR(
  vtkImageData* image, const std::string& path, const Outputs& outputs, Progress& progress)
{
  progress.Begin("writing " + path);
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(outputs.Temporary(path).c_str());
  progress.Observe(writer);
  writer->Write();
  Messages::Check(path, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
}

//------------------------------------------------------------------------------
// The frame's metadata and the camera's calibration.
void WriteReport(vtkRelievoPass* pass, vtkFieldData* calibration, const RenderOptions& options,
  const Outputs& outputs)
{
  std::string report = pass->GetFrameReport();
  const std::string camera = WriteCalibration(calibration, options.Size);
  report.replace(report.rfind('}'), 1, ", \"camera\": " + camera + "}");
  std::ofstream file(outputs.Temporary(options.Report), std::ios::binary);
  file << report << '\n';
  file.close();
  if (!file)
  {
    throw WorkError(options.Report + ": cannot be written; is the disk full?");
  }
}

//------------------------------------------------------------------------------
std::string Certify(vtkRelievoPass* pass, const RenderOptions& options)
{
  const auto rays = static_cast<int>(options.Numbers.Get("--certify", 1.0));
  vtkRelievoShadowCertificate* certificate = pass->GetShadowStage()->Certify(rays);
  Messages::Check("--certify");
  return certificate->GetWords();
}

//------------------------------------------------------------------------------
// Tells a user why a requested stage has no visible effect in any band.
void NoteIdleStages(vtkRelievoPass* pass, const std::vector<StageChoice>& stages,
  const std::set<vtkRelievoStage*>& ran)
{
  for (const StageChoice& choice : stages)
  {
    const bool isAsked = choice.Option != "--preset" && !IsOfSwitch(choice);
    vtkRelievoStage* stage = isAsked ? pass->GetStage(choice.Name) : nullptr;
    if (stage && ran.count(stage) == 0)
    {
      const std::string asked =
        choice.Option + (choice.Option == StageChoice().Option ? " " + choice.Name : "");
      Messages::Note(asked + " changed nothing: " + stage->GetReason());
    }
  }
}

//------------------------------------------------------------------------------
// The output files, each with its option.
std::vector<std::pair<std::string, std::string>> GetPlaces(const RenderOptions& options)
{
  std::vector<std::pair<std::string, std::string>> places = { { "--png", options.PNG },
    { "--exr", options.EXR }, { "--baseline", options.Baseline }, { "--gltf", options.Gltf },
    { "--report", options.Report } };
  places.erase(std::remove_if(places.begin(), places.end(),
                 [](const auto& place) { return place.second.empty(); }),
    places.end());
  return places;
}

//------------------------------------------------------------------------------
// Copies the band's own rows into the picture, of which the first band makes the memory.
void AddBand(vtkImageData* drawn, const Bands::Band& band, const std::array<int, 2>& size,
  vtkSmartPointer<vtkImageData>& picture)
{
  if (!picture)
  {
    picture = vtkSmartPointer<vtkImageData>::New();
    picture->SetDimensions(size[0], size[1], 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, drawn->GetNumberOfScalarComponents());
  }
  const auto* from =
    static_cast<const unsigned char*>(drawn->GetScalarPointer(0, band.Lowest - band.Drawn, 0));
  auto* to = static_cast<unsigned char*>(picture->GetScalarPointer(0, band.Lowest, 0));
  std::copy_n(from,
    static_cast<std::size_t>(picture->GetNumberOfScalarComponents()) *
      static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(band.End - band.Lowest),
    to);
}

// Names the outputs in the work's errors.
template <typename Work>
void OnOutputs(const Outputs& outputs, Work work)
{
  try
  {
    work();
  }
  catch (const WorkError& error)
  {
    throw FileError(outputs.WithGivenNames(error.what()));
  }
}

//------------------------------------------------------------------------------
void WriteGltf(vtkRelievoGltfWriter* writer, const StyledScene& styled, int upAxis,
  const std::string& option, const std::string& given)
{
  writer->SetRenderer(styled.GetRenderer());
  writer->SetUpAxis(upAxis);
  for (const auto& [actor, name] : styled.GetObjectNames())
  {
    writer->SetObjectName(actor, name);
  }
  Messages::Check(given, !writer->Write(), "cannot be written");
  for (int i = 0; i < writer->GetNumberOfNotes(); ++i)
  {
    Messages::Note(option + ": " + writer->GetNote(i));
  }
}

//------------------------------------------------------------------------------
// Draws the scene and writes the complete outputs. Returns the picture, if one is wanted.
vtkSmartPointer<vtkImageData> DrawFrame(StyledScene& styled, vtkRelievoPass* pass,
  const std::vector<std::string>& layers, const RenderOptions& options, const Settings& settings,
  const Bands& bands, FlowOfFrames& flow, Outputs& outputs, Progress& progress,
  const std::string& what)
{
  const Scene& scene = styled.GetScene();
  vtkRenderer* renderer = scene.Renderer;
  vtkRenderWindow* window = renderer->GetRenderWindow();
  progress.Begin(what);
  vtkSmartPointer<vtkImageData> baseline;
  if (!options.Baseline.empty()) // first: notes and the report are of the frame after it
  {
    baseline = MakeBaseline(styled, options, settings, options.Has("--portable"));
  }
  if (!options.Report.empty())
  {
    pass->GetFrameReport(); // starts timing frames, whatever the OpenGL
  }
  for (int frame = 1; !options.Report.empty() && frame < FramesUntilTimed; ++frame)
  {
    window->Render();
    progress.Update(double(frame) / FramesUntilTimed);
  }
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  source->SetHDR(options.Has("--hdr"));
  for (const std::string& name : layers)
  {
    source->AddLayer(name);
  }
  const bool isInBands = bands.GetCount() > 1;
  vtkNew<vtkRelievoEXRWriter> writer; // of bands
  writer->SetFileName(options.EXR.empty() ? nullptr : outputs.Temporary(options.EXR).c_str());
  bool isEmpty = true;
  std::set<vtkRelievoStage*> ran;
  vtkSmartPointer<vtkImageData> seen;
  vtkSmartPointer<vtkImageData> picture;
  for (int number = 0; number < bands.GetCount(); ++number)
  {
    const Bands::Band band = bands.Get(number);
    std::optional<vtkRelievoRows> rows;
    if (isInBands)
    {
      rows.emplace(renderer, band.Drawn);
    }
    vtkSmartPointer<vtkImageData> drawn;
    if (!options.Lens.empty())
    {
      seen = DrawLens(renderer, options, layers, drawn, progress);
    }
    else if (!options.EXR.empty())
    {
      source->Update();
      // Uses the image and not the source's port, because a source of layers redraws on each
      // request.
      seen = source->GetOutput();
    }
    if (!options.EXR.empty())
    {
      flow.AddTo(seen, renderer, options);
    }
    if (options.Has("--transparent"))
    {
      const vtkSmartPointer<vtkImageData> overBlack = DrawOver(scene, 0.0);
      drawn = MakeTransparent(overBlack, DrawOver(scene, 1.0));
    }
    else if (options.Lens.empty())
    {
      const bool isDrawn =
        (baseline || !options.Gltf.empty()) && !options.WantsPicture() && options.Report.empty();
      // Unless it is drawn already, or by the writer of glTF.
      if ((options.EXR.empty() && !isDrawn) || (options.Has("--hdr") && options.WantsPicture()))
      {
        window->Render();
      }
      drawn = options.WantsPicture() ? Grab(renderer) : nullptr;
    }
    Messages::Check(what);
    isEmpty = isEmpty && !options.PNG.empty() && drawn && ShowsNothing(window, drawn, options);
    for (int i = 0; pass && i < pass->GetNumberOfStages(); ++i)
    {
      if (pass->GetStage(i)->GetReasonCode() == "ran")
      {
        ran.insert(pass->GetStage(i));
      }
    }
    rows.reset();
    if (!isInBands)
    {
      picture = drawn;
      continue;
    }
    if (drawn)
    {
      AddBand(drawn, band, options.Size, picture);
    }
    if (!options.EXR.empty())
    {
      vtkRelievoLayerSource::AddCamera(renderer, seen, pass); // of the picture, not of the band
      writer->WriteRows(seen, band.Lowest - band.Drawn, band.End - band.Lowest, options.Size[1]);
      OnOutputs(outputs, [&] {
        Messages::Check(
          options.EXR, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
      });
    }
    progress.Update((number + 1.0) / bands.GetCount());
    if (progress.IsStopped())
    {
      throw WorkError(what + ": stopped");
    }
  }
  if (options.Lens.empty()) // a lens's last view may show less than the picture
  {
    NoteIdleStages(pass, options.Stages, ran);
  }

  OnOutputs(outputs, [&] {
    if (!options.PNG.empty())
    {
      WritePNG(scene, picture, isEmpty, options, outputs, progress);
    }
    if (!options.EXR.empty() && !isInBands)
    {
      WriteEXR(seen, options.EXR, outputs, progress);
    }
    if (baseline)
    {
      WriteEXR(baseline, options.Baseline, outputs, progress);
    }
    if (!options.Report.empty())
    {
      WriteReport(pass,
        options.Lens.empty() ? GetCalibration(renderer, options.Size.data())
                             : vtkSmartPointer<vtkFieldData>(seen->GetFieldData()),
        options, outputs);
    }
    if (!options.Gltf.empty()) // last: it draws other frames
    {
      const vtkNew<vtkRelievoGltfWriter> gltf;
      gltf->SetFileName(outputs.Temporary(options.Gltf));
      WriteGltf(gltf, styled, options.UpAxis, "--gltf", options.Gltf);
    }
    for (const std::string& warning : Messages::TakeWarnings())
    {
      Messages::Warn(outputs.WithGivenNames(warning));
    }
  });
  return picture;
}

//------------------------------------------------------------------------------
// Whether all files of a frame exist.
bool IsThere(const RenderOptions& options)
{
  const auto places = GetPlaces(options);
  return std::all_of(places.begin(), places.end(), [](const auto& place) {
    std::error_code none;
    return std::filesystem::is_regular_file(place.second, none);
  });
}

// The picture of a frame that was drawn before.
vtkSmartPointer<vtkImageData> ReadPicture(
  const std::string& file, const std::array<int, 2>& expected, const char* remedy)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  Messages::Check(file, reader->GetErrorCode() != 0, "cannot be read");
  const int* size = reader->GetOutput()->GetDimensions();
  if (size[0] != expected[0] || size[1] != expected[1])
  {
    throw FileError(file + ": has " + std::to_string(size[0]) + "x" + std::to_string(size[1]) +
      " pixels, expected " + std::to_string(expected[0]) + "x" + std::to_string(expected[1]) +
      ": " + remedy);
  }
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
// One glTF file of all frames; nothing if none is requested.
class Animation
{
public:
  Animation(
    const StyledScene& styled, const RenderOptions& options, const std::vector<std::string>& inputs)
    : Styled(styled)
    , Options(options)
    , IsWanted(
        !options.Gltf.empty() && IsSequence(options) && GetFrameName(options.Gltf, 0).empty())
  {
    if (this->IsWanted)
    {
      this->File.Add("--gltf", options.Gltf, inputs);
      this->Writer->SetRenderer(styled.GetRenderer());
    }
  }

  void Add(double seconds)
  {
    if (this->IsWanted)
    {
      Messages::Check(this->Options.Gltf, !this->Writer->AddKey(seconds), "cannot be written");
    }
  }

  void Finish()
  {
    if (this->IsWanted)
    {
      this->Writer->SetFileName(this->File.Temporary(this->Options.Gltf));
      OnOutputs(this->File, [this] {
        WriteGltf(this->Writer, this->Styled, this->Options.UpAxis, "--gltf", this->Options.Gltf);
      });
      this->File.Commit();
    }
  }

private:
  const StyledScene& Styled;
  const RenderOptions& Options;
  bool IsWanted;
  vtkNew<vtkRelievoGltfWriter> Writer;
  Outputs File;
};

//------------------------------------------------------------------------------
// The film of a sequence; nothing if none is requested.
class Film
{
public:
  Film(const RenderOptions& options, const std::vector<std::string>& inputs)
  {
    if (!options.Motion.Video.empty())
    {
      const std::string& name = options.Motion.Video;
      this->Place.Add("--video", name, inputs);
      this->File.emplace(
        this->Place.Temporary(name), name, options.Size, options.Motion.FramesPerSecond);
    }
  }

  void Add(vtkImageData* picture)
  {
    if (this->File)
    {
      this->File->Add(picture);
    }
  }

  void Finish()
  {
    if (this->File)
    {
      this->File->Finish();
      this->Place.Commit();
    }
  }

private:
  Outputs Place;
  std::optional<VideoFile> File; // destroyed first
};
}

namespace
{
// Attaches the frame that draws the outputs, and afterwards restores the renderer.
class OutputFrame
{
public:
  OutputFrame(
    StyledScene& styled, const RenderOptions& options, const std::vector<std::string>& layers)
    : Renderer(styled.GetRenderer())
    , Pass(styled.GetFrame())
  {
    this->Own =
      !this->Pass && (!layers.empty() || !options.Report.empty() || options.Has("--certify"));
    if (this->Own)
    {
      this->Pass = vtkRelievoPass::Attach(this->Renderer);
      SetFrame(this->Pass, this->Renderer, options, styled.GetPoints());
    }
    if (this->Pass)
    {
      this->Waited = this->Pass->GetWaitForSamples();
      this->Pass->WaitForSamplesOn();
    }
    for (const std::string& name : layers)
    {
      if (name != vtkRelievoLayerCatalogue::GetPicture().Name) // the picture is drawn in any case
      {
        this->Pass->RequestLayer(name);
        this->Layers.push_back(name);
      }
    }
  }
  ~OutputFrame()
  {
    for (const std::string& name : this->Layers)
    {
      this->Pass->ReleaseLayer(name);
    }
    if (this->Pass)
    {
      this->Pass->SetWaitForSamples(this->Waited);
    }
    if (this->Own)
    {
      vtkRelievoPass::Detach(this->Renderer);
    }
  }
  OutputFrame(const OutputFrame&) = delete;
  void operator=(const OutputFrame&) = delete;

  vtkRelievoPass* Get() const { return this->Pass; }

private:
  vtkRenderer* Renderer;
  vtkRelievoPass* Pass;
  bool Own = false, Waited = false;
  std::vector<std::string> Layers;
};
}

//------------------------------------------------------------------------------
RenderOptions FollowProgram(RenderOptions options)
{
  if (options.Motion.Video.empty() || VideoFile::HasProgram())
  {
    return options;
  }
  const std::string film = std::exchange(options.Motion.Video, "");
  if (options.PNG.empty())
  {
    options.PNG = std::filesystem::path(film).replace_extension().string() + "_%04d.png";
    if (GetFrameName(options.PNG, 0).empty())
    {
      throw UsageError("--video " + film +
        ": the program ffmpeg is not installed, and the frames cannot be named " + options.PNG +
        ": give --png F with %d or %04d once");
    }
  }
  Messages::Note("--video " + film + ": the program ffmpeg is not installed: the frames are in " +
    GetFrameName(options.PNG, 0) + " and so on; where it is, `ffmpeg -framerate " +
    WriteNumber(options.Motion.FramesPerSecond) + " -i " + options.PNG + " " + film +
    "` makes the film");
  return options;
}

//------------------------------------------------------------------------------
std::unique_ptr<Outputs> OpenOutputs(
  const RenderOptions& options, const std::vector<std::string>& inputs, int frame)
{
  if (!options.Motion.Video.empty() && IsSequence(options)) // not for each frame
  {
    Outputs().Add("--video", options.Motion.Video, inputs); // checks the place
  }
  auto outputs = std::make_unique<Outputs>();
  for (const auto& [option, path] : GetPlaces(GetFrameOptions(options, frame)))
  {
    outputs->Add(option, path, inputs);
  }
  return outputs;
}

//------------------------------------------------------------------------------
void WriteFilm(const std::string& path, const std::vector<std::string>& pictures,
  const std::array<int, 2>& size, double framesPerSecond)
{
  Outputs place;
  place.Add("--video", path, pictures);
  VideoFile file(place.Temporary(path), path, size, framesPerSecond);
  for (const std::string& picture : pictures)
  {
    file.Add(ReadPicture(picture, size, "draw it again"));
  }
  file.Finish();
  place.Commit();
}

//------------------------------------------------------------------------------
std::string WriteOutputs(StyledScene& styled, const RenderOptions& options,
  const Settings& settings, const Bands& bands, const std::vector<std::string>& inputs,
  std::unique_ptr<Outputs> outputs, const FrameRange& range, Progress& progress)
{
  vtkRenderer* renderer = styled.GetRenderer();
  std::vector<std::string> layers = LayersToCapture(options, styled.GetScene());
  FlowOfFrames flow(options, layers);
  CheckShownLayer(options, styled.GetScene());
  const int lights = CountLights(renderer);
  CheckShadowLayers(options, lights, lights == 1 ? "light" : "lights");
  const FrameList list(styled.GetScene(), options);
  const int frames = list.GetCount();
  for (int number = 0; number < std::max(1, frames); ++number)
  {
    for (const auto& [option, path] : GetPlaces(GetFrameOptions(options, number)))
    {
      Outputs::Check(option, path, inputs);
    }
  }
  const std::string size = std::to_string(options.Size[0]) + "x" + std::to_string(options.Size[1]);
  progress.Begin("rendering " + size);
  const OutputFrame frame(
    styled, options, options.Lens.empty() ? layers : std::vector<std::string>());
  vtkRelievoPass* pass = frame.Get();
  if (frames == 0)
  {
    DrawFrame(styled, pass, layers, options, settings, bands, flow, *outputs, progress,
      "rendering " + size);
  }
  const std::string certificate = options.Has("--certify") ? Certify(pass, options) : "";
  if (frames == 0)
  {
    outputs->Commit();
  }
  Film film(options, inputs);
  Animation animation(styled, options, inputs);
  int kept = 0;
  for (int number = range.First; number < std::min(frames, range.End); ++number)
  {
    const RenderOptions own = list.Get(options, number);
    if (options.Motion.Resume && IsThere(own))
    {
      ++kept;
      film.Add(options.Motion.Video.empty()
          ? nullptr
          : ReadPicture(own.PNG, own.Size, "remove it, or leave out --resume").Get());
      continue;
    }
    if (number > range.First)
    {
      outputs = OpenOutputs(own, inputs, number);
    }
    if (number > 0 && own.Model.Time)
    {
      PlayScene(styled.GetScene(), options, *own.Model.Time, progress);
    }
    if (options.Motion.MovesCamera())
    {
      PlaceCamera(renderer, own.View, options.UpAxis, styled.GetBounds());
    }
    film.Add(DrawFrame(styled, pass, layers, own, settings, bands, flow, *outputs, progress,
      "rendering " + size + ", frame " + std::to_string(number + 1) + " of " +
        std::to_string(frames)));
    outputs->Commit();
    range.OnWritten(number);
    animation.Add(own.Model.Time.value_or(number / options.Motion.FramesPerSecond));
  }
  film.Finish();
  animation.Finish();
  if (kept > 0)
  {
    Messages::Note("--resume: " + std::to_string(kept) + " of " + std::to_string(frames) +
      " frames were there and are kept");
  }
  return certificate;
}

//------------------------------------------------------------------------------
void WriteGltf(const StyledScene& styled, const std::string& path)
{
  Outputs outputs;
  outputs.Add("glTF", path, GetInputs(styled.GetOptions()));
  const vtkNew<vtkRelievoGltfWriter> writer;
  writer->SetFileName(outputs.Temporary(path));
  OnOutputs(outputs, [&] { WriteGltf(writer, styled, styled.GetOptions().UpAxis, "glTF", path); });
  outputs.Commit();
}
}
