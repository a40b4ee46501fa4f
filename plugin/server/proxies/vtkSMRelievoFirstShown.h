// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoFirstShown
 * @brief Gives a new representation a suitable type.
 *
 * The hint `<InitializationHelper class="vtkSMRelievoFirstShown" type="Volume"/>` of a
 * representation names the type; ParaView's default shows images as outlines and points as dots.
 * With `scales`, the name of a point array of three components, each point is shown as a box of
 * that size. A type set explicitly during creation stays.
 */
#ifndef vtkSMRelievoFirstShown_h
#define vtkSMRelievoFirstShown_h

#include "vtkRelievoPluginServerModule.h" // for export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoFirstShown : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMRelievoFirstShown* New();
  vtkTypeMacro(vtkSMRelievoFirstShown, vtkSMProxyInitializationHelper);

  /** Called by ParaView for each new representation, but not for those of state files. */
  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMRelievoFirstShown() = default;
  ~vtkSMRelievoFirstShown() override = default;

private:
  vtkSMRelievoFirstShown(const vtkSMRelievoFirstShown&) = delete;
  void operator=(const vtkSMRelievoFirstShown&) = delete;
};

#endif
