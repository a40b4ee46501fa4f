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
 * Every setting is a property of the representation's proxy (lamps.xml, fog.xml, markers.xml). A
 * value out of its range is brought into it, with a warning that says so.
 */
#ifndef vtkPVRelievoPoints_h
#define vtkPVRelievoPoints_h

#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

#include <memory> // for the internals
#include <string> // for names
#include <vector> // for those in a view

class vtkGeometryRepresentation;
class vtkPVDataRepresentation;
class vtkPVView;
class vtkRelievoPointValues;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoPoints : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkPVRelievoPoints, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The representation, a vtkGeometryRepresentation. Given once, when its proxy is made. */
  void SetRepresentation(vtkPVDataRepresentation* representation);

  ///@{
  /** Whether the points are anything. Default off. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  ///@}

  ///@{
  /** How far each reaches, world units, for points without the array. Default 1. */
  virtual void SetRadius(double radius) = 0;
  virtual void SetColor(double red, double green, double blue) = 0;
  ///@}

  ///@{
  /** Point arrays that the values are taken from; empty: one for all. */
  void SetRadiusArray(const char* name) { this->SetArray("radius", name); }
  void SetColorArray(const char* name) { this->SetArray("color", name); }
  ///@}

  /** Whether any points in the view are anything. */
  static bool IsAny(vtkPVView* view);

  /** Gives the points that the representation draws, where it draws them; nullptr: none. */
  static void TakeInput(vtkGeometryRepresentation* representation, vtkRelievoPointValues* values);

  /** What the points are, as of vtkRelievoPointValues. */
  virtual vtkRelievoPointValues* GetValues() = 0;

protected:
  vtkPVRelievoPoints();
  ~vtkPVRelievoPoints() override;

  // Those that are on in the view, with the input of their representations.
  static std::vector<vtkPVRelievoPoints*> FindIn(vtkPVView* view);

  void SetArray(const std::string& value, const char* name);

  bool Enabled = false;

private:
  vtkPVRelievoPoints(const vtkPVRelievoPoints&) = delete;
  void operator=(const vtkPVRelievoPoints&) = delete;

  bool IsIn(vtkPVView* view);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
