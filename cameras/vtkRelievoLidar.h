// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLidar
 * @brief A laser scanner: beams by tables of elevation and azimuth, or a spinning sensor.
 *
 * The picture has a row for each beam and a column for each step of the turn; with SetDirections()
 * a single row of beams of any direction. All rays start at the sensor's position.
 *
 * Sensor space follows the convention of such sensors: x forward, y left, z up; the extrinsics map
 * the world to it. Azimuths are counted from x towards y, counterclockwise seen from above, and
 * elevations from the plane z = 0 upwards, in degrees.
 *
 * Beams have no positions between them, so ProjectCameraPoint() always fails.
 */
#ifndef vtkRelievoLidar_h
#define vtkRelievoLidar_h

#include "vtkRelievoCameraModel.h"

#include <vector> // for the beams

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoLidar : public vtkRelievoCameraModel
{
public:
  static vtkRelievoLidar* New();
  vtkTypeMacro(vtkRelievoLidar, vtkRelievoCameraModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A spinning sensor: a row for each beam, with its elevation, at `steps` equal steps of a turn,
   * from the first azimuth to the last one, which would follow the last column: 180 and -180 for a
   * clockwise turn. Default 16 beams from 15 to -15 degrees, 1800 steps from 180 to -180.
   */
  void SetSpinning(int beams, const double* elevations, int steps, double first, double last)
    VTK_SIZEHINT(elevations, beams);

  /** Azimuth offsets of a spinning sensor's beams, one for each. Default 0. */
  void SetAzimuthOffsets(int beams, const double* offsets) VTK_SIZEHINT(offsets, beams);

  /** Beams with individual directions: one row, a column for each. */
  void SetDirections(int beams, const double* azimuths, const double* elevations)
    VTK_SIZEHINT(azimuths, beams) VTK_SIZEHINT(elevations, beams);

  /** Sets the pose of a sensor at `position` whose x axis points to `target`. */
  bool LookAt(const double position[3], const double target[3], const double up[3]) override;

  bool HasPicture() override { return false; }
  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  bool HasPlaces() override { return false; }
  double GetDepth(const double origin[3], const double point[3]) override;
  void Copy(vtkRelievoCameraModel* other) override;
  void AddTo(vtkFieldData* fields) override;

protected:
  vtkRelievoLidar();
  ~vtkRelievoLidar() override = default;

private:
  vtkRelievoLidar(const vtkRelievoLidar&) = delete;
  void operator=(const vtkRelievoLidar&) = delete;

  bool CheckAngles(const char* what, int count, const double* angles);

  std::vector<double> Elevations;
  std::vector<double> Azimuths; // by beam; offsets if it spins
  bool Spins = true;
  double First = 180.0;
  double Last = -180.0;
};

#endif
