// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLensPicture.h"

#include "vtkCamera.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoLensViews.h"
#include "vtkRelievoOrthographicCamera.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoToneStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoLensPicture);

namespace
{
constexpr const char* Color = "color";
constexpr const char* Shown = "picture";
constexpr vtkIdType Grain = 4096;

// The place of a pose, and a camera there that is turned as it is.
void SetPose(vtkRelievoCameraModel* sensor, vtkCamera* camera)
{
  const double* R = sensor->GetRotation();
  const double* t = sensor->GetTranslation();
  const double distance = camera->GetDistance();
  double eye[3];
  double focus[3];
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = -(R[i] * t[0] + R[3 + i] * t[1] + R[6 + i] * t[2]);
    focus[i] = eye[i] + distance * R[6 + i];
  }
  camera->SetPosition(eye);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(-R[3], -R[4], -R[5]);
}

// What drawing for a sensor changes of a renderer and its window, as it was. Lights that follow the
// camera stay where they are for the sensor's pose: six views must be lit alike.
class KeptRenderer
{
public:
  KeptRenderer(vtkRenderer* renderer, vtkRelievoCameraModel* sensor)
    : Renderer(renderer)
    , Window(renderer->GetRenderWindow())
    , Attached(vtkRelievoPass::SafeDownCast(renderer->GetPass()) != nullptr)
    , Gradient(renderer->GetGradientBackground())
    , OffScreenBuffers(this->Window->GetUseOffScreenBuffers())
  {
    if (renderer->IsActiveCameraCreated())
    {
      this->Camera = renderer->GetActiveCamera();
      this->View->DeepCopy(this->Camera);
    }
    std::copy_n(this->Window->GetSize(), 2, this->Size);
    renderer->GetViewport(this->Viewport);
    renderer->GetBackground(this->Background);
    this->Alpha = renderer->GetBackgroundAlpha();
    this->Window->GetTileScale(this->TileScale);
    this->Window->GetTileViewport(this->TileViewport);
    this->Window->SetTileScale(1, 1);
    this->Window->SetTileViewport(0.0, 0.0, 1.0, 1.0);
    this->Window->SetUseOffScreenBuffers(true);
    renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
    renderer->SetActiveCamera(this->View);
    if (this->Gradient)
    {
      renderer->GradientBackgroundOff();
      renderer->SetBackground(0.0, 0.0, 0.0);
      renderer->SetBackgroundAlpha(0.0);
    }
    SetPose(sensor, this->View);
    this->FreezeLights();
    vtkRelievoPass::Attach(renderer);
  }
  ~KeptRenderer()
  {
    for (const Follower& each : this->Followers)
    {
      each.Light->SetLightType(each.Type);
      each.Light->SetPosition(each.Position);
      each.Light->SetFocalPoint(each.FocalPoint);
      each.Light->SetTransformMatrix(each.Matrix);
    }
    this->Renderer->SetGradientBackground(this->Gradient);
    this->Renderer->SetBackground(this->Background);
    this->Renderer->SetBackgroundAlpha(this->Alpha);
    this->Renderer->SetViewport(this->Viewport);
    this->Renderer->SetActiveCamera(this->Camera);
    this->SetSize(this->Size[0], this->Size[1]);
    this->Window->SetUseOffScreenBuffers(this->OffScreenBuffers);
    this->Window->SetTileScale(this->TileScale);
    this->Window->SetTileViewport(this->TileViewport);
    if (!this->Attached)
    {
      vtkRelievoPass::Detach(this->Renderer);
    }
  }
  KeptRenderer(const KeptRenderer&) = delete;
  void operator=(const KeptRenderer&) = delete;

  // The base class's way: a window on the screen stays as it is, only its buffers change.
  void SetSize(int columns, int rows) { this->Window->vtkWindow::SetSize(columns, rows); }

  vtkCamera* GetView() { return this->View; }

private:
  struct Follower
  {
    vtkSmartPointer<vtkLight> Light;
    int Type;
    double Position[3];
    double FocalPoint[3];
    vtkSmartPointer<vtkMatrix4x4> Matrix;
  };

