// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoIntVectorProperty
 * @brief A property that clamps its value to its range, so that it shows the value in use.
 *
 * The value is clamped when it is pushed, with a warning: also after scripts, state files and
 * links. The range is that of its domain, or of its hint Accepts (vtkSMRelievoRange.h).
 */
#ifndef vtkSMRelievoIntVectorProperty_h
#define vtkSMRelievoIntVectorProperty_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMIntVectorProperty.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoIntVectorProperty : public vtkSMIntVectorProperty
{
public:
  static vtkSMRelievoIntVectorProperty* New();
  vtkTypeMacro(vtkSMRelievoIntVectorProperty, vtkSMIntVectorProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMRelievoIntVectorProperty() = default;
  ~vtkSMRelievoIntVectorProperty() override = default;

  void WriteTo(vtkSMMessage* message) override;

private:
  vtkSMRelievoIntVectorProperty(const vtkSMRelievoIntVectorProperty&) = delete;
  void operator=(const vtkSMRelievoIntVectorProperty&) = delete;
};

#endif
