// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoResultColors
 * @brief Ranges of colours that suit the results of the filters Sun Exposure, Visibility and Cover.
 *
 * ParaView gives a constant array the lowest colour: a mesh in the sun all day would look shaded.
 * Shares keep the range 0 to 1, unless the user has saved another default. Other results, such as
 * hours, get the range from 0 to their value where they are constant.
 */
#ifndef vtkSMRelievoResultColors_h
#define vtkSMRelievoResultColors_h

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
  vtkSMRelievoResultColors() = default;
  ~vtkSMRelievoResultColors() override = default;

private:
  vtkSMRelievoResultColors(const vtkSMRelievoResultColors&) = delete;
  void operator=(const vtkSMRelievoResultColors&) = delete;

  void OnRegistered(vtkObject*, unsigned long, void* registered);
  void OnUpdated(vtkObject* colors, unsigned long, void*);
};

#endif
