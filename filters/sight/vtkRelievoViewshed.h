// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoViewshed
 * @brief The points of a terrain that observers see, by rays in double.
 *
 * Input 0: a vtkPolyData whose heights are along z, such as that of vtkRelievoTerrain. Input 1
 * (optional, repeatable): data sets that also hide it. Output: the mesh with the point array seen
 * (int, the active scalars): the number of observers that see the place TargetHeight above the
 * point.
 *
 * An observer sees a place if no triangle meets the straight line between them. Both ends are
 * raised by 1e-9 of the mesh's size, so that lines do not begin or end on the surface. There is no
 * other tolerance and no sampling: the verdict is that of the triangles.
 *
 * With Curvature, the mesh is lowered around each observer by Curvature d^2 / 2R at the horizontal
 * distance d in metres, with R = 6371 km.
 *
 * Errors: no observers; an observer that is not above the mesh; Curvature and other data.
 */
#ifndef vtkRelievoViewshed_h
#define vtkRelievoViewshed_h

#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for named parameters
#include "vtkRelievoSightAlgorithm.h"
#include "vtkRelievoText.h" // for parameters' names and texts

#include <array>  // for observers
#include <vector> // for observers

class VTKRELIEVOFILTERS_EXPORT vtkRelievoViewshed : public vtkRelievoSightAlgorithm
{
public:
  static vtkRelievoViewshed* New();
  vtkTypeMacro(vtkRelievoViewshed, vtkRelievoSightAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Where observers are: world coordinates, and the height above the mesh, at least 0. */
  void AddViewpoint(double x, double y, double height);
  void RemoveAllViewpoints();
  int GetNumberOfViewpoints() { return static_cast<int>(this->Observers.size()); }
  ///@}

  ///@{
  /** Height of the targets above the mesh's points, at least 0. Default 0. */
  vtkSetClampMacro(TargetHeight, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TargetHeight, double);
  ///@}

  ///@{
  /** The largest horizontal distance that observers see, in world units; 0, the default: any. */
  vtkSetClampMacro(FarthestDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FarthestDistance, double);
  ///@}

  ///@{
  /**
   * Share of the Earth's curvature that counts, 0 to 1: 1 without refraction, 0.857 with that of
   * light in the usual air. World units are then metres. Default 0: the Earth is flat.
   */
  vtkSetClampMacro(Curvature, double, 0.0, 1.0);
  vtkGetMacro(Curvature, double);
  ///@}

  ///@{
  /** Access to parameters by name, with values as text, as in vtkRelievoStage. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoViewshed();
  ~vtkRelievoViewshed() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoViewshed(const vtkRelievoViewshed&) = delete;
  void operator=(const vtkRelievoViewshed&) = delete;

  vtkRelievoParameterList Parameters;
  std::vector<std::array<double, 3>> Observers;
  double TargetHeight = 0.0;
  double FarthestDistance = 0.0;
  double Curvature = 0.0;
};

#endif
