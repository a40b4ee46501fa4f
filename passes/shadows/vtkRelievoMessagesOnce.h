// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reports each error and warning of a stage once, instead of with every frame.
#ifndef vtkRelievoMessagesOnce_h
#define vtkRelievoMessagesOnce_h

#include "vtkObject.h"
#include "vtkRelievoReportOnce.h"

#include <string>

class vtkRelievoMessagesOnce
{
public:
  explicit vtkRelievoMessagesOnce(vtkObject* owner)
    : Owner(owner)
  {
  }

  void Error(const std::string& words)
  {
    if (this->Reported.IsNew(words))
    {
      vtkErrorWithObjectMacro(this->Owner, << words << ".");
    }
  }

  // Reports only the first warning of a kind.
  void Warn(const std::string& kind, const std::string& words)
  {
    if (this->Reported.IsNew(kind))
    {
      vtkWarningWithObjectMacro(this->Owner, << words << ".");
    }
  }

private:
  vtkObject* Owner;
  vtkRelievoReportOnce Reported;
};

#endif
