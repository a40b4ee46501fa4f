// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shadows of a renderer's lights in a frame: the set or planned method, its maps, and the data
// that it draws beside them. Lamps from data have vtkRelievoLampMaps.
#ifndef vtkRelievoLightMaps_h
#define vtkRelievoLightMaps_h

#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowMethods.h"
#include "vtkRelievoShadowPlanning.h"
#include "vtkRelievoShadowSchedule.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRelievoFrameContext;
class vtkRelievoLightSizes;
class vtkRelievoMessagesOnce;
class vtkRelievoShadowLights;
class vtkWindow;

class vtkRelievoLightMaps
{
public:
  using Settings = vtkRelievoShadowPlanning::Settings;

  explicit vtkRelievoLightMaps(vtkRelievoShadowCasters& casters)
    : Work(casters)
  {
  }

  vtkRelievoShadowContext Work;
  vtkRelievoShadowSchedule Schedule;
  vtkRelievoShadowPlanning Planning;

  ///@{
  // Fits the maps of the casting lights, as planned, and assigns a texture unit. Returns why there
  // are none, or "". `MakeNone`: no light casts.
  std::string Make(vtkRelievoFrameContext& context, const vtkRelievoShadowLights& lights,
    const Settings& settings, vtkRelievoMessagesOnce& messages);
  void MakeNone(vtkOpenGLRenderWindow* window);
  ///@}

  // The shade of volumes towards these lights, each moved to one of `samples` places of its shape.
  // `asked`: whether a layer has it even if nothing receives. Returns why there is none, or "".
  std::string MakeShade(vtkOpenGLRenderWindow* window, const Settings& settings,
    const vtkRelievoLightSizes& sizes, int samples, bool asked);

  // The size of maps in this OpenGL: its limit if that is less, with a warning.
  static int GetSizeHere(int size, vtkRelievoMessagesOnce& messages);

  // Whether the shaders of receivers must differ from the previous frame's. `unlit`: visibility is
  // requested also where no light is computed. `direct`: the share of the casting lights is.
  bool UpdateStructure(
    vtkOpenGLRenderWindow* window, const vtkRelievoShadowLights& lights, bool unlit, bool direct);

  ///@{
  // Draws the missing maps and binds all; then draws the method's own data. Both return the draw
  // calls except those by mappers, which the stage's callbacks count. `Unbind` releases the texture
  // units.
  int DrawMaps(vtkRenderer* renderer);
  int DrawMethod(vtkRenderer* renderer);
  void Unbind();
  ///@}

  ///@{
  // For mappers that mark themselves as modified when they draw. Settle accepts the casters,
  // collected again after the drawing, as unchanged; `known`: GetKnown before that, whether the
  // plan's probe knew the casters, and whether a method was refused for them.
  struct Known
  {
    bool Probed;
    bool Refused;
  };
  Known GetKnown();
  void Settle(const Known& known);
  ///@}

  // The drawing was incomplete: discards cached data.
  void Invalidate();

  const std::unique_ptr<vtkRelievoShadowMethod>& GetMethod() const { return this->Method; }
  int GetMethodMade() const { return this->Made; } // one of vtkRelievoShadowMethods

  // The input of the plan.
  vtkRelievoShadowPlanning::Scene GetScene(const vtkRelievoShadowLights& lights);

  // The expected share of wrong pixels for the frame's maps.
  double GetExpectedWrongShare() const;

  // A clause about the last frame, for the frame report.
  std::string GetReport() const;

  vtkIdType GetBytes() const
  {
    return this->Work.Maps.GetBytes() + this->Work.Shade.GetBytes() + this->Method->GetBytes();
  }
  void Release(vtkWindow* window);

private:
  void UpdateNearest(vtkOpenGLRenderWindow* window);
  void UseMethod(int method, vtkOpenGLRenderWindow* window); // the context is current
  void PrepareMethod(vtkRelievoFrameContext& context, vtkRelievoMessagesOnce& messages);
  bool IsRefused(int method) const;
  void Refuse(int method);

  std::unique_ptr<vtkRelievoShadowMethod> Method =
    vtkRelievoShadowMethod::Make(vtkRelievoShadowMethods::MAP);
  int Made = vtkRelievoShadowMethods::MAP;
  int Refused = -1; // method that could not make shadows of the casters
  std::vector<std::uint64_t> RefusedCasters;
};

#endif