  void FreezeLights()
  {
    vtkLightCollection* lights = this->Renderer->GetLights();
    if (lights->GetNumberOfItems() == 0 && this->Renderer->GetAutomaticLightCreation())
    {
      this->Renderer->CreateLight(); // as the first frame does
    }
    this->Renderer->UpdateLightsGeometryToFollowCamera();
    vtkCollectionSimpleIterator it;
    lights->InitTraversal(it);
    while (vtkLight* light = lights->GetNextLight(it))
    {
      if (light->LightTypeIsSceneLight())
      {
        continue;
      }
      Follower follower;
      follower.Light = light;
      follower.Type = light->GetLightType();
      light->GetPosition(follower.Position);
      light->GetFocalPoint(follower.FocalPoint);
      follower.Matrix = light->GetTransformMatrix();
      double position[3];
      double focus[3];
      light->GetTransformedPosition(position);
      light->GetTransformedFocalPoint(focus);
      light->SetLightTypeToSceneLight();
      light->SetTransformMatrix(nullptr);
      light->SetPosition(position);
      light->SetFocalPoint(focus);
      this->Followers.push_back(follower);
    }
  }

  vtkRenderer* Renderer;
  vtkRenderWindow* Window;
  bool Attached, Gradient, OffScreenBuffers;
  vtkSmartPointer<vtkCamera> Camera; // none was made: null
  vtkNew<vtkCamera> View;
  int Size[2];
  double Viewport[4];
  double Background[3];
  double Alpha;
  int TileScale[2];
  double TileViewport[4];
  std::vector<Follower> Followers;
};

// The colour of the renderer's view, 4 floats a pixel; null, after an error, if it is not drawn.
vtkSmartPointer<vtkFloatArray> DrawColor(vtkRenderer* renderer, int columns, int rows)
{
  renderer->GetRenderWindow()->vtkWindow::SetSize(columns, rows);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  source->HDROn();
  source->AddLayer(Color);
  source->Update();
  auto* color = vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray(Color));
  return color && color->GetNumberOfTuples() == vtkIdType(columns) * rows ? color : nullptr;
}

// Between the four nearest pixels. Rows are counted from the top, and stored from the bottom.
void Interpolate(const float* from, const int size[2], const double place[2], float* to)
{
  const double x = std::clamp(place[0], 0.0, size[0] - 1.0);
  const double y = std::clamp(size[1] - 1.0 - place[1], 0.0, size[1] - 1.0);
  const auto column = static_cast<vtkIdType>(std::min(x, std::max(0.0, size[0] - 2.0)));
  const auto row = static_cast<vtkIdType>(std::min(y, std::max(0.0, size[1] - 2.0)));
  const vtkIdType right = size[0] > 1 ? 4 : 0;
  const vtkIdType above = size[1] > 1 ? 4 * vtkIdType(size[0]) : 0;
  const double a = x - static_cast<double>(column);
  const double b = y - static_cast<double>(row);
  const float* corner = from + 4 * (row * size[0] + column);
  for (int i = 0; i < 4; ++i)
  {
    to[i] = static_cast<float>((1.0 - b) * ((1.0 - a) * corner[i] + a * corner[right + i]) +
      b * ((1.0 - a) * corner[above + i] + a * corner[above + right + i]));
  }
}

// By which automatic exposure multiplies: the log-average of what is drawn, or of all.
double GetExposure(const vtkFloatArray* color, double background)
{
  double sums[2] = { 0.0, 0.0 };
  double counts[2] = { 0.0, 0.0 };
  for (vtkIdType i = 0; i < color->GetNumberOfTuples(); ++i)
  {
    const float* c = const_cast<vtkFloatArray*>(color)->GetPointer(4 * i);
    const glm::dvec3 light(c[0], c[1], c[2]);
    if (relievo::f64::relievoToneIsLight(light))
    {
      const int which = c[3] > background ? 0 : 1;
      sums[which] += relievo::f64::relievoToneLogLuminance(light);
      counts[which] += 1.0;
    }
  }
  const int which = counts[0] > 0.0 ? 0 : 1;
  return counts[which] > 0.0 ? relievo::f64::relievoToneAutoExposure(sums[which] / counts[which])
                             : 1.0;
}
}

//------------------------------------------------------------------------------
vtkRelievoLensPicture::vtkRelievoLensPicture()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoLensPicture::~vtkRelievoLensPicture() = default;

