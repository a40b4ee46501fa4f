// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoFirstShown
 * @brief Gives a new representation a type that shows its data.
 *
 * The hint `<InitializationHelper class="vtkSMRelievoFirstShown" type="Volume"/>` of a
 * representation names the type. ParaView shows images as outlines and points as dots otherwise.
 * With `scales`, the name of a point array of three components, each point is shown as a box of
 * that size. A type that was set while the representation was made stays.
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

  /** Called by ParaView for each new representation, not for those of state files. */
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
