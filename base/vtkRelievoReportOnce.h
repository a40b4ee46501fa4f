// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reports each error once, although every frame or update finds it again.
#ifndef vtkRelievoReportOnce_h
#define vtkRelievoReportOnce_h

#include <set>
#include <string>

class vtkRelievoReportOnce
{
public:
  // Whether this error, or this text that identifies it, is new.
  bool IsNew(const std::string& error) { return this->Reported.insert(error).second; }

  // For frames with at most one error (empty: none): whether there is an error that differs from
  // the previous frame's.
  bool IsChange(const std::string& error)
  {
    const bool known = this->Reported.count(error) > 0;
    this->Reported = { error };
    return !known && !error.empty();
  }

  // Lets all errors be reported again.
  void Forget() { this->Reported.clear(); }

private:
  std::set<std::string> Reported;
};

#endif
