// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SoftStage.h
 * @brief A stage with a sun and a lamp with sizes, whose samples are gathered frame by frame.
 */
#ifndef SoftStage_h
#define SoftStage_h

#include "Check.h"
#include "Props.h"
#include "ShadowPictures.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkImageFlip.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpaquePass.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderPassCollection.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <array>

namespace
{
using relievoTest::Picture;
using relievoTest::ShadowStage;

constexpr int Samples = 6;

struct SoftStage : ShadowStage
{
  vtkSmartPointer<vtkActor> Box;
  vtkSmartPointer<vtkLight> Sun;
  vtkSmartPointer<vtkLight> Lamp;

  // Objects added by AddSubObjects.
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkImageFlip> Image;
  vtkSmartPointer<vtkActor> Sheet;
  vtkNew<vtkCompositeDataDisplayAttributes> Blocks;
  vtkNew<vtkPolyData> Block;
  vtkNew<vtkSSAOPass> Occlusion;

  explicit SoftStage(int samples = Samples, int width = 80, int height = 60)
    : ShadowStage(width, height)
  {
    this->AddThings();
    this->Box = this->AddBox({ 1.4, 1.5, 0.8 }, { 0.6, 0.1, 0.6 });
    this->Sun = this->AddSun(-3., 4., -2.);
    this->Sun->SetIntensity(0.5);
    this->Lamp = this->AddLamp({ -1., 3., -1.5 }, { 0.3, 0., 0.3 }, 90.);
    this->Lamp->SetIntensity(0.5);
    this->GetFrame()->ShadowsOn();
    this->GetShadows()->SetMapSize(256);
    this->GetShadows()->SetSunAngle(8.);
    this->GetShadows()->SetLampRadius(0.2);
    this->GetShadows()->SetSoftSamples(samples);
  }

  // Things with settings in objects of their own, whose changes are none of the props'.
  void AddSubObjects()
  {
    this->Plane->SetOrigin(-0.9, 0., 0.);
    this->Plane->SetNormal(1., 0., 0.);
    this->Box->GetMapper()->AddClippingPlane(this->Plane);

    vtkNew<vtkImageData> halves;
    halves->SetDimensions(8, 8, 1);
    halves->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int i = 0; i < 64; ++i)
    {
      const unsigned char color[2][3] = { { 250, 200, 100 }, { 20, 60, 250 } };
      auto* texel = static_cast<unsigned char*>(halves->GetScalarPointer()) + 3 * i;
      std::copy(color[i / 32], color[i / 32] + 3, texel);
    }
    this->Image->SetInputData(halves);
    this->Image->SetFilteredAxis(0); // changes nothing

    const auto sheet = relievoTest::MakePolygons(
      { { -2., 0.1, 1. }, { -1., 0.1, 1. }, { -1., 0.1, 2. }, { -2., 0.1, 2. } });
    sheet->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    for (const auto& place :
      { std::array<double, 2>{ 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } })
    {
      places->InsertNextTuple(place.data());
    }
    sheet->GetPointData()->SetTCoords(places);
    this->Sheet = relievoTest::AddActor(this->Renderer, sheet);
    vtkNew<vtkTexture> texture;
    texture->SetInputConnection(this->Image->GetOutputPort());
    this->Sheet->SetTexture(texture);
    vtkShaderProperty* shaders = this->Sheet->GetShaderProperty();
    shaders->GetFragmentCustomUniforms()->SetUniformf("shade", 0.9f);
    shaders->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  fragOutput0.rgb *= shade;\n", false);

    vtkNew<vtkMultiBlockDataSet> blocks;
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(1.2, 0.5, 1.5);
    this->Block->SetPoints(points);
    blocks->SetBlock(0, this->Block);
    vtkNew<vtkGlyph3DMapper> glyphs;
    glyphs->SetInputDataObject(blocks);
    glyphs->SetSourceData(vtkPolyDataMapper::SafeDownCast(this->Box->GetMapper())->GetInput());
    glyphs->SetScaleFactor(0.4);
    glyphs->ScalingOn();
    glyphs->SetBlockAttributes(this->Blocks);
    vtkNew<vtkActor> glyph;
    glyph->SetMapper(glyphs);
    this->Renderer->AddActor(glyph);

    vtkNew<vtkLightsPass> lights;
    vtkNew<vtkOpaquePass> opaque;
    vtkNew<vtkRenderPassCollection> both;
    both->AddItem(lights);
    both->AddItem(opaque);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(both);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    this->Occlusion->SetDelegatePass(camera);
    this->Occlusion->SetRadius(0.8);
    this->Occlusion->SetKernelSize(16);
    vtkNew<vtkRenderPassCollection> outer;
    outer->AddItem(this->Occlusion);
    vtkNew<vtkSequencePass> delegate;
    delegate->SetPasses(outer);
    this->GetFrame()->SetDelegatePass(delegate);
  }

  vtkSmartPointer<vtkImageData> DrawAll()
  {
    vtkSmartPointer<vtkImageData> picture;
    int frames = 0;
    do
    {
      picture = Picture(this->Window);
    } while (this->GetFrame()->GetSamplesLeft() > 0 && ++frames < 100);
    RELIEVO_CHECK_THAT(frames < 100, "the gathering does not end");
    return picture;
  }
};
}

#endif
