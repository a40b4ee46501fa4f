// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoSightOfInput
 * @brief Places the camera of a new filter Visibility above its input, so that it sees all of it.
 *
 * The hint `<InitializationHelper class="vtkSMRelievoSightOfInput"/>` of a filter with the
 * properties Position, FocalPoint and ViewAngle. It looks at the middle of the input's bounds, down
 * z, from where a sphere around them fits the view angle. What was set while the filter was made
 * stays, and so does all of it for an input without bounds.
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

  /** Called by ParaView for each new filter, not for those of state files. */
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
