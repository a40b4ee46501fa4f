// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCover
 * @brief Chooses, among candidate places of cameras, those that together see most of a mesh.
 *
 * Input 0: a vtkPolyData. Input 1 (optional, repeatable): data sets that occlude it. Input 2: a
 * data set whose points are the candidates; active point vectors, if any, are the directions in
 * which their cameras look (needed unless ViewAngle is 360).
 *
 * A place sees a cell if the segment from it to the cell's place (vtkRelievoSunExposure) is free,
 * from either side of the cell, within FarthestDistance, LargestAngle, ViewAngle and Resolution. A
 * cell counts by its area, times the cell array Weights. Places are chosen one after the other,
 * each with the largest gain (G. L. Nemhauser, L. A. Wolsey, M. L. Fisher 1978; evaluated lazily,
 * M. Minoux 1978), which reaches at least 1 - 1/e, 63 %, of the best choice. The field data `bound`
 * is an upper bound for any choice of as many places.
 *
 * Output 0: the mesh with the cell arrays covered (number of chosen places that see it, int) and
 * candidates (number of candidates that see it, int), and the field data share (part of the weight
 * that is covered), reachable (part that all candidates together cover) and bound (of share).
 * Output 1: the chosen places, in their order, as vertices with the arrays candidate (id among the
 * input's points), gain and share (of all weight, with the places before). Fewer than
 * NumberOfPlaces if no candidate sees more.
 *
 * Rays are in double (vtkRelievoRayScene). Memory: a bit for each candidate and cell.
 *
 * Errors: no candidates, no directions, no such array of weights, negative weights, too little
 * memory.
 */
#ifndef vtkRelievoCover_h
#define vtkRelievoCover_h

#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for named parameters
#include "vtkRelievoSightAlgorithm.h"
#include "vtkRelievoText.h" // for names of arrays

#include <string> // for the weights' name

class VTKRELIEVOFILTERS_EXPORT vtkRelievoCover : public vtkRelievoSightAlgorithm
{
public:
  static vtkRelievoCover* New();
  vtkTypeMacro(vtkRelievoCover, vtkRelievoSightAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** How many places to choose, at least 1. Default 4. */
  vtkSetClampMacro(NumberOfPlaces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPlaces, int);
  ///@}

  ///@{
  /** How many chosen places should see each cell; it counts for each. 1 (default) to 16. */
  vtkSetClampMacro(Times, int, 1, 16);
  vtkGetMacro(Times, int);
  ///@}

  ///@{
  /** The largest distance at which a cell is seen, in world units; 0, the default: any. */
  vtkSetClampMacro(FarthestDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FarthestDistance, double);
  ///@}

  ///@{
  /** The largest angle between the line of sight and the normal, degrees, 1 to 90. Default 90. */
  vtkSetClampMacro(LargestAngle, double, 1.0, 90.0);
  vtkGetMacro(LargestAngle, double);
  ///@}

  ///@{
  /** The full angle of the cone that a camera sees, degrees, 1 to 360. Default 360: everything. */
  vtkSetClampMacro(ViewAngle, double, 1.0, 360.0);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /**
   * The fewest pixels per world unit on the surface, in the direction in which it is foreshortened;
   * 0, the default: any. A camera has FocalLength pixels per radian at its middle; default 1000.
   */
  vtkSetClampMacro(Resolution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Resolution, double);
  vtkSetClampMacro(FocalLength, double, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(FocalLength, double);
  ///@}

  ///@{
  /** The name of a cell array of weights per area, at least 0; empty, the default: 1. */
  void SetWeights(RELIEVO_TEXT name);
  std::string GetWeights() { return this->Weights; }
  ///@}

  ///@{
  /** Access to parameters by name, with values as text, as in vtkRelievoStage. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoCover();
  ~vtkRelievoCover() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoCover(const vtkRelievoCover&) = delete;
  void operator=(const vtkRelievoCover&) = delete;

  vtkRelievoParameterList Parameters;
  int NumberOfPlaces = 4;
  int Times = 1;
  double FarthestDistance = 0.0;
  double LargestAngle = 90.0;
  double ViewAngle = 360.0;
  double Resolution = 0.0;
  double FocalLength = 1000.0;
  std::string Weights;
};

#endif
