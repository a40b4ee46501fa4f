// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoLayersDomain
 * @brief The names of layers, each chosen or not; the definition lists them.
 *
 * Since 6.1 ParaView's own domain sets a property's default values whenever its list changes, also
 * while the definition is read and there is no property yet.
 */
#ifndef vtkSMRelievoLayersDomain_h
#define vtkSMRelievoLayersDomain_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMArraySelectionDomain.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoLayersDomain : public vtkSMArraySelectionDomain
{
public:
  static vtkSMRelievoLayersDomain* New();
  vtkTypeMacro(vtkSMRelievoLayersDomain, vtkSMArraySelectionDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMRelievoLayersDomain();
  ~vtkSMRelievoLayersDomain() override = default;

private:
  vtkSMRelievoLayersDomain(const vtkSMRelievoLayersDomain&) = delete;
  void operator=(const vtkSMRelievoLayersDomain&) = delete;
};

#endif
