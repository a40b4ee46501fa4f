// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoMaterialProxy
 * @brief Proxy of vtkPVRelievoMaterial, a sub-proxy of a surface representation's.
 *
 * Tells its object, on every process, which representation it belongs to: its parent's sub-proxy
 * SurfaceRepresentation.
 */
#ifndef vtkSMRelievoMaterialProxy_h
#define vtkSMRelievoMaterialProxy_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMProxy.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoMaterialProxy : public vtkSMProxy
{
public:
  static vtkSMRelievoMaterialProxy* New();
  vtkTypeMacro(vtkSMRelievoMaterialProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMRelievoMaterialProxy() = default;
  ~vtkSMRelievoMaterialProxy() override = default;

  bool KnowsRepresentation = false;

private:
  vtkSMRelievoMaterialProxy(const vtkSMRelievoMaterialProxy&) = delete;
  void operator=(const vtkSMRelievoMaterialProxy&) = delete;
};

#endif
