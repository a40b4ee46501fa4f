// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoViewFactors
 * @brief View factors between groups of a mesh's cells, by rays, with bounds.
 *
 * Input 0: a vtkPolyData. Input 1 (optional, repeatable): data sets that hide its cells from each
 * other. Output: a vtkTable with a row for each pair of groups:
 * - from, to (int): the numbers of the groups; `to` is also -1, nothing, and -2, other surfaces:
 *   the occluders, cells without a group, and the backs of cells;
 * - factor (double): the share of the light of uniformly radiating cells of `from` that arrives at
 *   `to`, 0 to 1;
 * - bound (double): the factor's error is smaller with a confidence of 99.9 %;
 * - area (double): of `from`, in square world units.
 *
 * Each group sends rays from random places on its cells' fronts, by Lambert's law, until the bounds
 * of all its factors are below Tolerance. Bounds are half widths of Wilson's interval of the share
 * of rays (E. B. Wilson 1927). The factors of a group add up to 1 with those to -1 and -2. Each
 * direction of a pair has rays of its own, so that reciprocity, area times factor, holds within the
 * bounds. Cells count from their fronts, where normals by the order of their points show. Rays
 * begin 1e-7 of the mesh's size in front of the surface. Equal seeds give equal factors.
 *
 * Errors: no cell array of this name with one component of whole numbers; no group; too little
 * memory for the pairs.
 */
#ifndef vtkRelievoViewFactors_h
#define vtkRelievoViewFactors_h

#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for named parameters
#include "vtkRelievoText.h"            // for parameters' names and texts
#include "vtkTableAlgorithm.h"

#include <string> // for the name of the groups

class VTKRELIEVOFILTERS_EXPORT vtkRelievoViewFactors : public vtkTableAlgorithm
{
public:
  static vtkRelievoViewFactors* New();
  vtkTypeMacro(vtkRelievoViewFactors, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The name of a cell array with each cell's group, 0 or more; cells with negative numbers have no
   * group. Default "group".
   */
  void SetGroups(RELIEVO_TEXT name);
  const char* GetGroups() const { return this->Groups.c_str(); }
  ///@}

  ///@{
  /** The largest bound of a factor, 0.0001 to 0.2. Default 0.01. */
  vtkSetClampMacro(Tolerance, double, 0.0001, 0.2);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Seed of the rays. Default 0. */
  vtkSetClampMacro(Seed, int, 0, VTK_INT_MAX);
  vtkGetMacro(Seed, int);
  ///@}

  /** Removes all occluders (input 1). */
  void RemoveOccluders() { this->SetInputConnection(1, nullptr); }

  ///@{
  /** Access to parameters by name, with values as text, as in vtkRelievoStage. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoViewFactors();
  ~vtkRelievoViewFactors() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoViewFactors(const vtkRelievoViewFactors&) = delete;
  void operator=(const vtkRelievoViewFactors&) = delete;

  vtkRelievoParameterList Parameters;
  std::string Groups = "group";
  double Tolerance = 0.01;
  int Seed = 0;
};

#endif
