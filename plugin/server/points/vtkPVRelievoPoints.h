// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoPoints
 * @brief The points of one of ParaView's surface representations as things in its view, on one
 * process: lamps, spheres of fog, markers.
 *
 * While it is on and the representation is visible, each point of what it draws is one. With
 * several ranks, the points of each are there for all.
 *
 * Every setting is a property of the representation's proxy, made from what the points say of
 * themselves (points.xml). A parameter is named with its stage, "fog:radius". A value out of its
 * range is brought into it, with a warning that says so.
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

  /** The representation, a vtkGeometryRepresentation. Given once, when its proxy is made. */
  void SetRepresentation(vtkPVDataRepresentation* representation);

  ///@{
  /** Whether the points are anything. Default off. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  ///@}

  ///@{
  /** A parameter's value for all points without the array, or their place in its choices. */
  void SetValue(const char* parameter, double value);
  void SetValue(const char* parameter, double first, double second, double third);
  ///@}

  /** The point array that a value is taken from; empty: one for all. */
  void SetArray(const char* parameter, const char* array);

  /** Whether any points in the view are anything. */
  static bool IsAny(vtkPVView* view);

  /** Gives the points that the representation draws, where it draws them; nullptr: none. */
  static void TakeInput(vtkGeometryRepresentation* representation, vtkRelievoPointValues* values);

  /**
   * Before each picture: gives the stage the points in the view that are for it, and `more`, which
   * are there beside them.
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

  // Sets a parameter of the points, which are made of the stage's first.
  void Set(const char* parameter, const std::vector<double>& values);
  std::string TakeName(const char* parameter);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
