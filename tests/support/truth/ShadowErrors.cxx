// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowErrors.h"

#include "EmbreeScene.h"

#include <vtkLight.h>
#include <vtkSMPTools.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>

namespace relievoTest
{
//------------------------------------------------------------------------------
std::string ShadowErrors::ToString() const
{
  std::ostringstream out;
  const double all = static_cast<double>(this->Compared > 0 ? this->Compared : 1);
  out << 100. * this->Wrong() << " % wrong (" << this->FalseShadow << " false shadow, "
      << this->FalseLight << " false light of " << this->Compared << " pixels, "
      << 100. * static_cast<double>(this->Dark) / all << " % dark; " << this->Flipping << " flip)";
  return out.str();
}

//------------------------------------------------------------------------------
ShadowTruth TraceShadow(
  const EmbreeScene& scene, const TruthImage& view, vtkLight* light, double jitter)
{
  glm::dvec3 position;
  glm::dvec3 focus;
  light->GetTransformedPosition(position.x, position.y, position.z);
  light->GetTransformedFocalPoint(focus.x, focus.y, focus.z);
  const glm::dvec3 axis = glm::normalize(focus - position);
  const bool positional = light->GetPositional() != 0;
  const bool spot = positional && light->GetConeAngle() < 90.;
  const double cosine = std::cos(glm::radians(light->GetConeAngle()));

  ShadowTruth truth;
  truth.Width = view.Width;
  truth.Height = view.Height;
  truth.Verdicts.assign(view.Pixels.size(), ShadowTruth::Unjudged);
  std::atomic<long long> flipping(0);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(view.Pixels.size()), [&](vtkIdType from, vtkIdType to) {
      for (vtkIdType i = from; i < to; ++i)
      {
        const PixelTruth& pixel = view.Pixels[i];
        if (!pixel.Hit)
        {
          continue;
        }
        const glm::dvec3 toLight = positional ? position - pixel.Position : -axis;
        const glm::dvec3 unit = glm::normalize(toLight);
        if (glm::dot(pixel.Normal, unit) <= 0.05 || (spot && glm::dot(-unit, axis) < cosine + 1e-3))
        {
          continue;
        }
        const ShadowVerdict verdict = scene.Shadow(
          pixel, toLight, positional ? 1. : std::numeric_limits<double>::infinity(), jitter);
        if (!verdict.Stable)
        {
          ++flipping;
          continue;
        }
        truth.Verdicts[i] = verdict.Occluded ? ShadowTruth::Dark : ShadowTruth::Lit;
      }
    });
  truth.Flipping = flipping;
  return truth;
}

//------------------------------------------------------------------------------
ShadowTruth WithoutEdges(const ShadowTruth& truth, const TruthImage& view)
{
  ShadowTruth inner = truth;
  for (std::size_t i = 0; i < inner.Verdicts.size(); ++i)
  {
    if (!(view.Pixels[i].EdgeDistance > 1. / 256.))
    {
      inner.Verdicts[i] = ShadowTruth::Unjudged;
    }
  }
  return inner;
}

//------------------------------------------------------------------------------
ShadowErrors CompareShadow(const ShadowTruth& truth, const float* visibility)
{
  ShadowErrors errors;
  errors.Flipping = truth.Flipping;
  for (std::size_t i = 0; i < truth.Verdicts.size(); ++i)
  {
    if (truth.Verdicts[i] == ShadowTruth::Unjudged)
    {
      continue;
    }
    const bool dark = truth.Verdicts[i] == ShadowTruth::Dark;
    const bool drawnDark = !(visibility[i] >= 0.5f);
    ++errors.Compared;
    errors.Dark += dark ? 1 : 0;
    errors.FalseShadow += !dark && drawnDark ? 1 : 0;
    errors.FalseLight += dark && !drawnDark ? 1 : 0;
  }
  return errors;
}
}
