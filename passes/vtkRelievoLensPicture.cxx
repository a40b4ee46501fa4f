// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLensPicture.h"

#include "vtkCamera.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoDisplay.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoLensViews.h"
#include "vtkRelievoOrthographicCamera.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoScopedRenderer.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoToneStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoLensPicture);

namespace
{
constexpr const char* Color = "color";
constexpr const char* Depth = "depth";
constexpr const char* Shown = "picture";
constexpr int MostTexels = 1024; // of a view's background each way
constexpr vtkIdType Grain = 4096;
constexpr unsigned char Unseen = 2; // beside 0 for the background, 1 for drawn pixels

// One exposure for all views, in place of one that each would measure.
class ScopedExposure
{
public:
  ScopedExposure(vtkRelievoToneStage* tone, double factor)
    : Tone(tone && tone->GetAutoExposure() ? tone : nullptr)
    , Stops(tone ? tone->GetExposure() : 0.0)
  {
    if (this->Tone)
    {
      this->Tone->AutoExposureOff();
      this->Tone->SetExposure(this->Stops + std::log2(factor));
    }
  }
  ~ScopedExposure()
  {
    if (this->Tone)
    {
      this->Tone->AutoExposureOn();
      this->Tone->SetExposure(this->Stops);
    }
  }
  ScopedExposure(const ScopedExposure&) = delete;
  void operator=(const ScopedExposure&) = delete;

private:
  vtkRelievoToneStage* Tone;
  double Stops;
};

// The drawn part of the renderer's view.
struct Drawn
{
  vtkSmartPointer<vtkFloatArray> Color; // 4 floats a pixel; null, after an error: nothing was
  vtkSmartPointer<vtkFloatArray> Depth; // if it was asked for
};

// The stage `tone`, if it makes the picture.
vtkRelievoToneStage* GetTone(vtkRenderer* renderer)
{
  auto* frame = vtkRelievoPass::SafeDownCast(renderer->GetPass());
  vtkRelievoToneStage* tone = frame ? frame->GetToneStage() : nullptr;
  return tone && tone->GetChangesPicture() ? tone : nullptr;
}

// The window's picture, decoded, or the linear colour of the frame.
Drawn Draw(vtkRenderer* renderer, int columns, int rows, bool isPicture, bool depth)
{
  renderer->GetRenderWindow()->vtkWindow::SetSize(columns, rows);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRelievoLayerSource> source;
  vtkNew<vtkImageData> image;
  if (isPicture && GetTone(renderer)) // the source gives the light before it
  {
    auto* frame = vtkRelievoPass::SafeDownCast(renderer->GetPass());
    const bool waits = frame->GetWaitForSamples();
    frame->WaitForSamplesOn();
    renderer->GetRenderWindow()->Render();
    frame->SetWaitForSamples(waits);
    vtkRelievoLayerSource::AddColor(renderer, image);
  }
  else
  {
    source->SetRenderer(renderer);
    source->SetHDR(!isPicture);
    source->AddLayer(Color);
    if (depth)
    {
      source->AddLayer(Depth);
    }
    source->Update();
    image->ShallowCopy(source->GetOutput());
  }
  Drawn drawn;
  vtkPointData* layers = image->GetPointData();
  if (image->GetNumberOfPoints() == vtkIdType(columns) * rows)
  {
    drawn.Color = vtkFloatArray::SafeDownCast(layers->GetArray(Color));
    drawn.Depth = vtkFloatArray::SafeDownCast(layers->GetArray(Depth));
  }
  return drawn;
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

// For display, 3 bytes a pixel.
vtkSmartPointer<vtkUnsignedCharArray> MakeBytes(vtkFloatArray* color)
{
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName(Shown);
  bytes->SetNumberOfComponents(3);
  bytes->SetNumberOfTuples(color->GetNumberOfTuples());
  vtkRelievoWithThreads([&] {
    vtkSMPTools::For(0, color->GetNumberOfTuples(), Grain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          const double light = std::clamp<double>(color->GetValue(4 * i + k), 0.0, 1.0);
          bytes->SetValue(3 * i + k,
            static_cast<unsigned char>(
              std::lround(255.0 * relievo::f64::relievoSrgbFromLinear(light))));
        }
      }
    });
  });
  return bytes;
}

