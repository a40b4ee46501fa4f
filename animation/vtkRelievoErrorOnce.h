// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What an algorithm says of a composite, whose blocks VTK hands it one by one: each thing once.
 */
#ifndef vtkRelievoErrorOnce_h
#define vtkRelievoErrorOnce_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

#include <set>
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

  bool IsNew(const std::string& error) { return this->Reported.insert(error).second; }

private:
  // The composite's, and between them those of each block.
  void Start()
  {
    if (this->Depth++ == 0)
    {
      this->Reported.clear();
    }
  }
  void End() { --this->Depth; }

  int Depth = 0;
  std::set<std::string> Reported; // since the outermost start
};
}

#endif
