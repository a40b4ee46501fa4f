// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowPictures.h"

#include "Check.h"
#include "Window.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace relievoTest
{
//------------------------------------------------------------------------------
std::string PictureErrors::ToString() const
{
  std::ostringstream out;
  out << this->LitWrong << " of " << this->Lit << " lit and " << this->DarkWrong << " of "
      << this->Dark << " dark pixels are wrong, " << this->Outside << " are neither";
  return out.str();
}

//------------------------------------------------------------------------------
PictureErrors JudgePicture(vtkImageData* shadows, vtkImageData* off, vtkImageData* dark,
  const ShadowTruth& truth, int radius, int slack)
{
  PictureErrors errors;
  const ShadowTruth inner = GetInner(truth, radius);
  const int width = truth.Width;
  const int height = truth.Height;
  for (vtkImageData* image : { shadows, off, dark })
  {
    const int* size = image->GetDimensions();
    if (!RELIEVO_CHECK_THAT(
          size[0] == width && size[1] == height && image->GetNumberOfScalarComponents() == 3,
          "a picture of another size than the truth"))
    {
      return errors;
    }
  }
  const auto channels = [](vtkImageData* image, std::size_t pixel) {
    return static_cast<const unsigned char*>(image->GetScalarPointer()) + 3 * pixel;
  };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      bool isOff = true;
      bool isDark = true;
      bool between = true;
      for (int c = 0; c < 3; ++c)
      {
        const int value = channels(shadows, pixel)[c];
        const int lit = channels(off, pixel)[c];
        const int unlit = channels(dark, pixel)[c];
        isOff = isOff && std::abs(value - lit) <= slack;
        isDark = isDark && std::abs(value - unlit) <= slack;
        between =
          between && value >= std::min(lit, unlit) - slack && value <= std::max(lit, unlit) + slack;
      }
      errors.Outside += between ? 0 : 1;
      if (inner.Verdicts[pixel] == ShadowTruth::Lit)
      {
        ++errors.Lit;
        errors.LitWrong += isOff ? 0 : 1;
      }
      else if (inner.Verdicts[pixel] == ShadowTruth::Dark)
      {
        ++errors.Dark;
        errors.DarkWrong += isDark ? 0 : 1;
      }
    }
  }
  return errors;
}

//------------------------------------------------------------------------------
long long CountUnlike(vtkImageData* a, vtkImageData* b, int slack)
{
  auto* first = a->GetPointData()->GetScalars();
  auto* second = b->GetPointData()->GetScalars();
  if (!first || !second || first->GetNumberOfValues() != second->GetNumberOfValues())
  {
    Fail(__FILE__, __LINE__, "pictures of two sizes");
    return -1;
  }
  const auto* p = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* q = static_cast<const unsigned char*>(b->GetScalarPointer());
  const int channels = first->GetNumberOfComponents();
  long long count = 0;
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    int largest = 0;
    for (int c = 0; c < channels; ++c)
    {
      largest = std::max(largest, std::abs(p[i * channels + c] - q[i * channels + c]));
    }
    count += largest > slack ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> AddTwoSuns(ShadowStage& stage)
{
  const auto light = stage.AddSun(-3., 4., -2.);
  light->SetIntensity(0.7);
  const auto fill = stage.AddSun(-2., 3., 4.);
  fill->SetIntensity(0.3);
  stage.GetShadows()->SetLightCasts(fill, false);
  return light;
}

//------------------------------------------------------------------------------
ShadowPictures::ShadowPictures(ShadowStage& stage, vtkLight* light)
  : ShadowPictures(stage, light, [&stage]() { return Picture(stage.Window); })
{
}

//------------------------------------------------------------------------------
ShadowPictures::ShadowPictures(ShadowStage& stage, vtkLight* light,
  const std::function<vtkSmartPointer<vtkImageData>()>& picture)
{
  stage.GetFrame()->ShadowsOff();
  picture(); // the first frame of some passes differs from the second
  this->Off = picture();
  const double intensity = light->GetIntensity();
  light->SetIntensity(0.);
  this->Dark = picture();
  light->SetIntensity(intensity);
  stage.GetFrame()->ShadowsOn();
  this->On = picture();
}

//------------------------------------------------------------------------------
PictureErrors CheckPictures(const std::string& what, const ShadowPictures& pictures,
  const ShadowTruth& truth, double limit, int radius, int slack)
{
  const PictureErrors errors =
    JudgePicture(pictures.On, pictures.Off, pictures.Dark, truth, radius, slack);
  std::cout << what << ": " << errors.ToString() << "\n";
  const auto share = [](long long part, long long all) {
    return static_cast<double>(part) / static_cast<double>(std::max(1LL, all));
  };
  RELIEVO_CHECK_THAT(errors.Lit > 3000 && errors.Dark > 200, what + ": too little is judged");
  RELIEVO_CHECK_AT_MOST(share(errors.LitWrong, errors.Lit), limit,
    what + ": share of lit pixels unlike those without shadows");
  RELIEVO_CHECK_AT_MOST(share(errors.DarkWrong, errors.Dark), limit,
    what + ": share of dark pixels unlike those without that light");
  return errors;
}
}
