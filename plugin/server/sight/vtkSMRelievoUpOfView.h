// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoUpOfView
 * @brief The up axis of data in a render view, also for new filters.
 *
 * The hint `<InitializationHelper class="vtkSMRelievoUpOfView"/>` gives a filter with the property
 * UpAxis the up axis of the active view. A value set during creation stays.
 */
#ifndef vtkSMRelievoUpOfView_h
#define vtkSMRelievoUpOfView_h

#include "vtkRelievoPluginServerModule.h" // for export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoUpOfView : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMRelievoUpOfView* New();
  vtkTypeMacro(vtkSMRelievoUpOfView, vtkSMProxyInitializationHelper);

  /** Called by ParaView for each new filter, but not for those of state files. */
  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

  /**
   * The up axis (0, 1, 2 for x, y, z) of data with these bounds: y or z if the data is low along
   * it; else the axis nearest to the camera's view up, and z without a render view.
   */
  static int FindUpAxis(vtkSMProxy* view, const double bounds[6]);

protected:
  vtkSMRelievoUpOfView() = default;
  ~vtkSMRelievoUpOfView() override = default;

private:
  vtkSMRelievoUpOfView(const vtkSMRelievoUpOfView&) = delete;
  void operator=(const vtkSMRelievoUpOfView&) = delete;
};

#endif
