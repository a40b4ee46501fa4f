// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A square whose smooth texture has holes, with a cutoff in opacity: its visible part compared with
// bilinear filtering in double, with Phong and PBR; tests/python/testCutOuts.py has the rest.
#include "Check.h"
#include "GLCheck.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoMaterial.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <cmath>
#include <string>

namespace testMaterialCutoff
{
namespace
{
using namespace relievoTest;

constexpr int Side = 120;
constexpr int Texels = 8;
constexpr double Cutoff = 0.6;

// Opacities of a slow wave, in bytes.
int AlphaOf(int x, int y)
{
  return static_cast<int>(std::lround(127.5 + 127.5 * std::sin(1.3 * x + 0.4) * std::cos(0.9 * y)));
}

// Alpha at a place from 0 to 1 in the square, as OpenGL filters repeated texels.
double AlphaAt(double u, double v)
{
  const double x = u * Texels - 0.5;
  const double y = v * Texels - 0.5;
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const double a = x - i;
  const double b = y - j;
  const auto texel = [](int column, int row) {
    return AlphaOf((column + Texels) % Texels, (row + Texels) % Texels) / 255.;
  };
  return (1. - b) * ((1. - a) * texel(i, j) + a * texel(i + 1, j)) +
    b * ((1. - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
}

vtkSmartPointer<vtkTexture> MakeTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Texels, Texels, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < Texels; ++y)
  {
    for (int x = 0; x < Texels; ++x)
    {
      for (int c = 0; c < 4; ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, c == 3 ? AlphaOf(x, y) : 255);
      }
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->RepeatOn();
  return texture;
}

void TestHoles(bool pbr)
{
  const Stage stage(Side, Side);
  const auto square = AddActor(stage.Renderer, MakeSquare());
  const auto texture = MakeTexture();
  if (pbr)
  {
    square->GetProperty()->SetInterpolationToPBR();
    texture->UseSRGBColorSpaceOn();
    square->GetProperty()->SetBaseColorTexture(texture);
  }
  else
  {
    square->SetTexture(texture);
  }
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.);
  camera->SetPosition(0., 0., 3.);
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetClippingRange(1., 5.);
  const GLCheck gl(stage.Window);
  vtkNew<vtkRelievoMaterial> material;
  material->SetAlphaCutoff(Cutoff);
  material->Attach(square);
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(stage.Renderer);
  source->AddLayer("actor");
  source->AddLayer("albedo");
  source->Update();
  vtkPointData* layers = source->GetOutput()->GetPointData();
  vtkDataArray* actor = layers->GetArray("actor");
  vtkDataArray* albedo = layers->GetArray("albedo");
  int mismatches = 0;
  int there = 0;
  int translucent = 0;
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      const auto opaque = [](double column, double row) {
        return AlphaAt((column + 0.5) / Side, (row + 0.5) / Side) >= Cutoff;
      };
      const vtkIdType at = static_cast<vtkIdType>(y) * Side + x;
      const bool seen = actor->GetComponent(at, 0) == 0.;
      there += seen ? 1 : 0;
      translucent += seen && albedo->GetComponent(at, 3) != 255. ? 1 : 0;
      bool sure = true; // no outline within a pixel
      for (int i = 0; i < 9; ++i)
      {
        sure = sure && opaque(x + i % 3 - 1, y + i / 3 - 1) == opaque(x, y);
      }
      mismatches += sure && seen != opaque(x, y) ? 1 : 0;
    }
  }
  const std::string name = pbr ? "PBR" : "Phong";
  RELIEVO_CHECK_AT_MOST(mismatches, 0, name + ": pixels that are wrong, an outline's apart");
  RELIEVO_CHECK_AT_MOST(translucent, 0, name + ": pixels that are not opaque");
  RELIEVO_CHECK_THAT(there > Side * Side / 5 && there < Side * Side * 4 / 5, name + ": share");
  material->Detach(square);
  RELIEVO_CHECK(!square->GetForceOpaque());
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMaterialCutoff)
{
  Session session;
  TestHoles(false);
  TestHoles(true);
  return session.Result();
}
}
