// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoDoubleVectorProperty
 * @brief A property that clamps its value to its range, so that it shows the value in use.
 *
 * The value is clamped when it is pushed, with a warning: also after scripts, state files and
 * links. The range is that of its domain, or of its hint Accepts (vtkSMRelievoRange.h).
 */
#ifndef vtkSMRelievoDoubleVectorProperty_h
#define vtkSMRelievoDoubleVectorProperty_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMDoubleVectorProperty.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoDoubleVectorProperty
  : public vtkSMDoubleVectorProperty
{
public:
  static vtkSMRelievoDoubleVectorProperty* New();
  vtkTypeMacro(vtkSMRelievoDoubleVectorProperty, vtkSMDoubleVectorProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMRelievoDoubleVectorProperty() = default;
  ~vtkSMRelievoDoubleVectorProperty() override = default;

  void WriteTo(vtkSMMessage* message) override;

private:
  vtkSMRelievoDoubleVectorProperty(const vtkSMRelievoDoubleVectorProperty&) = delete;
  void operator=(const vtkSMRelievoDoubleVectorProperty&) = delete;
};

#endif
