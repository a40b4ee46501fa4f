// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stages of the frame as properties of a view: by name, whatever stages there are.
#include "vtkPVRelievoView.h"

#include "vtkMultiProcessController.h"
#include "vtkPVRelievoFog.h"
#include "vtkPVRelievoLamps.h"
#include "vtkPVRelievoMarkers.h"
#include "vtkPVRelievoSelection.h"
#include "vtkPVRelievoWithin.h"
#include "vtkPVView.h"
#include "vtkRelievoFogStage.h"
#include "vtkRelievoLampsStage.h"
#include "vtkRelievoMarkersStage.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

#include <string>
#include <vector>

namespace
{
// Sets a parameter by `set`, which says what is wrong.
template <typename Set>
void SetParameter(vtkPVRelievoView* view, const std::string& word, Set set)
{
  const std::size_t colon = word.find(':');
  vtkRelievoStage* stage = view->GetFrame()->GetStage(word.substr(0, colon));
  const vtkRelievoParameter* parameter = stage && colon != std::string::npos
    ? stage->GetDescription().Find(word.substr(colon + 1))
    : nullptr;
  const std::string wrong = parameter ? set(*parameter) : "there is no such parameter here";
  if (!wrong.empty() && vtkPVRelievoSpeaks())
  {
    vtkWarningWithObjectMacro(view, << word << ": " << wrong << ".");
  }
}
}

//------------------------------------------------------------------------------
bool vtkPVRelievoView::IsAnyStageOn()
{
  vtkRelievoPass* frame = this->GetFrame();
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = frame->GetStage(i);
    if (stage->GetEnabled() && !stage->GetDescription().OnByDefault)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageOn(const char* name, bool on)
{
  if (vtkRelievoStage* stage = this->GetFrame()->GetStage(name))
  {
    stage->SetEnabled(on);
  }
  else if (on && vtkPVRelievoSpeaks()) // all that are off are told of, too, when a view is made
  {
    vtkWarningMacro(<< name << ": there is no such stage here.");
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageValue(const char* parameter, double value)
{
  SetParameter(
    this, parameter, [value](const vtkRelievoParameter& found) { return found.Set({ value }); });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageValue(
  const char* parameter, double first, double second, double third)
{
  SetParameter(this, parameter, [first, second, third](const vtkRelievoParameter& found) {
    return found.Set({ first, second, third });
  });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageText(const char* parameter, const char* text)
{
  const std::string words = text ? text : "";
  SetParameter(
    this, parameter, [&words](const vtkRelievoParameter& found) { return found.Parse(words); });
}

//------------------------------------------------------------------------------
// Representations' points, to the stages that take them: of all processes that draw together.
void vtkPVRelievoView::GivePoints(vtkPVView* view, vtkMultiProcessController* controller)
{
  vtkRelievoPass* frame = this->GetFrame();
  vtkPVRelievoLamps::Prepare(
    view, vtkRelievoLampsStage::SafeDownCast(frame->GetStage("lamps")), controller);
  vtkPVRelievoFog::Prepare(
    view, vtkRelievoFogStage::SafeDownCast(frame->GetStage("fog")), controller);
  vtkPVRelievoMarkers::Prepare(view, this->GetSelection(),
    vtkRelievoMarkersStage::SafeDownCast(frame->GetStage("markers")), controller);
}
