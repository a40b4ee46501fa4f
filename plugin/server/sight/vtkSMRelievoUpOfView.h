// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoUpOfView
 * @brief Which axis of the data points up in a render view, also for new filters.
 *
 * The hint `<InitializationHelper class="vtkSMRelievoUpOfView"/>` of a filter with the property
 * UpAxis gives it that of the active view. What was set while the filter was made stays.
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

  /** Called by ParaView for each new filter, not for those of state files. */
  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

  /**
   * The axis (0, 1, 2 for x, y, z) that points up for data in these bounds: that which it is low
   * along, y or z; else the nearest to the view up of the camera, and z without a render view.
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
