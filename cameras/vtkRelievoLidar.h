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
 * Between two beams of a spinning sensor, elevations and azimuth offsets are interpolated, if the
 * elevations only rise or only fall from beam to beam. Points then have positions in the picture.
 * Other sensors have none, and HasPlaces() is false.
 *
 * Range limits, beam divergence and noise apply where the returns of beams are reported
 * (vtkRelievoRayLayers). Positions, visible cells and flow follow the axes of the beams, within the
 * range limits.
 */
#ifndef vtkRelievoLidar_h
#define vtkRelievoLidar_h

#include "vtkRelievoCameraModel.h"

#include <limits> // for infinity
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

  /**
   * The sensor's motion during one turn, in its axes at column 0: a straight way of `way` world
   * units, and a rotation about `turn` by its length in degrees, both at constant speed. The pose
   * is that of column 0. Sensors that do not spin ignore it. Default 0.
   */
  void SetMotion(const double way[3], const double turn[3]);

  /**
   * Range limits in world units: a beam has no return from surfaces nearer than `minimum` (0) or
   * farther than `maximum` (infinity).
   */
  void SetRangeLimits(double minimum, double maximum);
  void GetRangeLimits(double limits[2]) override;

  ///@{
  /**
   * Beam divergence: the full angle of a beam in degrees, from 0 (default) to 90, and the rays that
   * fill its cone, 1 to 4096 (16), evenly from the axis to the rim. The return of a beam is that of
   * its ray with the nearest (FIRST, default) or the farthest (LAST) hit.
   */
  enum
  {
    FIRST = 0,
    LAST = 1
  };
  void SetDivergence(double degrees, int rays);
  vtkGetMacro(Divergence, double);
  vtkGetMacro(RaysOfABeam, int);
  vtkSetClampMacro(Return, int, FIRST, LAST);
  vtkGetMacro(Return, int);
  ///@}

  ///@{
  /**
   * Range noise: the standard deviation of a normal distribution in world units (0), and the seed
   * (0). The error of a beam depends on its pixel and the seed alone.
   */
  void SetNoise(double deviation, int seed);
  vtkGetMacro(Noise, double);
  vtkGetMacro(Seed, int);
  ///@}

  /** Beams with individual directions: one row, a column for each. */
  void SetDirections(int beams, const double* azimuths, const double* elevations)
    VTK_SIZEHINT(azimuths, beams) VTK_SIZEHINT(elevations, beams);

  /** Sets the pose of a sensor at `position` whose x axis points to `target`. */
  bool LookAt(const double position[3], const double target[3], const double up[3]) override;

  bool HasPicture() override { return false; }
  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  bool HasPlaces() override;
  double GetColumnsOfTurn() override;
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
  double GetInterpolated(const std::vector<double>& values, double v) const;
  bool FindBeam(double elevation, double& v) const;
  bool FindColumn(const double point[3], double& u, double& v) const;
  bool IsMoving() const;

  std::vector<double> Elevations;
  std::vector<double> Azimuths; // by beam; offsets if it spins
  bool Spins = true;
  double First = 180.0;
  double Last = -180.0;
  double Way[3] = { 0.0, 0.0, 0.0 };
  double Turn[3] = { 0.0, 0.0, 0.0 };
  double RangeLimits[2] = { 0.0, std::numeric_limits<double>::infinity() };
  double Divergence = 0.0;
  int RaysOfABeam = 16;
  int Return = FIRST;
  double Noise = 0.0;
  int Seed = 0;
};

#endif
