// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoPoints
 * @brief Turns the points of one of ParaView's surface representations into lamps, spheres of fog
 * or markers, on one process.
 *
 * While it is on and the representation is visible, each of its points is one of these. With
 * several ranks, every rank gets the points of all.
 *
 * Every setting is a property of the representation's proxy, generated from the description of the
 * points (points.xml). A parameter's name includes its stage, "fog:radius". A value outside its
 * range is clamped, with a warning.
 */
#ifndef vtkPVRelievoPoints_h
#define vtkPVRelievoPoints_h

#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

#include <memory> // for the internals
#include <string> // for names
#include <vector> // for values

class vtkGeometryRepresentation;
class vtkMultiProcessController;
class vtkPVDataRepresentation;
class vtkPVView;
class vtkRelievoPointStage;
class vtkRelievoPointValues;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoPoints : public vtkObject
{
public:
  static vtkPVRelievoPoints* New();
  vtkTypeMacro(vtkPVRelievoPoints, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The representation, a vtkGeometryRepresentation. Set once, when its proxy is made. */
  void SetRepresentation(vtkPVDataRepresentation* representation);

  ///@{
  /** Whether the points are used. Default off. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  ///@}

  ///@{
  /** A parameter's value for all points without the array, or its index for a choice. */
  void SetValue(const char* parameter, double value);
  void SetValue(const char* parameter, double first, double second, double third);
  ///@}

  /** The point array for a value; empty: one value for all. */
  void SetArray(const char* parameter, const char* array);

  /** Whether any points in the view are used. */
  static bool IsAny(vtkPVView* view);

  /** Sets the representation's points on the process that draws it; nullptr: none. */
  static void TakeInput(vtkGeometryRepresentation* representation, vtkRelievoPointValues* values);

  /**
   * Before each picture: passes the view's points for it to the stage, and `more` in addition.
   */
  static void Prepare(vtkPVView* view, vtkRelievoPointStage* stage,
    const std::vector<vtkRelievoPointValues*>& more, vtkMultiProcessController* controller);

protected:
  vtkPVRelievoPoints();
  ~vtkPVRelievoPoints() override;

  bool Enabled = false;

private:
  vtkPVRelievoPoints(const vtkPVRelievoPoints&) = delete;
  void operator=(const vtkPVRelievoPoints&) = delete;

  bool IsIn(vtkPVView* view);

  // Sets a parameter of the points, which are created from the stage on first use.
  void Set(const char* parameter, const std::vector<double>& values);
  std::string TakeName(const char* parameter);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
