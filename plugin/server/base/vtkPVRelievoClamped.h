// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clamps values to their range on arrival, with a message: ParaView's domains limit its panel but
// not scripts and state files.
#ifndef vtkPVRelievoClamped_h
#define vtkPVRelievoClamped_h

#include "vtkObject.h"
#include "vtkProcessModule.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoParameterList.h"

// With several drawing processes, only the first reports.
inline bool vtkPVRelievoReports()
{
  auto* process = vtkProcessModule::GetProcessModule();
  return !process || process->GetPartitionId() == 0;
}

// The nearest value within the range (the lowest for NaN), with a message if it differs.
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

// Sets a described value. Its property (vtkSMRelievoRange.h) has clamped it; a value that is still
// refused leaves the old one, with a message.
inline void vtkPVRelievoSet(vtkObject* self, const vtkRelievoParameterList& list,
  const std::string& name, const std::vector<double>& values)
{
  const vtkRelievoParameter* parameter = list.Find(name);
  const std::string error =
    parameter ? parameter->Set(values) : std::string("there is no such value here");
  if (!error.empty() && vtkPVRelievoReports())
  {
    vtkWarningWithObjectMacro(self, << name << ": " << error << "; it stays as it was.");
  }
}

#endif
