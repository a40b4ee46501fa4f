// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Errors that each frame or update would find again, and that are reported once.
#ifndef vtkRelievoReportOnce_h
#define vtkRelievoReportOnce_h

#include <set>
#include <string>

class vtkRelievoReportOnce
{
public:
  // Whether the error, or a text that identifies it, is passed for the first time.
  bool IsNew(const std::string& error) { return this->Reported.insert(error).second; }

  // For the only error of a frame, which is empty if there is none: whether it is one, and not that
  // of the frame before.
  bool IsChange(const std::string& error)
  {
    const bool known = this->Reported.count(error) > 0;
    this->Reported = { error };
    return !known && !error.empty();
  }

  // Everything is reported again.
  void Forget() { this->Reported.clear(); }

private:
  std::set<std::string> Reported;
};

#endif
