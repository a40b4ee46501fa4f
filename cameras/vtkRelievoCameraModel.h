// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCameraModel
 * @brief A sensor as people calibrate it: its size, its pose, and the ray of each of its pixels.
 *
 * Pixels are counted as OpenCV counts them: column u from the left, row v from the top, the centre
 * of the first pixel at (0, 0), so that the picture reaches from -0.5 to columns - 0.5. Camera
 * space is x right, y down, z forward, in world units; the pose takes a world point p to R p + t.
 *
 * Subclasses say which ray belongs to a pixel, and which pixel to a point.
 *
 * Errors: a size below 1, a matrix R that is no rotation, numbers that are not finite; what was set
 * before stays.
 */
#ifndef vtkRelievoCameraModel_h
#define vtkRelievoCameraModel_h

#include "vtkObject.h"
#include "vtkRelievoCamerasModule.h" // for the export macro

#include <string> // for what is wrong

class vtkDoubleArray;
class vtkFieldData;

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoCameraModel : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkRelievoCameraModel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Columns and rows of the picture, from 1; default 640 x 480. */
  void SetSize(int columns, int rows);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * From the world to camera space: R, row by row, and t in world units. Default the identity. R is
   * taken as the nearest rotation, if it is one within 1e-3.
   */
  void SetExtrinsics(const double rotation[9], const double translation[3]);
  vtkGetVectorMacro(Rotation, double, 9);
  vtkGetVector3Macro(Translation, double);
  ///@}

  /**
   * The pose of a camera at this place that looks at that one, the third vector upwards in the
   * picture. False, with an error, if they say no direction.
   */
  virtual bool LookAt(const double position[3], const double target[3], const double up[3]);

  /** What is wrong with these three, and what is expected; empty if nothing is. */
  static std::string CheckView(
    const double position[3], const double target[3], const double up[3]);

  ///@{
  /**
   * The ray of a place in the picture in camera space, or in the world: where it begins, and its
   * unit direction. False, and both are NaN, where the sensor sees nothing.
   */
  virtual bool GetCameraRay(double u, double v, double origin[3], double direction[3]) = 0;
  bool GetRay(double u, double v, double origin[3], double direction[3]);
  ///@}

  ///@{
  /**
   * The place in the picture, also outside of its rows and columns, of a point in camera space, or
   * in the world. False, and both are NaN, if no ray meets the point.
   */
  virtual bool ProjectCameraPoint(const double point[3], double pixel[2]) = 0;
  virtual bool HasPlaces() { return true; } ///< whether it finds any
  bool Project(const double point[3], double pixel[2]);
  ///@}

  /** Whether all rays begin at one point, the origin of camera space. */
  virtual bool IsCentral() { return false; }

  /** Whether a picture shows what it sees: its rays begin at one place, or are parallel. */
  virtual bool HasPicture() { return true; }

  /** Columns of a whole turn, behind which the same directions come again; 0 of most sensors. */
  virtual double GetColumnsOfTurn() { return 0.0; }

  ///@{
  /**
   * The rays of all pixels in the world, row by row from the top, of the rows from one to before
   * another, or of given places (n x 2): two arrays of n x 3, NaN where nothing is seen. All cores.
   */
  void GetRays(vtkDoubleArray* origins, vtkDoubleArray* directions);
  void GetRowRays(int first, int end, vtkDoubleArray* origins, vtkDoubleArray* directions);
  void GetRays(vtkDoubleArray* places, vtkDoubleArray* origins, vtkDoubleArray* directions);
  ///@}

  /**
   * The depth of a point in the world that a ray from this origin meets: z in camera space, for
   * sensors without one direction the distance.
   */
  virtual double GetDepth(const double origin[3], const double point[3]);

  /** Takes all settings of another camera of the same class; of another class the size and pose. */
  virtual void Copy(vtkRelievoCameraModel* other);

  /**
   * Adds the calibration to the field data of a picture: R (9 double, row by row), t (3), and what
   * the subclass has, such as K (9), `lens` (text) and `distortion`.
   */
  virtual void AddTo(vtkFieldData* fields);

  /** The places (n x 2) of world points (n x 3), NaN where there is none. All cores. */
  void Project(vtkDoubleArray* points, vtkDoubleArray* places);

protected:
  vtkRelievoCameraModel() = default;
  ~vtkRelievoCameraModel() override = default;

  static void AddNumbers(vtkFieldData* fields, const char* name, const double* values, int count);
  static void AddText(vtkFieldData* fields, const char* name, const char* text);

  // NaN, and false.
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
