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

#include <array> // for shares

class vtkRelievoRayScene;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoSightAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkRelievoSightAlgorithm, vtkPolyDataAlgorithm);

  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which part of the cells and points is computed, from 1, and the number of parts: each has an
   * equal share, in their order, and 0 in the arrays elsewhere. The parts' arrays, added up, are
   * those of a single filter, bit by bit. Default 1 of 1.
   */
  void SetPart(int part, int parts);
  vtkGetMacro(Part, int);
  vtkGetMacro(NumberOfParts, int);
  ///@}

  ///@{
  /**
   * A scene for the rays, whose data are the mesh and then the occluders, such as one that has read
   * its trees from a file. Default: none, a scene is made for each update.
   */
  void SetScene(vtkRelievoRayScene* scene);
  vtkRelievoRayScene* GetScene();
  ///@}

  vtkMTimeType GetMTime() override;

  /** Removes all occluders (input 1). */
  void RemoveOccluders() { this->SetInputConnection(1, nullptr); }

protected:
  vtkRelievoSightAlgorithm();
  ~vtkRelievoSightAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  // The mesh, as prop 0, and its occluders, updated. nullptr, with an error, if SetScene has other
  // data, or if rays cannot hit some of them.
  vtkSmartPointer<vtkRelievoRayScene> MakeScene(vtkInformationVector** inputs);

  // The share of so many cells or points: the first, and the one after the last.
  std::array<std::size_t, 2> GetShare(std::size_t all) const;

  // Adds a number to the field data.
  static void AddField(vtkPolyData* mesh, const char* name, double value);

private:
  vtkRelievoSightAlgorithm(const vtkRelievoSightAlgorithm&) = delete;
  void operator=(const vtkRelievoSightAlgorithm&) = delete;

  vtkSmartPointer<vtkRelievoRayScene> Scene;
  int Part = 1;
  int NumberOfParts = 1;
};

#endif
