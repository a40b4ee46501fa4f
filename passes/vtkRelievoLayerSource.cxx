// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerSource.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRelievoDisplay.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayersStage.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoToneStage.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkRelievoLayerSource);

namespace
{
void AddDoubles(vtkImageData* image, const char* name, const double* values, int count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  std::copy(values, values + count, array->GetPointer(0));
  image->GetFieldData()->AddArray(array);
}

void WriteVector(std::ostream& out, const char* name, const double v[3])
{
  out << ", \"" << name << "\": [" << v[0] << ", " << v[1] << ", " << v[2] << "]";
}

std::string Escape(const std::string& text)
{
  std::string out;
  for (const char c : text)
  {
    out += c == '"' || c == '\\' ? "\\" : "";
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

// Whether the window has a wrong alpha of translucent surfaces. The linear colour has it right, but
// not with FXAA.
bool LosesAlpha(vtkRenderer* renderer)
{
#ifdef RELIEVO_VTK_AVERAGED_TRANSMITTANCE
  auto* pass = vtkRelievoPass::SafeDownCast(renderer->GetPass());
  vtkRelievoStage* blend = pass ? pass->GetStage("blend") : nullptr;
  const bool averaged = renderer->GetRenderWindow()->GetAlphaBitPlanes() != 0 &&
    !renderer->GetUseDepthPeeling() && !(blend && blend->GetReasonCode() == "ran");
  vtkCollectionSimpleIterator it;
  renderer->GetViewProps()->InitTraversal(it);
  for (vtkProp* prop = nullptr; averaged && (prop = renderer->GetViewProps()->GetNextProp(it));)
  {
    if (prop->GetVisibility() && prop->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
#else
  static_cast<void>(renderer);
  return false;
#endif
}

// With its name and the layer that has its visibility, where a frame knows them.
std::string DescribeLight(vtkRenderer* renderer, vtkLight* light, vtkRelievoPass* pass)
{
  std::ostringstream out;
  out.precision(17);
  const char* type = !light->GetPositional() ? "sun"
    : light->GetConeAngle() < 90.0           ? "spot"
                                             : "point";
  const char* frame = light->LightTypeIsHeadlight() ? "headlight"
    : light->LightTypeIsCameraLight()               ? "camera"
                                                    : "scene";
  out << "{";
  if (vtkRelievoShadowStage* shadows = pass ? pass->GetShadowStage() : nullptr)
  {
    out << "\"name\": \"" << Escape(shadows->GetLightName(renderer, light)) << "\", \"layer\": \""
        << shadows->GetLightLayer(renderer, light) << "\", ";
  }
  out << "\"type\": \"" << type << "\", \"frame\": \"" << frame << "\"";
  WriteVector(out, "position", light->GetTransformedPosition());
  WriteVector(out, "focal_point", light->GetTransformedFocalPoint());
  WriteVector(out, "color", light->GetDiffuseColor());
  out << ", \"intensity\": " << light->GetIntensity()
      << ", \"cone_angle\": " << light->GetConeAngle() << "}";
  return out.str();
}

void CopyInto(vtkDataArray* to, vtkIdType first, vtkDataArray* from)
{
  const int components = from->GetNumberOfComponents();
  if (to->GetDataType() == from->GetDataType() && to->GetNumberOfComponents() == components)
  {
    const std::size_t size = static_cast<std::size_t>(components) * from->GetDataTypeSize();
    std::memcpy(static_cast<char*>(to->GetVoidPointer(0)) + static_cast<std::size_t>(first) * size,
      from->GetVoidPointer(0), static_cast<std::size_t>(from->GetNumberOfTuples()) * size);
    return;
  }
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < to->GetNumberOfComponents(); ++c)
    {
      to->SetComponent(first + i, c, c < components ? from->GetComponent(i, c) : vtkMath::Nan());
    }
  }
}

// Puts a view's layer among those of all views. Type and components of a data array depend on the
// meshes that a view shows: the array of all views has room for each, and NaN in other components.
void PutView(
  vtkDataSetAttributes* all, vtkDataArray* layer, vtkIdType view, vtkIdType numberOfViews)
{
  vtkSmartPointer<vtkDataArray> array = all->GetArray(layer->GetName());
  const vtkSmartPointer<vtkDataArray> before = array;
  const bool sameType = !before || before->GetDataType() == layer->GetDataType();
  const int components =
    std::max(before ? before->GetNumberOfComponents() : 0, layer->GetNumberOfComponents());
  const int type = sameType ? layer->GetDataType() : VTK_DOUBLE;
  if (!before || before->GetDataType() != type || before->GetNumberOfComponents() != components)
  {
    array.TakeReference(vtkDataArray::CreateDataArray(type));
    array->SetName(layer->GetName());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(layer->GetNumberOfTuples() * numberOfViews);
    if (before)
    {
      CopyInto(array, 0, before);
    }
    all->AddArray(array);
  }
  CopyInto(array, view * layer->GetNumberOfTuples(), layer);
}

// Pixels that a window's framebuffers may have each way.
int GetSizeLimit(vtkRenderWindow* any)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(any);
  if (!window)
  {
    return std::numeric_limits<int>::max();
  }
  if (window->GetNeverRendered())
  {
    // Only a context can tell, and making one at an impossible size may end the program.
    const int size[2] = { window->GetActualSize()[0], window->GetActualSize()[1] };
    window->SetSize(std::min(size[0], 1024), std::min(size[1], 1024));
    window->Initialize();
    window->SetSize(size[0], size[1]);
  }
  window->MakeCurrent(); // another window may have drawn since
  return vtkTextureObject::GetMaximumTextureSize(window);
}
}

//------------------------------------------------------------------------------
vtkRelievoLayerSource::vtkRelievoLayerSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoLayerSource::~vtkRelievoLayerSource() = default;

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoLayerSource::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::AddLayer(RELIEVO_TEXT name)
{
  this->Layers.push_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::RemoveAllLayers()
{
  this->Layers.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayerSource::GetLayer(int i)
{
  return i >= 0 && i < this->GetNumberOfLayers() ? this->Layers[i] : std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::AddView(vtkCamera* camera)
{
  if (!camera)
  {
    vtkErrorMacro("AddView was given no camera.");
    return;
  }
  this->Views.emplace_back(camera);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::RemoveAllViews()
{
  this->Views.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoLayerSource::GetMTime()
{
  this->MTime.Modified();
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
int vtkRelievoLayerSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  int size[2] = { 0, 0 };
  if (this->Renderer && this->Renderer->GetRenderWindow())
  {
    this->Renderer->GetTiledSize(&size[0], &size[1]);
  }
  const int slices = std::max(1, this->GetNumberOfViews());
  const int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, slices - 1 };
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoLayerSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(outputs);
  image->Initialize();
  const bool good = this->Attached(
    [&]() { return this->Views.empty() ? this->Capture(image) : this->PutViews(image); });
  if (!good)
  {
    image->Initialize();
  }
  return good ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerSource::CaptureEach(const std::function<void(std::size_t, vtkImageData*)>& take)
{
  return this->Attached([&]() {
    if (this->Views.empty())
    {
      vtkNew<vtkImageData> layers;
      const bool good = this->Capture(layers);
      if (good)
      {
        take(0, layers);
      }
      return good;
    }
    return this->DrawEach([&take](std::size_t view, vtkImageData* layers) {
      take(view, layers);
      return true;
    });
  });
}

//------------------------------------------------------------------------------
// Calls `capture` while the renderer has a pass, if layers can be drawn.
bool vtkRelievoLayerSource::Attached(const std::function<bool()>& capture)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkRenderWindow* window = this->Renderer ? this->Renderer->GetRenderWindow() : nullptr;
  if (!window)
  {
    vtkErrorMacro("Layers are asked of " << (this->Renderer ? "a renderer without a window; add it "
                                                              "to a vtkRenderWindow."
                                                            : "no renderer; use SetRenderer."));
    return false;
  }
  const std::string noDisplay = vtkRelievoDisplay::Check(window);
  if (!noDisplay.empty())
  {
    vtkErrorMacro(<< noDisplay << ".");
    return false;
  }
  const std::string lights = vtkRelievoPass::CheckLights(this->Renderer);
  if (!lights.empty())
  {
    vtkErrorMacro("Nothing is drawn: " << lights << " Make them lamps (vtkRelievoLamps).");
    return false;
  }
  if (!this->Renderer->GetDraw())
  {
    vtkErrorMacro("The renderer is told to draw nothing; switch it on with DrawOn().");
    return false;
  }
  if (this->Layers.empty())
  {
    vtkErrorMacro("No layers are asked for; use AddLayer(\"depth\"), for example.");
    return false;
  }
  const bool attached = vtkRelievoPass::SafeDownCast(this->Renderer->GetPass()) != nullptr;
  vtkRelievoPass::Attach(this->Renderer);
  const bool good = capture();
  if (!attached)
  {
    vtkRelievoPass::Detach(this->Renderer);
  }
  return good;
}

//------------------------------------------------------------------------------
// Whether the last frame made the layers of surfaces and nothing else.
bool vtkRelievoLayerSource::IsAloneInFrame(vtkRelievoPass* pass)
{
  for (int i = 0; i < pass->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = pass->GetStage(i);
    if (stage != pass->GetLayersStage() && stage->GetReasonCode() == "ran")
    {
      return false;
    }
  }
  const auto observes = [](vtkObject* object) {
    return object->HasObserver(vtkCommand::StartEvent) || object->HasObserver(vtkCommand::EndEvent);
  };
  return pass->GetLayersStage() && !pass->GetController() && !observes(this->Renderer) &&
    !observes(this->Renderer->GetRenderWindow());
}

//------------------------------------------------------------------------------
// The views become slices of one image.
bool vtkRelievoLayerSource::PutViews(vtkImageData* image)
{
  return this->DrawEach([&](std::size_t view, vtkImageData* layers) {
    const int* size = layers->GetDimensions();
    image->SetDimensions(size[0], size[1], this->GetNumberOfViews());
    const double bytes = 1024.0 * static_cast<double>(layers->GetActualMemorySize());
    const std::string lack =
      view == 0 ? relievo::LackOfMemory(bytes * this->GetNumberOfViews(), 0.0) : "";
    if (!lack.empty())
    {
      vtkErrorMacro("The layers of " << this->GetNumberOfViews() << " views are too many: " << lack
                                     << ". Capture fewer views at a time, or a smaller window.");
      return false;
    }
    for (const std::string& name : this->Layers)
    {
      PutView(image->GetPointData(), layers->GetPointData()->GetArray(name.c_str()),
        static_cast<vtkIdType>(view), this->GetNumberOfViews());
    }
    return true;
  });
}

//------------------------------------------------------------------------------
// The first view tells whether the others can be drawn together. `take` returns false to end this.
bool vtkRelievoLayerSource::DrawEach(const std::function<bool(std::size_t, vtkImageData*)>& take)
{
  const bool hadCamera = this->Renderer->IsActiveCameraCreated() != 0;
  const vtkSmartPointer<vtkCamera> before = hadCamera ? this->Renderer->GetActiveCamera() : nullptr;
  auto* pass = vtkRelievoPass::SafeDownCast(this->Renderer->GetPass());
  bool good = true;
  bool together = false;
  for (std::size_t i = 0; i < this->Views.size() && good && !together; ++i)
  {
    this->Renderer->SetActiveCamera(this->Views[i]);
    vtkNew<vtkImageData> layers;
    good = this->Capture(layers) && take(i, layers);
    if (i == 0 && this->Views.size() > 1 && good && this->IsAloneInFrame(pass))
    {
      const std::vector<vtkCamera*> others(this->Views.begin() + 1, this->Views.end());
      together = pass->GetLayersStage()->DrawViews(this->Renderer, others, this->Layers,
        [&](std::size_t view, vtkImageData* found) { good = take(view + 1, found) && good; });
    }
  }
  this->Renderer->SetActiveCamera(before);
  return good;
}

//------------------------------------------------------------------------------
// The layers of the renderer's camera.
bool vtkRelievoLayerSource::Capture(vtkImageData* image)
{
  auto* pass = vtkRelievoPass::SafeDownCast(this->Renderer->GetPass());
  std::vector<std::string> added;
  const bool waits = pass->GetWaitForSamples();
  bool color = false;
  vtkRelievoToneStage* tone = pass->GetToneStage();
  const bool toned = tone && tone->GetChangesPicture();
  for (const std::string& layer : this->Layers)
  {
    const bool picture = layer == vtkRelievoLayerCatalogue::GetPicture().Name && !this->HDR;
    color = color || picture;
    if ((!picture || toned) && !pass->IsLayerRequested(layer))
    {
      pass->RequestLayer(layer);
      added.push_back(layer);
    }
  }

  pass->WaitForSamplesOn();
  const bool drawn = this->Draw(pass, color);
  pass->SetWaitForSamples(waits);
  color = color && !(toned && tone->GetReasonCode() == "ran"); // the colour before it
  std::vector<std::string> read = this->Layers;
  if (color)
  {
    read.erase(std::remove(read.begin(), read.end(), vtkRelievoLayerCatalogue::GetPicture().Name),
      read.end());
  }
  bool good = drawn && pass->ReadLayers(read, image);
  if (drawn && !good)
  {
    this->SetErrorCode(NO_SUCH_LAYER);
  }
  if (good && color)
  {
    vtkRelievoLayerSource::AddColor(this->Renderer, image);
  }
  const std::string& picture = vtkRelievoLayerCatalogue::GetPicture().Name;
  if (good && image->GetPointData()->HasArray(picture.c_str()) &&
    (color || this->Renderer->GetUseFXAA()))
  {
    good = vtkRelievoLayerSource::AmendAlpha(this->Renderer, image);
  }
  // In the order in which they were asked for.
  for (std::size_t i = 0; i < this->Layers.size() && good; ++i)
  {
    const char* name = this->Layers[i].c_str();
    vtkSmartPointer<vtkDataArray> array = image->GetPointData()->GetArray(name);
    image->GetPointData()->RemoveArray(name);
    image->GetPointData()->AddArray(array);
  }
  if (good)
  {
    vtkRelievoLayerSource::AddCamera(this->Renderer, image, pass);
  }
  for (const std::string& layer : added)
  {
    pass->ReleaseLayer(layer);
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerSource::Draw(vtkRelievoPass* pass, bool color)
{
  vtkRenderWindow* window = this->Renderer->GetRenderWindow();
  int size[2];
  this->Renderer->GetTiledSize(&size[0], &size[1]);
  const int* all = window->GetActualSize(); // of a tile
  if (all[0] <= 0 || all[1] <= 0 || size[0] <= 0 || size[1] <= 0)
  {
    vtkErrorMacro("The renderer's viewport has " << size[0] << " x " << size[1]
                                                 << " pixels; give the window a size.");
    return false;
  }
  const int limit = GetSizeLimit(window);
  if (all[0] > limit || all[1] > limit)
  {
    vtkErrorMacro("The window has "
      << all[0] << " x " << all[1] << " pixels, this OpenGL makes at most " << limit << " x "
      << limit << ": make the window smaller, or capture it in tiles.");
    return false;
  }
  if (color)
  {
    window->Render();
    return true;
  }
  const bool layersOnly = pass->GetLayersOnly();
  pass->SetLayersOnly(true);
  // The renderer alone, into the G-buffer's own framebuffer: nothing of the window is drawn.
  window->Start();
  if (!this->Renderer->IsActiveCameraCreated())
  {
    this->Renderer->GetActiveCamera(); // made here: resetting makes none if nothing is visible
    this->Renderer->ResetCamera();     // as windows do in their first frame
  }
  this->Renderer->Render();
  window->End();
  pass->SetLayersOnly(layersOnly);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::AddColor(vtkRenderer* renderer, vtkImageData* image)
{
  if (!renderer || !renderer->GetRenderWindow() || !image)
  {
    vtkGenericWarningMacro(
      "AddColor was given " << (image ? "no renderer in a window; give it one that was drawn."
                                      : "no image; give it a vtkImageData to add to."));
    return;
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  vtkNew<vtkUnsignedCharArray> bytes;
  vtkRenderWindow* window = renderer->GetRenderWindow();
  window->GetRGBACharPixelData(origin[0], origin[1], origin[0] + size[0] - 1,
    origin[1] + size[1] - 1, window->GetDoubleBuffer() ? 0 : 1, bytes);
  const bool hasAlpha = window->GetAlphaBitPlanes() != 0;
  if (image->GetNumberOfPoints() == 0)
  {
    image->SetDimensions(size[0], size[1], 1);
  }
  vtkNew<vtkFloatArray> color;
  color->SetName(vtkRelievoLayerCatalogue::GetPicture().Name.c_str());
  color->SetNumberOfComponents(4);
  color->SetNumberOfTuples(image->GetNumberOfPoints());
  float* out = color->GetPointer(0);
  // VTK's colours are meant for display; premultiplied they are already, over the background.
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      out[4 * i + c] =
        static_cast<float>(relievo::f64::relievoLinearFromSrgb(bytes->GetValue(4 * i + c) / 255.0));
    }
    out[4 * i + 3] = hasAlpha ? static_cast<float>(bytes->GetValue(4 * i + 3)) / 255.0f : 1.0f;
  }
  image->GetPointData()->AddArray(color);
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerSource::AmendAlpha(vtkRenderer* renderer, vtkImageData* image)
{
  const char* name = vtkRelievoLayerCatalogue::GetPicture().Name.c_str();
  vtkDataArray* color = image ? image->GetPointData()->GetArray(name) : nullptr;
  if (!renderer || !renderer->GetRenderWindow() || !color)
  {
    vtkGenericWarningMacro(
      "AmendAlpha was given " << (color ? "no renderer in a window; give it one that was drawn."
                                        : "no image with the layer 'color'; use AddColor."));
    return false;
  }
  if (!LosesAlpha(renderer))
  {
    return true;
  }
  const bool smooth = renderer->GetUseFXAA();
  renderer->SetUseFXAA(false);
  vtkNew<vtkRelievoLayerSource> linear;
  linear->SetRenderer(renderer);
  linear->HDROn();
  linear->AddLayer(name);
  linear->Update();
  renderer->SetUseFXAA(smooth);
  vtkDataArray* right = linear->GetOutput()->GetPointData()->GetArray(name);
  if (!right || right->GetNumberOfTuples() != color->GetNumberOfTuples())
  {
    vtkGenericWarningMacro("The alpha of the layer 'color' is that of VTK: the renderer cannot be "
                           "drawn once more.");
    return false;
  }
  for (vtkIdType i = 0; i < color->GetNumberOfTuples(); ++i)
  {
    // That of VTK is too small, except where a text is.
    const double alpha = std::max(color->GetComponent(i, 3), right->GetComponent(i, 3));
    color->SetComponent(i, 3, alpha);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::AddCamera(
  vtkRenderer* renderer, vtkImageData* image, vtkRelievoPass* frame)
{
  if (!renderer || !image)
  {
    vtkGenericWarningMacro(
      "AddCamera was given " << (image ? "no renderer; give it the one that drew the image."
                                       : "no image; give it a vtkImageData to add to."));
    return;
  }
  vtkRelievoFrameCamera view;
  view.Take(renderer, nullptr);
  double rows[16];
  auto addMatrix = [&](const char* name, const glm::dmat4& matrix) {
    for (int i = 0; i < 16; ++i)
    {
      rows[i] = matrix[i % 4][i / 4];
    }
    AddDoubles(image, name, rows, 16);
  };
  addMatrix("worldToCamera", view.WorldToView);
  addMatrix("worldToNDC", view.ViewToNDC * view.WorldToView);
  AddDoubles(image, "near", &view.Near, 1);
  AddDoubles(image, "far", &view.Far, 1);
  vtkNew<vtkRelievoLensCamera> lens;
  if (vtkRelievoLensCamera::IsPinhole(renderer->GetActiveCamera()) &&
    lens->TakeFrom(renderer->GetActiveCamera(), view.Viewport[2], view.Viewport[3]))
  {
    double intrinsics[9];
    lens->GetIntrinsics(intrinsics);
    AddDoubles(image, "K", intrinsics, 9);
    AddDoubles(image, "R", lens->GetRotation(), 9);
    AddDoubles(image, "t", lens->GetTranslation(), 3);
  }
  double origin[3];
  renderer->GetActiveCamera()->GetFocalPoint(origin);
  for (double& value : origin)
  {
    // Volatile: GCC 12 leaves the rounding out where two doubles go to float and back side by side.
    const volatile float rounded = static_cast<float>(value);
    value = rounded;
  }
  AddDoubles(image, "relievo:origin", origin, 3);

  vtkNew<vtkStringArray> lights;
  lights->SetName("lights");
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch())
    {
      lights->InsertNextValue(DescribeLight(renderer, light, frame));
    }
  }
  image->GetFieldData()->AddArray(lights);
}

//------------------------------------------------------------------------------
void vtkRelievoLayerSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.GetPointer() << "\n";
  os << indent << "HDR: " << this->HDR << "\n";
  os << indent << "Layers:";
  for (const std::string& layer : this->Layers)
  {
    os << " " << layer;
  }
  os << "\n";
  os << indent << "Views: " << this->Views.size() << "\n";
}
