// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeakCounter.h
 * @brief Counts living VTK objects by class, also in release builds of VTK.
 *
 * VTK's own vtkDebugLeaks is empty unless VTK is built with it. The program replaces two functions
 * that every VTK object calls, vtkObjectBase::InitializeObjectBase and its destructor, by the
 * dynamic linker's rule that the program's symbols come first (ELF only).
 */
#ifndef relievoTestLeakCounter_h
#define relievoTestLeakCounter_h

#include <map>
#include <string>

namespace relievoTest
{
/** Number of living VTK objects by class name, including those made before main(). */
std::map<std::string, int> LiveObjects();

/** Whether counting works with this VTK and linker: tested with an object made and destroyed. */
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
  /** Takes the currently living objects as allowed. */
  LeakCounter();

  /**
   * Classes with more living objects than at construction, as `vtkFoo: 2 more, vtkBar: 1 more`;
   * empty if there are none. VTK's singletons, made at first use and kept until the process ends,
   * are not counted.
   */
  std::string Leaks() const;

private:
  std::map<std::string, int> Before;
};
}

#endif