//------------------------------------------------------------------------------
void vtkRelievoLensPicture::SetRenderer(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoLensPicture::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkRelievoLensPicture::SetCamera(vtkRelievoCameraModel* camera)
{
  this->Camera = camera;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRelievoCameraModel* vtkRelievoLensPicture::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoLensPicture::GetMTime()
{
  this->MTime.Modified();
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
int vtkRelievoLensPicture::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  int extent[6] = { 0, -1, 0, -1, 0, 0 };
  if (this->Camera)
  {
    extent[1] = this->Camera->GetSize()[0] - 1;
    extent[3] = this->Camera->GetSize()[1] - 1;
  }
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
// What one camera of VTK sees as the sensor does. True if it was drawn; false, without an error, if
// there is no such camera.
bool vtkRelievoLensPicture::DrawWhole(vtkFloatArray* color)
{
  const int* size = this->Camera->GetSize();
  vtkCamera* view = this->Renderer->GetActiveCamera();
  auto* lens = vtkRelievoLensCamera::SafeDownCast(this->Camera);
  auto* map = vtkRelievoOrthographicCamera::SafeDownCast(this->Camera);
  if (lens && lens->GetLens() == vtkRelievoLensCamera::PINHOLE)
  {
    lens->ApplyTo(view);
  }
  else if (map)
  {
    const double* center = map->GetPrincipalPoint();
    view->SetUserTransform(nullptr);
    view->ParallelProjectionOn();
    view->SetParallelScale(0.5 * size[1] / map->GetPixelsPerUnit());
    view->SetWindowCenter(
      1.0 - 2.0 * (center[0] + 0.5) / size[0], 2.0 * (center[1] + 0.5) / size[1] - 1.0);
  }
  else
  {
    return false;
  }
  const vtkSmartPointer<vtkFloatArray> drawn = DrawColor(this->Renderer, size[0], size[1]);
  if (drawn)
  {
    std::copy_n(drawn->GetPointer(0), drawn->GetNumberOfValues(), color->GetPointer(0));
    this->NumberOfViews = 1;
    this->NumberOfDrawnPixels = drawn->GetNumberOfTuples();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensPicture::DrawViews(vtkFloatArray* color)
{
  const int columns = this->Camera->GetSize()[0];
  const int rows = this->Camera->GetSize()[1];
  vtkRelievoLensViews views;
  const std::string wrong = views.Plan(this->Camera, this->Oversampling);
  if (!wrong.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< wrong << ".");
    return false;
  }
  for (const vtkRelievoLensViews::View& view : views.Get())
  {
    vtkNew<vtkRelievoLensCamera> pinhole;
    views.SetCamera(view, pinhole);
    pinhole->ApplyTo(this->Renderer->GetActiveCamera());
    const vtkSmartPointer<vtkFloatArray> drawn =
      DrawColor(this->Renderer, view.Size[0], view.Size[1]);
    if (!drawn)
    {
      return false;
    }
    const float* from = drawn->GetPointer(0);
    float* to = color->GetPointer(0);
    vtkRelievoWithThreads([&] {
      vtkSMPTools::For(0, vtkIdType(columns) * rows, Grain, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const auto row = static_cast<int>(i / columns);
          const auto column = static_cast<int>(i % columns);
          double place[2];
          if (views.Find(view, column, row, place))
          {
            Interpolate(
              from, view.Size, place, to + 4 * ((vtkIdType(rows) - 1 - row) * columns + column));
          }
        }
      });
    });
    ++this->NumberOfViews;
    this->NumberOfDrawnPixels += drawn->GetNumberOfTuples();
    this->UpdateProgress(double(this->NumberOfViews) / static_cast<double>(views.Get().size()));
    if (this->GetAbortExecute())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Behind what covers its pixel in part or not at all.
void vtkRelievoLensPicture::AddGradient(
  vtkFloatArray* color, const double bottom[3], const double top[3])
{
  const int columns = this->Camera->GetSize()[0];
  const int rows = this->Camera->GetSize()[1];
  for (int row = 0; row < rows; ++row)
  {
    const double share = (row + 0.5) / rows;
    double behind[3];
    for (int i = 0; i < 3; ++i)
    {
      behind[i] = relievo::f64::relievoLinearFromSrgb((1.0 - share) * bottom[i] + share * top[i]);
    }
    for (int column = 0; column < columns; ++column)
    {
      double origin[3];
      double direction[3];
      if (this->Camera->GetCameraRay(column, rows - 1 - row, origin, direction))
      {
        float* c = color->GetPointer(4 * (vtkIdType(row) * columns + column));
        const double left = 1.0 - std::clamp(static_cast<double>(c[3]), 0.0, 1.0);
        for (int i = 0; i < 3; ++i)
        {
          c[i] += static_cast<float>(left * behind[i]);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// As the frame makes it of the linear colour.
vtkSmartPointer<vtkUnsignedCharArray> vtkRelievoLensPicture::MakePicture(
  vtkFloatArray* color, vtkRelievoPass* frame)
{
  using namespace relievo::f64;
  vtkRelievoToneStage* tone = frame ? frame->GetToneStage() : nullptr;
  tone = tone && tone->GetChangesPicture() ? tone : nullptr;
  const double background = this->Renderer->GetBackgroundAlpha();
  const double exposure = !tone ? 1.0
                                : std::exp2(tone->GetExposure()) *
      (tone->GetAutoExposure() ? GetExposure(color, background) : 1.0);
  const vtkIdType columns = this->Camera->GetSize()[0];
  auto picture = vtkSmartPointer<vtkUnsignedCharArray>::New();
  picture->SetName(Shown);
  picture->SetNumberOfComponents(3);
  picture->SetNumberOfTuples(color->GetNumberOfTuples());
  vtkRelievoWithThreads([&] {
    vtkSMPTools::For(0, color->GetNumberOfTuples(), Grain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float* c = color->GetPointer(4 * i);
        glm::dvec3 light = relievoToneClean(glm::dvec3(c[0], c[1], c[2]));
        light = tone ? relievoTone(tone->GetOperator(), light * exposure, tone->GetWhite())
                     : relievoToneClamp(light);
        const glm::dvec3 shown = relievoSrgbColorFromLinear(light);
        for (int k = 0; k < 3; ++k)
        {
          double threshold = 0.5;
          if (tone && tone->GetDither() != vtkRelievoToneStage::DITHER_NONE)
          {
            const auto x = static_cast<unsigned int>(i % columns);
            const auto y = static_cast<unsigned int>(i / columns);
            threshold = tone->GetDither() == vtkRelievoToneStage::DITHER_ORDERED
              ? relievoToneBayer(x, y)
              : vtkRelievoToneStage::GetBlueNoise(static_cast<int>(x), static_cast<int>(y));
          }
          picture->SetValue(3 * i + k,
            static_cast<unsigned char>(
              std::lround(255.0 * relievoToneDither(shown[k], threshold))));
        }
      }
    });
  });
  return picture;
}

//------------------------------------------------------------------------------
int vtkRelievoLensPicture::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(outputs);
  image->Initialize();
  this->NumberOfViews = 0;
  this->NumberOfDrawnPixels = 0;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->Renderer || !this->Renderer->GetRenderWindow() || !this->Camera)
  {
    vtkErrorMacro(
      "A picture is asked of " << (!this->Renderer ? "no renderer; use SetRenderer."
          : !this->Camera                          ? "no sensor; use SetCamera."
                          : "a renderer without a window; add it to a vtkRenderWindow."));
    return 0;
  }
  if (this->Renderer->GetTexturedBackground() && this->Renderer->GetBackgroundTexture())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("A background by a texture is made for one pinhole's picture, not for a lens: "
                  "switch it off (TexturedBackgroundOff), or make it a skybox.");
    return 0;
  }
  auto* frame = vtkRelievoPass::SafeDownCast(this->Renderer->GetPass());
  const char* layer = frame ? frame->GetDisplayLayer() : nullptr;
  if (layer && *layer)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("The layer '" << layer
                                << "' is shown as the picture; a lens has colour, and its layers "
                                   "by rays (vtkRelievoRayLayers).");
    return 0;
  }
  const int columns = this->Camera->GetSize()[0];
  const int rows = this->Camera->GetSize()[1];
  vtkNew<vtkFloatArray> color;
  color->SetName(Color);
  color->SetNumberOfComponents(4);
  color->SetNumberOfTuples(vtkIdType(columns) * rows);
  std::fill_n(color->GetPointer(0), color->GetNumberOfValues(), 0.f);
  const bool gradient = this->Renderer->GetGradientBackground();
  double bottom[3];
  double top[3];
  this->Renderer->GetBackground(bottom);
  this->Renderer->GetBackground2(top);
  bool drawn = false;
  {
    KeptRenderer kept(this->Renderer, this->Camera);
    drawn = (this->DrawWhole(color) ? this->NumberOfViews == 1 : this->DrawViews(color));
  }
  if (!drawn)
  {
    return this->GetAbortExecute() ? 1 : 0;
  }
  if (gradient)
  {
    this->AddGradient(color, bottom, top);
  }
  image->SetDimensions(columns, rows, 1);
  if (this->Picture)
  {
    image->GetPointData()->SetScalars(this->MakePicture(color, frame));
  }
  if (!this->HDR)
  {
    for (vtkIdType i = 0; i < color->GetNumberOfValues(); ++i)
    {
      color->SetValue(i, std::clamp(color->GetValue(i), 0.f, 1.f));
    }
  }
  image->GetPointData()->AddArray(color);
  this->Camera->AddTo(image->GetFieldData());
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoLensPicture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "Oversampling: " << this->Oversampling << "\n";
  os << indent << "HDR: " << this->HDR << "\n";
  os << indent << "Picture: " << this->Picture << "\n";
  os << indent << "NumberOfViews: " << this->NumberOfViews << "\n";
  os << indent << "NumberOfDrawnPixels: " << this->NumberOfDrawnPixels << "\n";
}
