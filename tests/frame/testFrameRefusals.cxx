// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a frame cannot do it says, by name, and does the rest: layers whose stage is off, colours
// where there can be none, stages that take others' places; and arrays that are called like what
// stages write for each other.
#include "Check.h"
#include "ColorStage.h"
#include "GLCheck.h"
#include "Session.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLError.h> // for OpenGL
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using relievoTest::ColorStage;
using relievoTest::Picture;

// What stages write for each other, or the frame itself has.
const std::vector<std::string> Names = { "visibility", "picture", "drawn", "shadow maps" };

// A square that fills the window, with arrays that have those names, of values 1, 2 ...
struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  Scene()
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-2.0, -2.0, 0.0);
    plane->SetPoint1(2.0, -2.0, 0.0);
    plane->SetPoint2(-2.0, 2.0, 0.0);
    plane->Update();
    vtkPolyData* data = plane->GetOutput();
    for (std::size_t i = 0; i < Names.size(); ++i)
    {
      vtkNew<vtkFloatArray> array;
      array->SetName(Names[i].c_str());
      array->SetNumberOfTuples(data->GetNumberOfPoints());
      array->Fill(1.0 + static_cast<double>(i));
      data->GetPointData()->AddArray(array);
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.8, 0.6, 0.4);
    this->Renderer->AddActor(actor);
    vtkNew<vtkLight> sun;
    sun->SetPosition(1.0, 0.5, 2.0);
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(sun);
    this->Window = relievoTest::MakeWindow(60, 50, this->Renderer);
    this->Renderer->ResetCamera(-1.0, 1.0, -1.0, 1.0, 0.0, 0.0);
  }
};

bool IsSame(vtkImageData* a, vtkImageData* b)
{
  return std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), 3 * a->GetNumberOfPoints()) == 0;
}

std::string Pixels(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, 59, 49, 0, bytes);
  return std::string(reinterpret_cast<char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
}

double Middle(vtkImageData* image, const std::string& name)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
  return RELIEVO_CHECK_THAT(array, name) ? array->GetComponent(25 * 60 + 30, 0) : -1.0;
}

void TestArrays()
{
  Scene scene;
  relievoTest::GLCheck gl(scene.Window);
  scene.Window->SetSwapBuffers(false);
  const auto plain = Picture(scene.Window);
  const std::string pixels = Pixels(scene.Window);
  scene.Renderer->SetBackground(0.3, 0.7, 0.1); // the next picture would be another
  for (const bool shadows : { false, true })
  {
    for (const bool hdr : { false, true })
    {
      vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
      frame->SetShadows(shadows);
      vtkNew<vtkRelievoLayerSource> layers;
      layers->SetRenderer(scene.Renderer);
      for (const std::string& name : Names)
      {
        layers->AddLayer(name);
      }
      if (hdr)
      {
        layers->AddLayer("color");
        layers->HDROn();
      }
      layers->Update();
      for (std::size_t i = 0; i < Names.size(); ++i)
      {
        RELIEVO_CHECK_NEAR(
          Middle(layers->GetOutput(), Names[i]), 1.0 + static_cast<double>(i), 1e-6, Names[i]);
      }
      if (hdr)
      {
        RELIEVO_CHECK(Middle(layers->GetOutput(), "color") > 0.1);
      }
      RELIEVO_CHECK_THAT(Pixels(scene.Window) == pixels, "the window has changed");
      vtkRelievoPass::Detach(scene.Renderer);
    }
  }
  // As the picture, and beneath it: an array of one value is of one colour, another's of another.
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->SetDisplayRange(0.0, 5.0);
  std::vector<vtkSmartPointer<vtkImageData>> shown;
  for (const std::string& name : Names)
  {
    frame->SetDisplayLayer(name.c_str());
    shown.push_back(Picture(scene.Window));
    RELIEVO_CHECK_THAT(frame->GetStage("display")->GetReasonCode() == "ran",
      name + ": " + frame->GetStage("display")->GetReason());
    RELIEVO_CHECK_THAT(!IsSame(plain, shown.back()), name + " is not shown");
    RELIEVO_CHECK_THAT(shown.size() < 2 || !IsSame(shown.front(), shown.back()), name);
  }
  frame->SetDisplayLayer(nullptr);
  // Beside a stage on the colour.
  vtkNew<ColorStage> stage;
  frame->AddStage(stage);
  frame->RequestLayer("drawn");
  frame->RequestLayer("picture");
  const auto through = Picture(scene.Window);
  frame->ReleaseLayers();
  RELIEVO_CHECK(IsSame(through, Picture(scene.Window)));
  RELIEVO_CHECK(stage->Executed == 2);
  gl.Poll("arrays");
}

