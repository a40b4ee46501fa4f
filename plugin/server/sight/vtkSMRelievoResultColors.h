// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoResultColors
 * @brief Ranges of colours that suit the results of the filters Sun Exposure, Visibility and Cover.
 *
 * ParaView gives a constant array the lowest colour: a mesh in the sun all day would look shaded.
 * Shares keep the range 0 to 1, unless the user has saved another default. Other results, such as
 * hours, get the range from 0 to their value where they are constant, unless the user has set a
 * range.
 */
#ifndef vtkSMRelievoResultColors_h
#define vtkSMRelievoResultColors_h

#include "vtkCallbackCommand.h" // for the observer of colours
#include "vtkNew.h"             // for the observer of colours
#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoResultColors : public vtkObject
{
public:
  static vtkSMRelievoResultColors* New();
  vtkTypeMacro(vtkSMRelievoResultColors, vtkObject);

  /** The plugin's initializer. */
  static void Start();

protected:
  vtkSMRelievoResultColors();
  ~vtkSMRelievoResultColors() override = default;

private:
  vtkSMRelievoResultColors(const vtkSMRelievoResultColors&) = delete;
  void operator=(const vtkSMRelievoResultColors&) = delete;

  void OnRegistered(vtkObject*, unsigned long, void* registered);

  vtkNew<vtkCallbackCommand> Updated; // observes colours of results
};

#endif
