// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoIntVectorProperty
 * @brief A property that has the value that is used: one out of its range is brought into it.
 *
 * The value is changed when it is pushed, with a warning: after scripts, state files and links too.
 * The range is that of its domain, or of its hint Accepts (vtkSMRelievoRange.h).
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
