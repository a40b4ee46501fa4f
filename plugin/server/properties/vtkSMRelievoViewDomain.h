// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoViewDomain
 * @brief The render views as values of a property; the active one is the default.
 *
 * If the active view is no render view, the default is the first render view.
 */
#ifndef vtkSMRelievoViewDomain_h
#define vtkSMRelievoViewDomain_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMDomain.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoViewDomain : public vtkSMDomain
{
public:
  static vtkSMRelievoViewDomain* New();
  vtkTypeMacro(vtkSMRelievoViewDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int IsInDomain(vtkSMProperty* property) override;
  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

protected:
  vtkSMRelievoViewDomain() = default;
  ~vtkSMRelievoViewDomain() override = default;

private:
  vtkSMRelievoViewDomain(const vtkSMRelievoViewDomain&) = delete;
  void operator=(const vtkSMRelievoViewDomain&) = delete;
};

#endif