// Layers whose stages are off: said when they are read or shown; others are made.
void TestOff()
{
  Scene scene;
  const auto plain = Picture(scene.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->GetShadowPass()->EnabledOff();
  frame->RequestLayer("shadow_0");
  frame->RequestLayer("depth");
  scene.Window->Render();
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(frame->ReadLayer("depth", image));
  {
    relievoTest::ExpectMessage expect("needs 'visibility', which the stage shadows would write");
    RELIEVO_CHECK(!frame->ReadLayer("shadow_0", image));
    RELIEVO_CHECK(!frame->ReadLayers({ "depth", "shadow_0" }, image));
    RELIEVO_CHECK(expect.Count() == 2);
  }
  frame->GetShadowPass()->EnabledOn();
  scene.Window->Render();
  RELIEVO_CHECK(frame->ReadLayer("shadow_0", image));

  frame->GetStage("gbuffer")->EnabledOff();
  {
    relievoTest::ExpectMessage expect("The stage display does not run: it reads 'depth', which the "
                                      "stage gbuffer would write, but does not run: switched off");
    frame->SetDisplayLayer("depth");
    RELIEVO_CHECK(IsSame(plain, Picture(scene.Window)));
    RELIEVO_CHECK(expect.Count() == 1);
    RELIEVO_CHECK(frame->GetStage("display")->GetReasonCode() == "refused");
  }
  {
    relievoTest::ExpectMessage expect("the stage gbuffer would write, but does not run: switched");
    RELIEVO_CHECK(!frame->ReadLayer("depth", image));
    RELIEVO_CHECK(expect.Count() == 1);
  }
}

// A stage that blends a grey onto the colour, and does not read it.
class Adder : public ColorStage
{
public:
  static Adder* New() { VTK_STANDARD_NEW_BODY(Adder); }
  vtkTypeMacro(Adder, ColorStage);

  int Prepared = 0;
  int Finished = 0;

protected:
  void Describe(vtkRelievoStageDescription& description) override
  {
    description.Name = this->Name;
    description.Help = "Adds to the colour.";
    description.Slot = this->Slot;
    description.Writes = { "color" };
  }
  bool Prepare(vtkRelievoFrameContext&) override
  {
    ++this->Prepared;
    return true;
  }
  void Finish(vtkRelievoFrameContext&) override { ++this->Finished; }
  void Execute(vtkRelievoFrameContext& context) override
  {
    static const bool added = vtkRelievoShaderLibrary::Add("test/greyFS.glsl",
      "//VTK::System::Dec\n//RELIEVO::Defines\n//VTK::Output::Dec\nin vec2 texCoord;\n"
      "void main() { gl_FragData[0] = vec4(vec3(0.25), 0.0); }\n");
    if (added && this->AddQuad.Ready(context, "test/greyFS.glsl", {}))
    {
      vtkOpenGLState* state = context.Window->GetState();
      vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
      vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
      this->Executed += context.DrawColor(this->AddQuad, false) ? 1 : 0;
    }
  }

private:
  vtkRelievoScreenQuad AddQuad;
};

std::vector<double> ReadMiddle(vtkRelievoPass* frame)
{
  vtkNew<vtkImageData> image;
  if (!RELIEVO_CHECK(frame->ReadLayer("color", image)))
  {
    return std::vector<double>(4, -1.0);
  }
  vtkDataArray* color = image->GetPointData()->GetArray("color");
  std::vector<double> values(4);
  color->GetTuple(25 * 60 + 30, values.data());
  return values;
}

void TestAdder()
{
  for (const int slot :
    { vtkRelievoStageDescription::SHADE, vtkRelievoStageDescription::COMPOSITE })
  {
    for (const bool changer : { false, true })
    {
      Scene scene;
      relievoTest::GLCheck gl(scene.Window);
      vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
      frame->RequestLayer("color");
      scene.Window->Render();
      const std::vector<double> before = ReadMiddle(frame);
      frame->ReleaseLayers();
      vtkNew<Adder> adder;
      adder->Name = "grey";
      adder->Slot = slot;
      frame->AddStage(adder);
      vtkNew<ColorStage> twice;
      twice->Factor = 2.0;
      twice->Slot = vtkRelievoStageDescription::SHADE;
      if (changer)
      {
        frame->AddStage(twice);
      }
      scene.Window->Render();
      RELIEVO_CHECK_THAT(adder->Executed == 1, adder->GetReason());
      RELIEVO_CHECK_THAT(twice->Executed == (changer ? 1 : 0), twice->GetReason());
      const std::vector<double> after = ReadMiddle(frame);
      // In the slot of shading "grey" comes before "shift".
      const bool added = slot == vtkRelievoStageDescription::SHADE;
      for (int c = 0; c < 3; ++c)
      {
        const double expected = !changer ? before[c] + 0.25
          : added                        ? 2.0 * (before[c] + 0.25)
                                         : 2.0 * before[c] + 0.25;
        RELIEVO_CHECK_NEAR(after[c], expected, 2e-3 * expected, "component " + std::to_string(c));
      }
      gl.Poll("adder");
    }
  }
}

// Where there can be no linear colour: nothing is prepared for it, and who asks is told.
void TestNoColor()
{
  Scene scene;
  vtkNew<vtkRenderer> over;
  over->SetLayer(1);
  scene.Window->SetNumberOfLayers(2);
  scene.Window->AddRenderer(over);
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  over->AddActor(actor);
  over->ResetCamera();
  for (const bool erase : { true, false })
  {
    over->SetErase(erase);
    over->SetPreserveDepthBuffer(erase);
    const auto plain = Picture(scene.Window);
    vtkRelievoPass* frame = vtkRelievoPass::Attach(over);
    vtkNew<Adder> adder;
    adder->Name = "grey";
    frame->AddStage(adder);
    vtkNew<ColorStage> off;
    off->EnabledOff();
    frame->AddStage(off);
    frame->RequestLayer("color");
    RELIEVO_CHECK(IsSame(plain, Picture(scene.Window)));
    RELIEVO_CHECK(adder->GetReasonCode() == "refused" && off->GetReasonCode() == "off");
    const char* why = erase ? "PreserveDepthBuffer" : "EraseOff";
    RELIEVO_CHECK(adder->GetReason().find(why) != std::string::npos);
    RELIEVO_CHECK(adder->Prepared == 0 && adder->Finished == 0 && adder->Executed == 0);
    vtkNew<vtkImageData> image;
    {
      relievoTest::ExpectMessage expect(why);
      RELIEVO_CHECK(!frame->ReadLayer("color", image));
      RELIEVO_CHECK(expect.Count() == 1);
    }
    // Alone, as layers are, it has one.
    frame->LayersOnlyOn();
    scene.Window->Render();
    RELIEVO_CHECK(frame->ReadLayer("color", image));
    vtkRelievoPass::Detach(over);
  }
}

// Own stages under the names of Relievo's: what is set by short ways says that it is not.
void TestReplaced()
{
  Scene scene;
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->ShadowsOn();
  scene.Window->Render();
  vtkRelievoShadowPass* shadows = frame->GetShadowPass();
  frame->RequestLayer("depth");
  scene.Window->Render();
  RELIEVO_CHECK(shadows->GetBytesHeld() > 0);
  vtkNew<ColorStage> own[3];
  const char* const names[3] = { "display", "shadows", "gbuffer" };
  for (int i = 0; i < 3; ++i)
  {
    own[i]->Name = names[i];
    frame->AddStage(own[i]);
    RELIEVO_CHECK_THAT(frame->GetStage(names[i]) == own[i], names[i]);
  }
  RELIEVO_CHECK_THAT(shadows->GetBytesHeld() == 0, "a stage that is replaced holds memory");
  RELIEVO_CHECK(!frame->GetShadowPass() && !frame->GetGBuffer());
  std::ostringstream out;
  frame->Print(out);
  RELIEVO_CHECK(out.str().find("DisplayLayer: (none)") != std::string::npos);
  {
    relievoTest::ExpectMessage expect("is not Relievo's own");
    frame->ShadowsOn();
    frame->SetDisplayLayer("depth");
    frame->SetDisplayRange(0.0, 1.0);
    frame->DisplayGreyOn();
    RELIEVO_CHECK(expect.Count() == 4);
  }
  RELIEVO_CHECK(!frame->GetShadows() && !frame->GetDisplayLayer() && !frame->GetDisplayGrey());
  vtkNew<vtkImageData> image;
  {
    relievoTest::ExpectMessage expect("'depth'");
    RELIEVO_CHECK(!frame->ReadLayer("depth", image)); // its stage has gone
    RELIEVO_CHECK(expect.Count() == 1);
  }
  frame->RemoveStage(own[2]);
  vtkNew<vtkRelievoLayerSource> layers;
  layers->SetRenderer(scene.Renderer);
  layers->AddLayer("depth");
  layers->Update();
  RELIEVO_CHECK(layers->GetOutput()->GetPointData()->GetArray("depth"));
  // A name that an added stage has is not there for another one.
  {
    relievoTest::ExpectMessage expect("a second stage 'display'");
    vtkNew<ColorStage> again;
    again->Name = "display";
    frame->AddStage(again);
    RELIEVO_CHECK(expect.Count() == 1);
    RELIEVO_CHECK(frame->GetStage("display") == own[0]);
  }
}
}

int main()
{
  relievoTest::Session session;
  TestArrays();
  TestOff();
  TestAdder();
  TestNoColor();
  TestReplaced();
  return session.Result();
}
