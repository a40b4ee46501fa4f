// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSightAlgorithm
 * @brief Base of filters that trace rays to find what occludes a mesh: the mesh itself or other
 * data.
 *
 * Input 0: a vtkPolyData. Input 1 (optional, repeatable): data sets that occlude it.
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

  // The mesh, as prop 0, and its occluders.
  static vtkSmartPointer<vtkRelievoRayScene> MakeScene(vtkInformationVector** inputs);

private:
  vtkRelievoSightAlgorithm(const vtkRelievoSightAlgorithm&) = delete;
  void operator=(const vtkRelievoSightAlgorithm&) = delete;
};

#endif
