// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoViewProxy
 * @brief Proxy of vtkPVRelievoView, a sub-proxy of a render view's.
 *
 * Tells its object, on every process, which view it belongs to. Takes the frame report from the
 * server when that draws the view's pictures, else from this process.
 */
#ifndef vtkSMRelievoViewProxy_h
#define vtkSMRelievoViewProxy_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMProxy.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoViewProxy : public vtkSMProxy
{
public:
  static vtkSMRelievoViewProxy* New();
  vtkTypeMacro(vtkSMRelievoViewProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMRelievoViewProxy() = default;
  ~vtkSMRelievoViewProxy() override = default;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

  bool KnowsView = false;

private:
  vtkSMRelievoViewProxy(const vtkSMRelievoViewProxy&) = delete;
  void operator=(const vtkSMRelievoViewProxy&) = delete;
};

#endif
