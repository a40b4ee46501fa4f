// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoLayersDomain
 * @brief A selection among the names of layers, which the definition lists.
 *
 * Since 6.1 ParaView's own domain sets a property's default values whenever its list changes, even
 * while the definition is being read and the property does not exist yet.
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
