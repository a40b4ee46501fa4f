// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps of lamps from data that cast shadows: like those of positional lights with the method
// `map`, fitted to each lamp's reach, and cached while lamp, casters and view stay.
#ifndef vtkRelievoLampMaps_h
#define vtkRelievoLampMaps_h

#include "vtkRelievoLampShadows.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowMethodMap.h"
#include "vtkRelievoShadowSchedule.h"

#include <string>
#include <vector>

class vtkRelievoFrameContext;
class vtkWindow;

class vtkRelievoLampMaps : public vtkRelievoLampShadows
{
public:
  explicit vtkRelievoLampMaps(vtkRelievoShadowCasters& casters)
    : Work(casters)
  {
    this->Work.OnEverything = true;
  }

  vtkRelievoShadowContext Work;
  vtkRelievoShadowSchedule Schedule;

  // Draws the missing maps of the context's casting lamps, and binds them until Unbind. Returns an
  // error, or "". strength: share of a blocked light that is removed.
  std::string Draw(vtkRelievoFrameContext& context, int size, int radius, double strength);
  int GetDrawCalls() const { return this->DrawCalls; }

  // In the last frame: the casting lamps and their maps, as a sentence.
  std::string GetReport() const;

  void Unbind() { this->Work.Maps.Unbind(); }
  void Release(vtkWindow* window);

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override {}
  void SetLamp(vtkShaderProgram* program, int lamp) override;

private:
  vtkRelievoShadowMethodMap Method;
  std::vector<double> Strengths; // of the context's lamps
  int DrawCalls = 0;
};

#endif
