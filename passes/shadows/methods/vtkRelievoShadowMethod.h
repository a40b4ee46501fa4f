// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A method for the visibility of lights: the views of its maps, the data derived from the maps, its
// shader section, its cost and its error. The stage does not depend on the method's name; a method
// is created once, and lives until another replaces it.
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

// Input for the expected cost and error of shadows before drawing, for choosing a method and map
// size.
struct vtkRelievoShadowDemand
{
  int MapSize = 2048; // side of a map in texels
  int Maps = 1;
  int Lights = 1; // casting lights
  int Props = 0;  // casters or receivers, with one draw call each
  int Width = 0;  // of the picture in pixels
  int Height = 0;
  double Farness = 0.0;   // largest rounded coordinate, in halves of the view's height
  double EdgeShare = 0.0; // share of pixels whose verdict differs half a pixel aside
};

struct vtkRelievoShadowEstimate
{
  vtkIdType Bytes = 0;     // of GPU memory
  int DrawCalls = 0;       // maximum, in a frame that redraws all maps
  double WrongShare = 0.0; // of the pixels that face the light, 0 to 1
};

// Wrong verdicts lie along the edges of shadows, in a band about a texel wide: their share is a
// power of the map's size n, At2048 * (n / 2048)^-Power.
struct vtkRelievoShadowErrorLaw
{
  double At2048;
  double Power;

  double GetShare(int mapSize) const;
};

// For an even map: least squares, in logarithms, of docs/charts/shadows/shadows.csv: bunny,
// motorBike and buildings, all lights and sizes, 600 x 600 pixels. Each value is within 2.5 times
// (testShadowEstimate).
constexpr vtkRelievoShadowErrorLaw vtkRelievoShadowMapLaw = { 1.92e-4, 0.91 };

class vtkRelievoShadowMethod : public vtkRelievoShadowFitter
{
public:
  // One of vtkRelievoShadowMethods.
  static std::unique_ptr<vtkRelievoShadowMethod> Make(int method);

  // Before maps are fitted: selects the casters that need no maps. Returns why this method cannot
  // make the frame's shadows, or ""; `map` then replaces it.
  virtual std::string Prepare(vtkRelievoShadowContext&, vtkRenderer*) { return std::string(); }

  // After the maps: draws the method's own data before the picture. Returns the draw calls except
  // those by mappers, which the stage's callbacks count.
  virtual int Draw(vtkRelievoShadowContext&, vtkRenderer*) { return 0; }

  // The error of Draw, or ""; the picture then uses the maps alone.
  virtual std::string GetFault() const { return std::string(); }

  // After the picture, if only drawing has changed the casters' state.
  virtual void Settle(const vtkRelievoShadowContext&) {}

  // The drawing was incomplete: discards cached data.
  virtual void Forget() {}

  // After the picture: releases texture units.
  virtual void Unbind() {}

  // The source with the section MethodDec for shaders/shadow/receive.glsl.
  virtual std::string GetShader() const = 0;

  // Whether rays decide after the maps: with the sections PlaceImpl and TraceDec, TraceImpl, or
  // FoundImpl for actors whose verdicts about this number of lights are found by Draw.
  virtual bool Traces() const { return false; }
  virtual bool Colors() const { return false; } // transmitted light has the surfaces' colours
  virtual std::vector<vtkActor*> GetFound(std::size_t /*lights*/) const { return {}; }

  // Map depth subtracted from receivers for a bias in texels, before the shader's section.
  virtual double GetBias(const vtkRelievoShadowView& view, double texels) const
  {
    return texels * view.Texel;
  }

  // The uniforms of the section, once per frame and for each actor.
  virtual void SetFrameUniforms(vtkShaderProgram*, const vtkRelievoShadowContext&) const {}
  virtual void SetActorUniforms(vtkShaderProgram*, const vtkRelievoShadowContext&, vtkActor*) const
  {
  }

  // The uniforms of the section in a volume's shader, for places that `placeToView` takes to eye
  // space.
  virtual void SetVolumeUniforms(
    vtkShaderProgram* program, const vtkRelievoShadowContext& work, const glm::dmat4&) const
  {
    this->SetFrameUniforms(program, work);
  }

  // The section for volumes' shaders: forward masks are of surfaces.
  virtual std::string GetVolumeShader() const { return this->GetShader(); }

  virtual vtkRelievoShadowEstimate Estimate(const vtkRelievoShadowDemand& demand) const = 0;

  // For the frame's report: ", WORDS".
  virtual std::string GetReport() const { return std::string(); }

  // Bytes held in addition to the maps.
  virtual vtkIdType GetBytes() const { return 0; }
  virtual void Release(vtkWindow*) {}
};

#endif
