// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A frame reports each failure by name, and does the rest: layers whose stage is off,
// colours where none is possible, stages that replace others.
#include "Check.h"
#include "ColorStage.h"
#include "GLCheck.h"
#include "NamedSquare.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkOpenGLError.h> // for OpenGL
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoTextureRoom.h>

#include <sstream>
#include <string>
#include <vector>

namespace testFrameRefusals
{
namespace
{
using relievoTest::ColorStage;
using relievoTest::IsSame;
using relievoTest::Picture;
using Scene = relievoTest::NamedSquare;

// Layers whose stages are off: said when they are read or shown; others are made.
void TestOff()
{
  Scene scene;
  const auto plain = Picture(scene.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->GetStage("light_depth")->EnabledOff();
  frame->RequestLayer("light_depth");
  frame->RequestLayer("shadow_0"); // whose stage serves when it is off
  frame->RequestLayer("depth");
  scene.Window->Render();
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(!frame->GetShadowStage()->GetEnabled());
  RELIEVO_CHECK(frame->ReadLayers({ "depth", "shadow_0" }, image));
  {
    relievoTest::ExpectMessage expect("which the stage light_depth would write");
    RELIEVO_CHECK(!frame->ReadLayer("light_depth", image));
    RELIEVO_CHECK(!frame->ReadLayers({ "depth", "light_depth" }, image));
    RELIEVO_CHECK(expect.Count() == 2);
  }
  frame->GetStage("light_depth")->EnabledOn();
  scene.Window->Render();
  RELIEVO_CHECK(frame->ReadLayer("light_depth", image));

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
    description.Writes = { vtkRelievoResources::Color };
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
      "void main() { gl_FragData[0] = vec4(vec3(0.25 * step(-1.0, texCoord.x)), 0.0); }\n");
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

// Custom stages under the names of Relievo's: shortcut methods report that they have no effect.
void TestReplaced()
{
  Scene scene;
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->ShadowsOn();
  scene.Window->Render();
  vtkRelievoShadowStage* shadows = frame->GetShadowStage();
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
  RELIEVO_CHECK(!frame->GetShadowStage() && !frame->GetLayersStage());
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

// Textures that OpenGL does not make are known before it refuses them, and those that it makes.
void TestTextures()
{
  Scene scene;
  scene.Window->Render();
  const auto ask = [](int width, int height) {
    return vtkRelievoFindTextureFault(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, width, height);
  };
  RELIEVO_CHECK(ask(64, 32).empty());
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  for (const int width : { most, 2 * most })
  {
    const std::string fault = ask(width, most);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(
      GL_TEXTURE_2D, 0, GL_RGBA32UI, width, most, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
    RELIEVO_CHECK_THAT(
      (glGetError() != GL_NO_ERROR) == !fault.empty(), "OpenGL's answer: " + fault);
    glDeleteTextures(1, &texture);
    const std::string before = "the largest of this shape is ";
    const std::size_t at = fault.find(before);
    if (at != std::string::npos)
    {
      int size[2] = { 0, 0 };
      char x = 0;
      std::istringstream(fault.substr(at + before.size())) >> size[0] >> x >> size[1];
      RELIEVO_CHECK_THAT(size[1] > most / 8 && ask(size[0], size[1]).empty(), fault);
    }
  }
}
}

RELIEVO_TEST_CASE(testFrameRefusals)
{
  relievoTest::Session session;
  TestOff();
  TestAdder();
  TestNoColor();
  TestReplaced();
  TestTextures();
  return session.Result();
}
}
