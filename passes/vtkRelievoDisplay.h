// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDisplay
 * @brief Whether a render window can open: without a display VTK ends the process by abort(), and
 * without any OpenGL VTK 9.4 and later crash.
 */
#ifndef vtkRelievoDisplay_h
#define vtkRelievoDisplay_h

#include "vtkObject.h"
#include "vtkRelievoPassesModule.h" // for the export macro

#include <string> // for the sentence

class vtkRenderWindow;

class VTKRELIEVOPASSES_EXPORT vtkRelievoDisplay : public vtkObject
{
public:
  static vtkRelievoDisplay* New();
  vtkTypeMacro(vtkRelievoDisplay, vtkObject);

  /**
   * Connects to the display on which the window will open, before VTK does. Returns an error in
   * words, or "" if there is none or the window needs no display. A window of OSMesa, which VTK 9.4
   * and later use if no other kind opens, needs that library. The connection stays open
   * until the process ends: an X server without -noreset restarts when its last client leaves, and
   * does not answer meanwhile.
   */
  static std::string Check(vtkRenderWindow* window);

protected:
  vtkRelievoDisplay() = default;
  ~vtkRelievoDisplay() override = default;

private:
  vtkRelievoDisplay(const vtkRelievoDisplay&) = delete;
  void operator=(const vtkRelievoDisplay&) = delete;
};

#endif
