// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeakCounter.h
 * @brief Counts living VTK objects by class, in release builds of VTK as well.
 *
 * VTK's own vtkDebugLeaks is empty unless VTK is built for it. Here the program stands in front of
 * two functions that every VTK object passes through, vtkObjectBase::InitializeObjectBase and its
 * destructor, by the dynamic linker's rule that the program's symbols come first (ELF only).
 */
#ifndef relievoTestLeakCounter_h
#define relievoTestLeakCounter_h

#include <map>
#include <string>

namespace relievoTest
{
/** Number of living VTK objects by class name; those made before main() are included. */
std::map<std::string, int> LiveObjects();

/** True when counting works with this VTK and linker: makes an object and sees it come and go. */
bool CanCountObjects();

/**
 * Objects that outlived a piece of work:
 *
 *     LeakCounter leaks;
 *     DoAndUndo();
 *     RELIEVO_CHECK_THAT(leaks.Leaks().empty(), leaks.Leaks());
 */
class LeakCounter
{
public:
  /** Takes the living objects of now as those that may stay. */
  LeakCounter();

  /**
   * Classes with more living objects than at construction, as `vtkFoo: 2 more, vtkBar: 1 more`;
   * empty when there are none. VTK's singletons, made at first use and kept until the process
   * ends, are left out.
   */
  std::string Leaks() const;

private:
  std::map<std::string, int> Before;
};
}

#endif
