// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoReturns
 * @brief The returns of a sensor's rays: first hits within its range limits, and for a
 * vtkRelievoLidar the return of a whole beam, with noise.
 *
 * A beam that diverges is a cone of rays, as in Winiwarter et al. 2022. Its return is
 * the nearest or the farthest hit of these rays.
 */
#ifndef vtkRelievoReturns_h
#define vtkRelievoReturns_h

#include "vtkType.h" // for vtkIdType

class vtkDoubleArray;
class vtkRelievoCameraModel;
class vtkRelievoLidar;
class vtkRelievoRayScene;
class vtkTable;

class vtkRelievoReturns
{
public:
  vtkRelievoReturns(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera);

  /** Finds the return of each ray, in the columns of vtkRelievoRayScene; false after an error. */
  bool Find(vtkDoubleArray* origins, vtkDoubleArray* directions, vtkTable* hits);

  /** Adds range noise to distances and positions; `first` is the number of the first pixel. */
  void AddNoise(vtkDoubleArray* origins, vtkIdType first, vtkTable* hits);

  /** Whether a surface at this distance is within the sensor's range limits. */
  bool IsInRange(double distance) const
  {
    return distance >= this->Limits[0] && distance <= this->Limits[1];
  }

  /** Turns hits outside of the range limits into misses. */
  void LimitRange(vtkTable* hits) const;

private:
  vtkRelievoRayScene* Scene;
  vtkRelievoLidar* Lidar; // none: other sensors
  double Limits[2];
};

#endif
