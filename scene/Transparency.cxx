// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Transparency.h"

#include "Ground.h"
#include "Scene.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace scene
{
//------------------------------------------------------------------------------
Backdrop::Backdrop(const Scene& scene, double grey)
  : Shown(scene)
  , Gradient(scene.Renderer->GetGradientBackground())
{
  scene.Renderer->GetBackground(this->Bottom);
  if (scene.Ground)
  {
    GetGroundColor(scene.Ground, this->Ground);
  }
  const double color[3] = { grey, grey, grey };
  scene.Renderer->GradientBackgroundOff();
  this->Paint(color, color);
}

//------------------------------------------------------------------------------
Backdrop::~Backdrop()
{
  this->Shown.Renderer->SetGradientBackground(this->Gradient);
  this->Paint(this->Bottom, this->Ground);
}

//------------------------------------------------------------------------------
void Backdrop::Paint(const double bottom[3], const double ground[3])
{
  this->Shown.Renderer->SetBackground(bottom);
  if (this->Shown.Ground)
  {
    SetGroundColor(this->Shown.Ground, ground);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeTransparent(vtkImageData* overBlack, vtkImageData* overWhite)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(overBlack->GetDimensions());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* from = vtkUnsignedCharArray::SafeDownCast(overBlack->GetPointData()->GetScalars());
  auto* other = vtkUnsignedCharArray::SafeDownCast(overWhite->GetPointData()->GetScalars());
  auto* to = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType pixel = 0; pixel < to->GetNumberOfTuples(); ++pixel)
  {
    const unsigned char* black = from->GetPointer(3 * pixel);
    const unsigned char* white = other->GetPointer(3 * pixel);
    unsigned char* rgba = to->GetPointer(4 * pixel);
    int seen = 0; // the background's share, over all channels
    for (int i = 0; i < 3; ++i)
    {
      seen += std::max(0, white[i] - black[i]);
    }
    const int alpha = 255 - (seen + 1) / 3;
    for (int i = 0; i < 3; ++i)
    {
      rgba[i] = alpha > 0
        ? static_cast<unsigned char>(std::min(255, (255 * black[i] + alpha / 2) / alpha))
        : 0;
    }
    rgba[3] = static_cast<unsigned char>(alpha);
  }
  return image;
}
}