vtkIdType GetNearest(const int size[2], const double place[2])
{
  const auto column = std::clamp<vtkIdType>(std::lround(place[0]), 0, size[0] - 1);
  const auto row = std::clamp<vtkIdType>(std::lround(place[1]), 0, size[1] - 1);
  return (size[1] - 1 - row) * size[0] + column;
}

// The factor of automatic exposure: by the log-average of the drawn pixels, or of all.
double GetExposure(vtkFloatArray* color, const std::vector<unsigned char>& drawn)
{
  double sums[2] = { 0.0, 0.0 };
  double counts[2] = { 0.0, 0.0 };
  for (vtkIdType i = 0; i < color->GetNumberOfTuples(); ++i)
  {
    const float* c = color->GetPointer(4 * i);
    const glm::dvec3 light(c[0], c[1], c[2]);
    const unsigned char which = drawn[static_cast<std::size_t>(i)];
    if (which != Unseen && relievo::f64::relievoToneIsLight(light))
    {
      sums[which] += relievo::f64::relievoToneLogLuminance(light);
      counts[which] += 1.0;
    }
  }
  const int which = counts[1] > 0.0 ? 1 : 0;
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
// Draws with the camera of VTK that sees exactly the sensor's picture. False, without an error, if
// there is no such camera.
bool vtkRelievoLensPicture::DrawWhole(vtkFloatArray* color, bool isPicture)
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
  const Drawn drawn = Draw(this->Renderer, size[0], size[1], isPicture, this->IsMetered());
  if (drawn.Color)
  {
    std::copy_n(drawn.Color->GetPointer(0), drawn.Color->GetNumberOfValues(), color->GetPointer(0));
    this->NumberOfViews = 1;
    this->NumberOfDrawnPixels = drawn.Color->GetNumberOfTuples();
    for (vtkIdType i = 0; i < drawn.Color->GetNumberOfTuples(); ++i)
    {
      this->Marks[static_cast<std::size_t>(i)] = this->IsDrawn(
        drawn.Color->GetValue(4 * i + 3), drawn.Depth ? drawn.Depth->GetValue(i) : 0.f);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensPicture::DrawViews(vtkFloatArray* color, bool isPicture)
{
  const int columns = this->Camera->GetSize()[0];
  const int rows = this->Camera->GetSize()[1];
  vtkRelievoLensViews views;
  const std::string error = views.Plan(this->Camera, this->Oversampling);
  if (!error.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< error << ".");
    return false;
  }
  for (const vtkRelievoLensView& view : views.Get())
  {
    vtkNew<vtkRelievoLensCamera> pinhole;
    views.SetCamera(view, pinhole);
    pinhole->ApplyTo(this->Renderer->GetActiveCamera());
    this->PutBehind(views, view);
    const Drawn drawn =
      Draw(this->Renderer, view.Size[0], view.Size[1], isPicture, this->IsMetered());
    if (this->Gradient)
    {
      this->Renderer->GetBackgroundTexture()->ReleaseGraphicsResources(
        this->Renderer->GetRenderWindow());
    }
    if (!drawn.Color)
    {
      return false;
    }
    const float* from = drawn.Color->GetPointer(0);
    const float* depth = drawn.Depth ? drawn.Depth->GetPointer(0) : nullptr;
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
            const vtkIdType pixel = (vtkIdType(rows) - 1 - row) * columns + column;
            Interpolate(from, view.Size, place, to + 4 * pixel);
            this->Marks[static_cast<std::size_t>(pixel)] =
              this->IsDrawn(to[4 * pixel + 3], depth ? depth[GetNearest(view.Size, place)] : 0.f);
          }
        }
      });
    });
    ++this->NumberOfViews;
    this->NumberOfDrawnPixels += drawn.Color->GetNumberOfTuples();
    this->UpdateProgress(double(this->NumberOfViews) / static_cast<double>(views.Get().size()));
    if (this->GetAbortExecute())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// A gradient spans the sensor's picture: a view gets the part that is behind its own rays.
