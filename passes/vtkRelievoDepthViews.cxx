// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthViews.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoWindowGuard.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkRelievoDepthViews);

namespace
{
// The view and the pass that a renderer had.
class ScopedView
{
public:
  explicit ScopedView(vtkRenderer* renderer)
    : Renderer(renderer)
    , Guard(renderer)
    , Attached(vtkRelievoPass::SafeDownCast(renderer->GetPass()) != nullptr)
  {
    vtkRelievoPass::Attach(renderer);
  }
  ~ScopedView()
  {
    if (!this->Attached)
    {
      vtkRelievoPass::Detach(this->Renderer);
    }
  }
  ScopedView(const ScopedView&) = delete;
  void operator=(const ScopedView&) = delete;

private:
  vtkRenderer* Renderer;
  vtkRelievoWindowGuard Guard;
  bool Attached;
};
}

//------------------------------------------------------------------------------
vtkRelievoDepthViews::vtkRelievoDepthViews()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoDepthViews::~vtkRelievoDepthViews() = default;

//------------------------------------------------------------------------------
void vtkRelievoDepthViews::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoDepthViews::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoDepthViews::GetMTime()
{
  this->MTime.Modified();
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
// The box of the views, and one around all that there is; false if there is no box.
bool vtkRelievoDepthViews::GetBoxes(double box[6], double seen[6])
{
  vtkBoundingBox all;
  double props[6];
  this->Renderer->ComputeVisiblePropBounds(props);
  if (props[0] <= props[1])
  {
    all.AddBounds(props);
  }
  std::copy(this->Bounds, this->Bounds + 6, box);
  if (box[0] > box[1] || box[2] > box[3] || box[4] > box[5])
  {
    std::copy(props, props + 6, box);
  }
  const bool found = box[0] <= box[1];
  if (found)
  {
    all.AddBounds(box);
    all.GetBounds(seen);
  }
  return found;
}

//------------------------------------------------------------------------------
void vtkRelievoDepthViews::Aim(
  vtkCamera* camera, int axis, int sign, const double box[6], const double seen[6])
{
  const int up = axis == 2 ? 1 : 2;
  const int across = 3 - axis - up;
  const double width = box[2 * across + 1] - box[2 * across];
  const double height = box[2 * up + 1] - box[2 * up];
  const double longest = std::max({ width, height, box[2 * axis + 1] - box[2 * axis] });
  const int* pixels = this->Renderer->GetRenderWindow()->GetSize();
  double texel = this->TexelSize > 0. ? this->TexelSize
    : longest > 0.                    ? longest / this->Resolution
                                      : 1.;
  texel = std::max({ texel, width / pixels[0], height / pixels[1] });
  // Rounding must not add a texel.
  const auto count = [texel](
                       double length) { return std::max(1., std::ceil(length / texel - 1e-6)); };
  this->Renderer->SetViewport(
    0., 0., std::min(count(width) / pixels[0], 1.), std::min(count(height) / pixels[1], 1.));

  double middle[3];
  double place[3];
  double upwards[3] = { 0., 0., 0. };
  for (int a = 0; a < 3; ++a)
  {
    middle[a] = (box[2 * a] + box[2 * a + 1]) / 2.;
    place[a] = middle[a];
  }
  upwards[up] = 1.;
  const double depth = std::max(seen[2 * axis + 1] - seen[2 * axis], longest);
  const double margin = depth > 0. ? 0.01 * depth : 1.;
  place[axis] = sign > 0 ? seen[2 * axis] - 2. * margin : seen[2 * axis + 1] + 2. * margin;
  middle[axis] = place[axis] + sign * (depth > 0. ? depth : 1.);
  camera->ParallelProjectionOn();
  camera->SetPosition(place);
  camera->SetFocalPoint(middle);
  camera->SetViewUp(upwards);
  camera->SetParallelScale(count(height) * texel / 2.);
  camera->SetClippingRange(margin, depth + 3. * margin);
}

//------------------------------------------------------------------------------
int vtkRelievoDepthViews::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->Renderer || !this->Renderer->GetRenderWindow())
  {
    vtkErrorMacro("Depth views are asked of "
      << (this->Renderer ? "a renderer without a window; add it to a vtkRenderWindow."
                         : "no renderer; use SetRenderer."));
    // Status 0 would make the pipeline say it again in its own words.
    this->SetErrorCode(vtkErrorCode::UserError);
    return 1;
  }
  double box[6];
  double seen[6];
  if (!this->GetBoxes(box, seen))
  {
    return 1; // nothing to see
  }
  for (int i = 0; i < 6; ++i)
  {
    // Sums and differences of two ends must be finite as well.
    constexpr double Farthest = std::numeric_limits<double>::max() / 4.;
    if (!(std::abs(box[i]) <= Farthest && std::abs(seen[i]) <= Farthest))
    {
      vtkErrorMacro("No depth views: along "
        << "xyz"[i / 2] << " the box is from " << box[i / 2 * 2] << " to " << box[i / 2 * 2 + 1]
        << " and the props from " << seen[i / 2 * 2] << " to " << seen[i / 2 * 2 + 1]
        << ", expected finite numbers; set Bounds.");
      this->SetErrorCode(vtkErrorCode::UserError);
      return 1;
    }
  }
  const ScopedView kept(this->Renderer);
  vtkNew<vtkRelievoLayerSource> capture;
  capture->SetRenderer(this->Renderer);
  capture->AddLayer("depth");
  unsigned int block = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int sign : { 1, -1 })
    {
      if (!this->SixViews && axis != this->Axis)
      {
        continue;
      }
      this->UpdateProgress(block / (this->SixViews ? 6. : 2.));
      if (this->GetAbortExecute())
      {
        output->Initialize();
        return 1;
      }
      vtkNew<vtkCamera> camera;
      this->Renderer->SetActiveCamera(camera);
      this->Aim(camera, axis, sign, box, seen);
      capture->Update();
      if (capture->GetErrorCode() != vtkErrorCode::NoError ||
        capture->GetOutput()->GetNumberOfPoints() == 0)
      {
        output->Initialize();
        this->SetErrorCode(vtkErrorCode::UserError);
        return 1;
      }
      vtkNew<vtkImageData> image;
      image->DeepCopy(capture->GetOutput());
      output->SetBlock(block, image);
      const std::string name = std::string(sign > 0 ? "+" : "-") + "xyz"[axis];
      output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
      ++block;
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoDepthViews::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.GetPointer() << "\n";
  os << indent << "SixViews: " << this->SixViews << "\n";
  os << indent << "Axis: " << this->Axis << "\n";
  os << indent << "Bounds: " << this->Bounds[0] << " " << this->Bounds[1] << " " << this->Bounds[2]
     << " " << this->Bounds[3] << " " << this->Bounds[4] << " " << this->Bounds[5] << "\n";
  os << indent << "TexelSize: " << this->TexelSize << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
}
