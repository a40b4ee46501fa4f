// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Errors of an algorithm on a composite, whose blocks VTK passes one by one: each error is reported
 * once.
 */
#ifndef vtkRelievoErrorOnce_h
#define vtkRelievoErrorOnce_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkRelievoReportOnce.h"

#include <string>

namespace relievo
{
class ErrorOnce
{
public:
  explicit ErrorOnce(vtkAlgorithm* algorithm)
  {
    algorithm->AddObserver(vtkCommand::StartEvent, this, &ErrorOnce::Start);
    algorithm->AddObserver(vtkCommand::EndEvent, this, &ErrorOnce::End);
  }

  bool IsNew(const std::string& error) { return this->Reported.IsNew(error); }

private:
  // Called for the composite and, in between, for each block.
  void Start()
  {
    if (this->Depth++ == 0)
    {
      this->Reported.Forget();
    }
  }
  void End() { --this->Depth; }

  int Depth = 0;
  vtkRelievoReportOnce Reported; // since the outermost start
};
}

#endif