void vtkRelievoLensPicture::PutBehind(
  const vtkRelievoLensViews& views, const vtkRelievoLensView& view)
{
  if (!this->Gradient)
  {
    return;
  }
  const int size[2] = { std::min(view.Size[0], MostTexels), std::min(view.Size[1], MostTexels) };
  vtkNew<vtkRelievoLensCamera> pinhole;
  views.SetCamera(view, pinhole);
  vtkNew<vtkImageData> image;
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* colors = static_cast<float*>(image->GetScalarPointer());
  const double rows = this->Camera->GetSize()[1];
  double bottom[3];
  double top[3];
  this->Renderer->GetBackground(bottom);
  this->Renderer->GetBackground2(top);
  for (int j = 0; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      const double u = (i + 0.5) * view.Size[0] / size[0] - 0.5;
      const double v = (size[1] - j - 0.5) * view.Size[1] / size[1] - 0.5;
      double origin[3];
      double point[3];
      double place[2];
      pinhole->GetRay(u, v, origin, point);
      vtkMath::Add(origin, point, point);
      this->Camera->Project(point, place); // NaN where the sensor sees nothing
      const double share =
        std::isfinite(place[1]) ? std::clamp(1.0 - (place[1] + 0.5) / rows, 0.0, 1.0) : 0.0;
      for (int k = 0; k < 3; ++k)
      {
        colors[3 * (j * size[0] + i) + k] =
          static_cast<float>((1.0 - share) * bottom[k] + share * top[k]);
      }
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->RepeatOff();
  texture->EdgeClampOn();
  this->Renderer->GradientBackgroundOff();
  this->Renderer->TexturedBackgroundOn();
  this->Renderer->SetBackgroundTexture(texture);
}

//------------------------------------------------------------------------------
// Whether automatic exposure measures only the drawn pixels.
bool vtkRelievoLensPicture::IsMetered()
{
  vtkRelievoToneStage* tone = GetTone(this->Renderer);
  return this->Picture && tone && tone->GetAutoExposure();
}

//------------------------------------------------------------------------------
// A gradient is opaque, as for the stage `tone`.
bool vtkRelievoLensPicture::IsDrawn(float alpha, float depth)
{
  return std::isfinite(depth) || (!this->Gradient && alpha > this->Renderer->GetBackgroundAlpha());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkRelievoLensPicture::DrawAll(bool isPicture)
{
  const vtkIdType pixels = vtkIdType(this->Camera->GetSize()[0]) * this->Camera->GetSize()[1];
  auto color = vtkSmartPointer<vtkFloatArray>::New();
  color->SetName(Color);
  color->SetNumberOfComponents(4);
  color->SetNumberOfTuples(pixels);
  std::fill_n(color->GetPointer(0), color->GetNumberOfValues(), 0.f);
  this->Marks.assign(static_cast<std::size_t>(pixels), Unseen);
  this->NumberOfViews = 0;
  this->NumberOfDrawnPixels = 0;
  const vtkRelievoScopedRenderer kept(this->Renderer, this->Camera);
  const bool drawn = this->DrawWhole(color, isPicture) ? this->NumberOfViews == 1
                                                       : this->DrawViews(color, isPicture);
  return drawn ? color : nullptr;
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
  std::string error = vtkRelievoDisplay::Check(this->Renderer->GetRenderWindow());
  error = error.empty() ? vtkRelievoPass::CheckLights(this->Renderer) : error + ".";
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
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
  this->Gradient = this->Renderer->GetGradientBackground();
  vtkRelievoToneStage* tone = GetTone(this->Renderer);
  const bool isLinear = this->HDR || tone;
  vtkSmartPointer<vtkFloatArray> color = isLinear ? this->DrawAll(false) : nullptr;
  vtkSmartPointer<vtkFloatArray> shown;
  if (!isLinear || (this->Picture && color))
  {
    const ScopedExposure kept(tone, this->IsMetered() ? GetExposure(color, this->Marks) : 1.0);
    shown = this->DrawAll(true);
  }
  this->Marks = {};
  color = isLinear ? color : shown;
  if (!color || (this->Picture && !shown))
  {
    return this->GetAbortExecute() ? 1 : 0;
  }
  image->SetDimensions(this->Camera->GetSize()[0], this->Camera->GetSize()[1], 1);
  if (this->Picture)
  {
    image->GetPointData()->SetScalars(MakeBytes(shown));
  }
  for (vtkIdType i = 0; !this->HDR && i < color->GetNumberOfValues(); ++i)
  {
    color->SetValue(i, std::clamp(color->GetValue(i), 0.f, 1.f));
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
