// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How it is found out what a light reaches: the views that its maps are drawn from, what is made of
// the maps, the shaders' part of it, and what it costs and errs. The stage knows no method by name;
// a method is made once, and lives until another takes its place.
#ifndef vtkRelievoShadowMethod_h
#define vtkRelievoShadowMethod_h

#include "vtkRelievoShadowFitter.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;
struct vtkRelievoShadowLight;
struct vtkRelievoShadowContext;

// What shadows are expected to cost and to err, before anything is drawn: for whoever chooses a
// method and the size of its maps.
struct vtkRelievoShadowDemand
{
  int MapSize = 2048; // side of a map in texels
  int Maps = 1;
  int Lights = 1; // that cast
  int Props = 0;  // that cast or receive, with one draw call each
  int Width = 0;  // of the picture in pixels
  int Height = 0;
  double Farness = 0.0;   // the largest coordinate that is rounded, in halves of the view's height
  double EdgeShare = 0.0; // of the pixels, whose verdict is another half a pixel aside
};

struct vtkRelievoShadowEstimate
{
  vtkIdType Bytes = 0;     // held on the GPU
  int DrawCalls = 0;       // at most, in a frame that draws all maps anew
  double WrongShare = 0.0; // of the pixels that face the light, 0 to 1
};

// Wrong verdicts lie along the edges of shadows, in a band about a texel wide: their share falls as
// a power of the map's size n, At2048 * (n / 2048)^-Power.
struct vtkRelievoShadowErrorLaw
{
  double At2048;
  double Power;

  double GetShare(int mapSize) const;
};

// Of an evenly spaced map: least squares, in logarithms, of docs/charts/shadows.csv: bunny,
// motorBike and buildings, all lights and sizes, 600 x 600 pixels. Each value is within 2.5 times
// (testShadowEstimate).
constexpr vtkRelievoShadowErrorLaw vtkRelievoShadowMapLaw = { 1.92e-4, 0.91 };

class vtkRelievoShadowMethod : public vtkRelievoShadowFitter
{
public:
  // One of vtkRelievoShadowMethods.
  static std::unique_ptr<vtkRelievoShadowMethod> Make(int method);

  // Before maps are fitted: takes the casters that need none. Returns why the frame's shadows
  // cannot be made this way, in words; `map` makes them then.
  virtual std::string Prepare(vtkRelievoShadowContext&, vtkRenderer*) { return std::string(); }

  // After the maps were drawn: what else is drawn before the picture. Returns the draw calls; what
  // mappers draw through the stage's callbacks is counted there.
  virtual int Draw(vtkRelievoShadowContext&, vtkRenderer*) { return 0; }

  // What Draw could not do, in words; the picture is as the maps alone make it then.
  virtual std::string GetFault() const { return std::string(); }

  // After the picture, if drawing has changed what the casters' state says: nothing moved.
  virtual void Settle(const vtkRelievoShadowContext&) {}

  // What was drawn was not all of it: nothing of it is kept.
  virtual void Forget() {}

  // After the picture: texture units are given back.
  virtual void Unbind() {}

  // The source with the section MethodDec that shaders/shadow/receive.glsl asks for.
  virtual std::string GetShader() const = 0;

  // Whether rays decide, after what the maps say: the sections PlaceImpl and TraceDec, TraceImpl,
  // or FoundImpl for actors whose verdicts about so many lights are found by Draw.
  virtual bool Traces() const { return false; }
  virtual bool Colors() const { return false; } // what passes surfaces has their colours
  virtual std::vector<vtkActor*> GetFound(std::size_t /*lights*/) const { return {}; }

  // Depth of a map that is taken off receivers for a bias in texels, before the shader's section.
  virtual double GetBias(const vtkRelievoShadowView& view, double texels) const
  {
    return texels * view.Texel;
  }

  // The uniforms of the section, once in a frame and for each actor.
  virtual void SetFrameUniforms(vtkShaderProgram*, const vtkRelievoShadowContext&) const {}
  virtual void SetActorUniforms(vtkShaderProgram*, const vtkRelievoShadowContext&, vtkActor*) const
  {
  }

  virtual vtkRelievoShadowEstimate Estimate(const vtkRelievoShadowDemand& demand) const = 0;

  // For the frame's report: ", WORDS".
  virtual std::string GetReport() const { return std::string(); }

  // What is held beside the maps.
  virtual vtkIdType GetBytes() const { return 0; }
  virtual void Release(vtkWindow*) {}
};

#endif
