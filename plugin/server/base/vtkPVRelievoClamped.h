// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ParaView's domains guide its panel but let scripts and state files through: what is out of range
// is brought into it where it arrives, with a message.
#ifndef vtkPVRelievoClamped_h
#define vtkPVRelievoClamped_h

#include "vtkObject.h"
#include "vtkProcessModule.h"
#include "vtkRelievoParameterList.h"

// Of several processes that draw together, the first speaks.
inline bool vtkPVRelievoReports()
{
  auto* process = vtkProcessModule::GetProcessModule();
  return !process || process->GetPartitionId() == 0;
}

// The nearest value within the range (not a number: the least), with a message if it is another.
template <typename T>
T vtkPVRelievoClamped(vtkObject* self, const char* property, T value, T least, T most)
{
  const T taken = value >= least ? (value <= most ? value : most) : least;
  if (taken != value && vtkPVRelievoReports())
  {
    vtkWarningWithObjectMacro(self,
      "Relievo" << property << " was given " << value << ", expected " << least << " to " << most
                << ": " << taken << " is taken.");
  }
  return taken;
}

// Sets a described value. Its property (vtkSMRelievoRange.h) has brought it into its range; what is
// refused all the same is left, with a message.
inline void vtkPVRelievoSet(vtkObject* self, const vtkRelievoParameterList& list,
  const std::string& name, const std::vector<double>& values)
{
  const vtkRelievoParameter* parameter = list.Find(name);
  const std::string wrong =
    parameter ? parameter->Set(values) : std::string("there is no such value here");
  if (!wrong.empty() && vtkPVRelievoReports())
  {
    vtkWarningWithObjectMacro(self, << name << ": " << wrong << "; it stays as it was.");
  }
}

#endif
