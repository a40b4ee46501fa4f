// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCameraModel
 * @brief A calibrated sensor: its size, its pose, and the ray of each of its pixels.
 *
 * Pixels are counted as in OpenCV: column u from the left, row v from the top, the centre of the
 * first pixel at (0, 0), so that the picture extends from -0.5 to columns - 0.5. Camera space is x
 * right, y down, z forward, in world units; the pose maps a world point p to R p + t.
 *
 * Subclasses define the ray of each pixel, and the pixel of each point.
 *
 * Errors: a size below 1, a matrix R that is not a rotation, numbers that are not finite; the
 * former values are then kept.
 */
#ifndef vtkRelievoCameraModel_h
#define vtkRelievoCameraModel_h

#include "vtkObject.h"
#include "vtkRelievoCamerasModule.h" // for the export macro

#include <string> // for error messages

class vtkDoubleArray;
class vtkFieldData;

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoCameraModel : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkRelievoCameraModel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Columns and rows of the picture, at least 1; default 640 x 480. */
  void SetSize(int columns, int rows);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * The pose from the world to camera space: R, row by row, and t in world units. Default the
   * identity. R is replaced by the nearest rotation, if its error is at most 1e-3.
   */
  void SetExtrinsics(const double rotation[9], const double translation[3]);
  vtkGetVectorMacro(Rotation, double, 9);
  vtkGetVector3Macro(Translation, double);
  ///@}

  /**
   * Sets the pose of a camera at `position` that looks at `target`, with `up` pointing upwards in
   * the picture. False, with an error, if these do not define a direction.
   */
  virtual bool LookAt(const double position[3], const double target[3], const double up[3]);

  /** Error message for LookAt's arguments, with the expected values; empty if they are valid. */
  static std::string CheckView(
    const double position[3], const double target[3], const double up[3]);

  ///@{
  /**
   * The ray of a position in the picture, in camera space or in the world: its origin, and its unit
   * direction. False, with NaN in both, where the sensor sees nothing.
   */
  virtual bool GetCameraRay(double u, double v, double origin[3], double direction[3]) = 0;
  bool GetRay(double u, double v, double origin[3], double direction[3]);
  ///@}

  ///@{
  /**
   * The picture position, also outside of its rows and columns, of a point in camera space, or in
   * the world. False, with NaN, if no ray hits the point.
   */
  virtual bool ProjectCameraPoint(const double point[3], double pixel[2]) = 0;
  virtual bool HasPlaces() { return true; } ///< whether it finds any
  bool Project(const double point[3], double pixel[2]);
  ///@}

  /** Whether all rays start at one point, the origin of camera space. */
  virtual bool IsCentral() { return false; }

  /** Whether the sensor's view is a picture: its rays start at one position, or are parallel. */
  virtual bool HasPicture() { return true; }

  /** Columns of a full turn, after which directions repeat; 0 for most sensors. */
  virtual double GetColumnsOfTurn() { return 0.0; }

  ///@{
  /**
   * The rays of all pixels in the world, row by row from the top; of the rows from `first` to
   * before `end`; or of given positions (n x 2). Two arrays of n x 3, NaN where the sensor sees
   * nothing. Uses all cores.
   */
  void GetRays(vtkDoubleArray* origins, vtkDoubleArray* directions);
  void GetRowRays(int first, int end, vtkDoubleArray* origins, vtkDoubleArray* directions);
  void GetRays(vtkDoubleArray* places, vtkDoubleArray* origins, vtkDoubleArray* directions);
  ///@}

  /** The distances along a ray between which the sensor reports surfaces; default 0, infinity. */
  virtual void GetRangeLimits(double limits[2]);

  /**
   * The depth of a world point hit by a ray from this origin: z in camera space, or the distance
   * for sensors without a single direction.
   */
  virtual double GetDepth(const double origin[3], const double point[3]);

  /** Copies all settings from a camera of the same class; from another class only size and pose. */
  virtual void Copy(vtkRelievoCameraModel* other);

  /**
   * Adds the calibration to the field data of a picture: R (9 double, row by row), t (3), and the
   * subclass's values, such as K (9), `lens` (text) and `distortion`.
   */
  virtual void AddTo(vtkFieldData* fields);

  /**
   * The picture positions (n x 2) of world points (n x 3), NaN if there is none. Uses all cores.
   */
  void Project(vtkDoubleArray* points, vtkDoubleArray* places);

protected:
  vtkRelievoCameraModel() = default;
  ~vtkRelievoCameraModel() override = default;

  static void AddNumbers(vtkFieldData* fields, const char* name, const double* values, int count);
  static void AddText(vtkFieldData* fields, const char* name, const char* text);

  // Sets NaN and returns false.
  static bool Nowhere(double* values, int count);

  int Size[2] = { 640, 480 };
  double Rotation[9] = { 1., 0., 0., 0., 1., 0., 0., 0., 1. };
  double Translation[3] = { 0., 0., 0. };

private:
  template <typename Place>
  void Fill(
    vtkIdType count, vtkDoubleArray* origins, vtkDoubleArray* directions, const Place& getPlace);

  vtkRelievoCameraModel(const vtkRelievoCameraModel&) = delete;
  void operator=(const vtkRelievoCameraModel&) = delete;
};

#endif
