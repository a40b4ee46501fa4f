// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSightAlgorithm
 * @brief Filters that ask rays what lies before a mesh: the mesh itself, and what else hides it.
 *
 * Input 0: a vtkPolyData. Input 1 (by choice, several): data sets that hide it.
 */
#ifndef vtkRelievoSightAlgorithm_h
#define vtkRelievoSightAlgorithm_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for the scene

class vtkRelievoRayScene;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoSightAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkRelievoSightAlgorithm, vtkPolyDataAlgorithm);

  /** Removes all occluders (input 1). */
  void RemoveOccluders() { this->SetInputConnection(1, nullptr); }

protected:
  vtkRelievoSightAlgorithm();
  ~vtkRelievoSightAlgorithm() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  // The mesh, prop 0, and what hides it.
  static vtkSmartPointer<vtkRelievoRayScene> MakeScene(vtkInformationVector** inputs);

private:
  vtkRelievoSightAlgorithm(const vtkRelievoSightAlgorithm&) = delete;
  void operator=(const vtkRelievoSightAlgorithm&) = delete;
};

#endif
