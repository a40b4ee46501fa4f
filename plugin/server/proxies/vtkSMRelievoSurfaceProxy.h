// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoSurfaceProxy
 * @brief Proxy of Relievo's objects for a surface: a sub-proxy of its representation's.
 *
 * Passes the representation to its object, on every process: its parent's sub-proxy
 * SurfaceRepresentation.
 */
#ifndef vtkSMRelievoSurfaceProxy_h
#define vtkSMRelievoSurfaceProxy_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMProxy.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoSurfaceProxy : public vtkSMProxy
{
public:
  static vtkSMRelievoSurfaceProxy* New();
  vtkTypeMacro(vtkSMRelievoSurfaceProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMRelievoSurfaceProxy() = default;
  ~vtkSMRelievoSurfaceProxy() override = default;

  bool KnowsRepresentation = false;

private:
  vtkSMRelievoSurfaceProxy(const vtkSMRelievoSurfaceProxy&) = delete;
  void operator=(const vtkSMRelievoSurfaceProxy&) = delete;
};

#endif
