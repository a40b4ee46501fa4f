// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Assemblies with parts that write no layers (hidden ones, actors without a mapper, texts, images,
// axes): their meshes are in the layers as they are without these parts, the picture stays.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkAssembly.h>
#include <vtkAxesActor.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPropAssembly.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkTextActor3D.h>

namespace testMixedAssemblies
{
namespace
{
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;

const std::vector<std::string> Names = { "depth", "normal", "albedo", "cell" };

vtkSmartPointer<vtkActor> MakePart(double x)
{
  auto part = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkRenderer> none;
  part->ShallowCopy(relievoTest::AddActor(none, relievoTest::MakeBall(0.5)));
  part->SetPosition(x, 0.7, 0.);
  part->GetProperty()->SetColor(0.9, 0.4, 0.2);
  return part;
}

vtkSmartPointer<vtkProp> MakeHidden()
{
  const auto part = MakePart(2.);
  part->VisibilityOff();
  return vtkSmartPointer<vtkProp>(part.Get());
}

vtkSmartPointer<vtkProp> MakeWithoutMapper()
{
  return vtkSmartPointer<vtkActor>::New();
}

vtkSmartPointer<vtkProp> MakeText()
{
  vtkNew<vtkTextActor3D> text;
  text->SetInput("3D");
  text->SetScale(0.02);
  text->SetPosition(-0.6, 0.8, 0.9);
  return vtkSmartPointer<vtkProp>(text.Get());
}

vtkSmartPointer<vtkProp> MakeImage()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(-0.3, 0.3, 0.8);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 192; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = static_cast<unsigned char>(i);
  }
  vtkNew<vtkImageActor> actor;
  actor->SetInputData(image);
  return vtkSmartPointer<vtkProp>(actor.Get());
}

vtkSmartPointer<vtkProp> MakeAxes()
{
  vtkNew<vtkAxesActor> axes;
  axes->AxisLabelsOff();
  return vtkSmartPointer<vtkProp>(axes.Get());
}

struct Case
{
  const char* Name;
  vtkSmartPointer<vtkProp> (*Make)();
  bool Shares; // it draws nothing that is opaque
};

const Case Cases[] = {
  { "a hidden part", MakeHidden, true },
  { "an actor without a mapper", MakeWithoutMapper, true },
  { "a text", MakeText, false },
  { "an image", MakeImage, false },
  { "axes", MakeAxes, false },
};

// The two meshes with the other part before, between or behind them, in an assembly of the kind.
vtkSmartPointer<vtkProp> Assemble(bool plain, int place, vtkProp* other)
{
  std::vector<vtkSmartPointer<vtkProp>> parts;
  parts.emplace_back(MakePart(-0.8));
  parts.emplace_back(MakePart(0.8));
  if (other)
  {
    parts.insert(parts.begin() + place, other);
  }
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkPropAssembly> props;
  for (const auto& part : parts)
  {
    plain ? props->AddPart(part) : assembly->AddPart(vtkProp3D::SafeDownCast(part));
  }
  assembly->RotateY(20.);
  return plain ? vtkSmartPointer<vtkProp>(props.Get()) : vtkSmartPointer<vtkProp>(assembly.Get());
}

void Test(const Case& c, bool plain, int place)
{
  const std::string what = std::string(plain ? "vtkPropAssembly" : "vtkAssembly") + " with " +
    c.Name + ", " + std::to_string(place);
  const Stage bare(200, 140);
  bare.Renderer->AddViewProp(Assemble(plain, 0, nullptr));
  const Layers expected(bare.Renderer, Names);
  RELIEVO_CHECK_THAT(expected.Covered() > 1000, what + ": too little is seen");
  const Stage stage(200, 140);
  const auto prop = Assemble(plain, place, c.Make());
  stage.Renderer->AddViewProp(prop);
  const auto before = Picture(stage.Window);
  const relievoTest::GLCheck gl(stage.Window);
  const Layers alone(stage.Renderer, Names);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  for (const std::string& name : Names)
  {
    frame->RequestLayer(name);
  }
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", with layers");
  RELIEVO_CHECK_THAT(frame->GetLayersStage()->GetShared() == c.Shares,
    what + ": not made as expected: " + frame->GetFrameReport());
  vtkNew<vtkImageData> image;
  for (const std::string& name : Names)
  {
    RELIEVO_CHECK(frame->ReadLayer(name, image));
  }
  const Layers beside(image);
  for (const std::string& name : Names)
  {
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(expected, alone, name), 0,
      what + ": pixels of " + name + " without the picture");
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(expected, beside, name), 0,
      what + ": pixels of " + name + " beside the picture");
  }
  vtkRelievoPass::Detach(stage.Renderer);
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", detached");
}

// An actor without a mapper draws nothing: others' layers are written while the picture is.
void TestLone()
{
  const Stage stage(200, 140);
  stage.Renderer->AddActor(MakePart(0.));
  stage.Renderer->AddActor(vtkNew<vtkActor>());
  const Layers layers(stage.Renderer, Names, relievoTest::Way::Shared);
  RELIEVO_CHECK(layers.Covered() > 1000);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMixedAssemblies)
{
  relievoTest::Session session;
  for (const Case& c : Cases)
  {
    for (int place = 0; place < 3; ++place)
    {
      Test(c, true, place);
      // vtkAssembly accepts only actors for drawing.
      if (vtkProp3D::SafeDownCast(c.Make()))
      {
        Test(c, false, place);
      }
    }
  }
  TestLone();
  return session.Result();
}
}
