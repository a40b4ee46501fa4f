// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBaseline.h"

#include "Baseline.h"
#include "BaselineRecord.h"
#include "Lens.h"

#include "vtkActorCollection.h"
#include "vtkCallbackCommand.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoComparisonReport.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoFrameComparison.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoStageDescription.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoBaseline);

namespace
{
// Text for an element of XML.
std::string Escape(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  }
  return escaped;
}

// Layers of stages that identify causes.
const std::set<std::string> StageLayers = { "light", "fog", "ambient", "marker", "blend" };

const std::vector<std::string> VolumeLayers = { "volume", "volume_depth", "volume_opacity" };

// The layers of the stages that ran.
std::vector<std::string> FindStageLayers(vtkRelievoPass* pass)
{
  std::vector<std::string> layers;
  for (int i = 0; i < pass->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = pass->GetStage(i);
    for (const std::string& layer : stage->GetDescription().Layers)
    {
      if (stage->GetReasonCode() == "ran" && StageLayers.count(layer) != 0)
      {
        layers.push_back(layer);
      }
    }
  }
  return layers;
}
}

//------------------------------------------------------------------------------
vtkRelievoBaseline::vtkRelievoBaseline() = default;

//------------------------------------------------------------------------------
vtkRelievoBaseline::~vtkRelievoBaseline() = default;

