// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoSightOfInput
 * @brief Places the camera of a new filter Visibility above its input, with all of it in view, and
 * the observer of a new Viewshed at the middle of its terrain.
 *
 * The hint `<InitializationHelper class="vtkSMRelievoSightOfInput"/>` applies to a filter with the
 * properties Position, FocalPoint and ViewAngle, or Observers. The camera looks down z at the
 * centre of the input's bounds, from a distance where their bounding sphere fits the view angle;
 * the observer is 2 above the terrain there. Values set during creation stay; for an input without
 * bounds, all do.
 */
#ifndef vtkSMRelievoSightOfInput_h
#define vtkSMRelievoSightOfInput_h

#include "vtkRelievoPluginServerModule.h" // for export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoSightOfInput : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMRelievoSightOfInput* New();
  vtkTypeMacro(vtkSMRelievoSightOfInput, vtkSMProxyInitializationHelper);

  /** Called by ParaView for each new filter, but not for those of state files. */
  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMRelievoSightOfInput() = default;
  ~vtkSMRelievoSightOfInput() override = default;

private:
  vtkSMRelievoSightOfInput(const vtkSMRelievoSightOfInput&) = delete;
  void operator=(const vtkSMRelievoSightOfInput&) = delete;
};

#endif