//------------------------------------------------------------------------------
void vtkRelievoBaseline::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoBaseline::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkRelievoBaseline::SetObjectName(int actor, RELIEVO_TEXT name)
{
  this->Names[actor] = name;
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoBaseline::GetObjectName(int actor)
{
  const auto found = this->Names.find(actor);
  return found == this->Names.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::Capture(vtkImageData* image)
{
  if (!image)
  {
    vtkErrorMacro("Capture was given no image; give it a vtkImageData to fill.");
    return false;
  }
  image->Initialize();
  vtkNew<vtkRelievoLayerSource> source; // reports errors
  source->SetRenderer(this->Renderer);
  std::vector<std::string> layers = { vtkRelievoLayerCatalogue::GetPicture().Name, "albedo" };
  std::vector<std::string> traced;
  std::vector<std::string>& geometry = this->Portable ? traced : layers;
  geometry.insert(geometry.end(), { "depth", "normal", "actor", "block", "cell" });
  auto* pass = vtkRelievoPass::SafeDownCast(this->Renderer ? this->Renderer->GetPass() : nullptr);
  if (pass && pass->GetShadows() && pass->GetShadowStage())
  {
    const std::vector<std::string> shadows =
      pass->GetShadowStage()->GetShadowLayers(this->Renderer);
    layers.insert(layers.end(), shadows.begin(), shadows.end());
  }
  if (this->Renderer)
  {
    const std::set<std::string> arrays = scene::FindColoringArrays(this->Renderer);
    geometry.insert(geometry.end(), arrays.begin(), arrays.end());
  }
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer);
  }
  // Layers of stages are drawn with the picture: drawn later, they could differ by rounding.
  std::vector<std::string> earlier; // of the caller
  if (pass)
  {
    earlier = pass->GetOptionalLayers();
    pass->SetOptionalLayers({ StageLayers.begin(), StageLayers.end() });
  }
  std::vector<std::string> ofVolumes; // requested here
  const bool hasVolumes = pass && scene::HasVolumeLayers(this->Renderer);
  for (const std::string& layer : VolumeLayers)
  {
    if (hasVolumes && !pass->IsLayerRequested(layer))
    {
      pass->RequestLayer(layer);
      ofVolumes.push_back(layer);
    }
  }
  const bool amends = pass && pass->GetAmends();
  if (pass)
  {
    pass->SetAmends(false); // the surfaces' own depth is compared; volumes have layers of their own
  }
  source->Update();
  if (pass)
  {
    pass->SetAmends(amends);
  }
  bool isDrawn = source->GetOutput()->GetNumberOfPoints() > 0;
  if (pass)
  {
    isDrawn = isDrawn && pass->ReadLayers(FindStageLayers(pass), source->GetOutput());
    pass->SetOptionalLayers(earlier);
  }
  if (isDrawn && hasVolumes)
  {
    // Failures, as for data drawn in bricks, are passed over: the record has the volumes' boxes.
    pass->TryReadLayers(VolumeLayers, source->GetOutput());
  }
  for (const std::string& layer : ofVolumes)
  {
    pass->ReleaseLayer(layer);
  }
  if (!isDrawn)
  {
    return false;
  }
  image->ShallowCopy(source->GetOutput());
  if (this->Portable && !this->AddRayLayers(image, traced))
  {
    image->Initialize();
    return false;
  }
  scene::AddRecord(image, this->Renderer, this->Names);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::AddRayLayers(vtkImageData* image, const std::vector<std::string>& layers)
{
  vtkNew<vtkRelievoRayScene> rays;
  rays->SetRenderer(this->Renderer);
  rays->OpaqueOnlyOn();                    // like the layers of a frame
  const vtkNew<vtkCallbackCommand> silent; // actors that rays do not hit are an error below
  rays->AddObserver(vtkCommand::WarningEvent, silent);
  rays->Update();
  for (int i = 0; i < rays->GetNumberOfPropsLeftOut(); ++i)
  {
    vtkProp* prop = rays->GetPropLeftOut(i);
    if (!vtkVolume::SafeDownCast(prop)) // volumes are in no layer
    {
      const int number = this->Renderer->GetActors()->IsItemPresent(prop) - 1;
      vtkErrorMacro("A portable baseline has actors that rays hit, but they do not hit "
        << (number < 0 ? std::string(prop->GetClassName()) : "actor " + std::to_string(number))
        << "; expected surfaces, not wireframes, points, lines or cut-outs. Use a "
        << "baseline that is not portable.");
      return false;
    }
  }
  const int* size = image->GetDimensions();
  const vtkSmartPointer<vtkRelievoCameraModel> sensor =
    scene::MakeSensor(this->Renderer->GetActiveCamera(), size[0], size[1]);
  vtkNew<vtkRelievoRayLayers> source; // reports errors
  source->SetScene(rays);
  source->SetCamera(sensor);
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer.c_str());
  }
  source->Update();
  if (source->GetOutput()->GetNumberOfPoints() != image->GetNumberOfPoints())
  {
    return false;
  }
  for (const std::string& layer : layers)
  {
    image->GetPointData()->AddArray(source->GetOutput()->GetPointData()->GetArray(layer.c_str()));
  }
  vtkNew<vtkIntArray> portable;
  portable->SetName("portable");
  portable->InsertNextValue(1);
  image->GetFieldData()->AddArray(portable);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::IsPortable(vtkImageData* image)
{
  auto* portable = image ? image->GetFieldData()->GetArray("portable") : nullptr;
  return portable && portable->GetNumberOfValues() == 1 && portable->GetComponent(0, 0) == 1.0;
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::Test(vtkRenderWindow* window, const char* baseline)
{
  namespace fs = std::filesystem;
  vtkNew<vtkRelievoBaseline> source;
  int drawn = 0;
  vtkNew<vtkRendererCollection> none;
  vtkRendererCollection* renderers = window ? window->GetRenderers() : none.Get();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(at))
  {
    if (renderer->GetDraw() && renderer->GetViewProps()->GetNumberOfItems() > 0)
    {
      source->SetRenderer(renderer);
      ++drawn;
    }
  }
  if (drawn != 1 || !baseline)
  {
    vtkErrorWithObjectMacro(source,
      "Test was given " << drawn << " renderers with props" << (baseline ? "" : " and no file")
                        << ", expected a window with one, and a baseline's file. For more "
                           "renderers, Capture() each.");
    return false;
  }
  const std::string stem = fs::path(baseline).stem().string();
  const std::string frameFile = stem + ".frame.exr";
  const std::array<std::string, 2> pictures = { stem + ".baseline.png", stem + ".frame.png" };
  const std::string page = stem + ".html";
  std::error_code ignored; // files of an earlier run may be missing
  for (const std::string& old : { frameFile, pictures[0], pictures[1], page })
  {
    fs::remove(old, ignored);
  }
  vtkNew<vtkRelievoFrameComparison> comparison; // reports errors
  const bool there = fs::exists(baseline, ignored);
  if (there && !comparison->ReadBaseline(baseline))
  {
    return false;
  }
  source->SetPortable(IsPortable(comparison->GetBaseline()));
  vtkNew<vtkImageData> frame;
  if (!source->Capture(frame))
  {
    return false;
  }
  const auto writePicture = [](vtkImageData* of, const std::string& path) {
    const auto picture = scene::MakePicture(of);
    if (picture)
    {
      vtkNew<vtkPNGWriter> writer; // reports errors
      writer->SetInputData(picture);
      writer->SetFileName(path.c_str());
      writer->Write();
    }
    return picture != nullptr;
  };
  const auto keepFrame = [&]() {
    vtkNew<vtkRelievoEXRWriter> writer; // reports errors
    writer->SetInputData(frame);
    writer->SetFileName(frameFile.c_str());
    writer->Write();
    const bool isPicture = fs::path(baseline).extension() == ".png";
    if (isPicture)
    {
      writePicture(frame, pictures[1]);
    }
    std::cout << "If the frame is right, copy " << (isPicture ? pictures[1] : frameFile) << " to "
              << baseline << std::endl;
  };
  if (!there)
  {
    std::cout << "There is no such baseline: " << baseline << "\n";
    keepFrame();
    return false;
  }
  comparison->SetFrame(frame);
  if (!comparison->Compare())
  {
    return false;
  }
  const std::string table = comparison->GetText();
  std::cout << table << std::flush;
  if (comparison->GetAlike())
  {
    return true;
  }
  keepFrame();
  vtkNew<vtkRelievoComparisonReport> report;
  report->Add(baseline, comparison);
  std::ofstream(page, std::ios::binary) << report->GetHTML();
  std::cout << "<DartMeasurement name=\"Causes\" type=\"text/preformatted\">" << Escape(table)
            << "</DartMeasurement>\n";
  // CDash shows pictures with these names together, one over the other.
  const std::array<const char*, 2> names = { "ValidImage", "TestImage" };
  for (std::size_t i = 0; i < 2; ++i)
  {
    if (writePicture(i == 0 ? comparison->GetBaseline() : comparison->GetFrame(), pictures[i]))
    {
      std::cout << "<DartMeasurementFile name=\"" << names[i] << "\" type=\"image/png\">"
                << Escape(fs::absolute(pictures[i], ignored).string())
                << "</DartMeasurementFile>\n";
    }
  }
  std::cout << std::flush;
  return false;
}

//------------------------------------------------------------------------------
void vtkRelievoBaseline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "Portable: " << this->Portable << "\n";
  for (const auto& [actor, name] : this->Names)
  {
    os << indent << "ObjectName " << actor << ": " << name << "\n";
  }
}
