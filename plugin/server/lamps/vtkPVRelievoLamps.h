// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoLamps
 * @brief The points of one of ParaView's surface representations as lamps, on one process.
 *
 * While it is on and the representation is visible, each point of what it draws is a lamp
 * (vtkRelievoLamps) of its view's frame. With several ranks, the points of each light what all
 * draw.
 *
 * Every setting is a property of the representation's proxy (lamps.xml). A value out of its range
 * is brought into it, with a warning that says so.
 */
#ifndef vtkPVRelievoLamps_h
#define vtkPVRelievoLamps_h

#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

#include <memory> // for the internals

class vtkMultiProcessController;
class vtkPVDataRepresentation;
class vtkPVView;
class vtkRelievoLampsStage;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoLamps : public vtkObject
{
public:
  static vtkPVRelievoLamps* New();
  vtkTypeMacro(vtkPVRelievoLamps, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The representation, a vtkGeometryRepresentation. Given once, when its proxy is made. */
  void SetRepresentation(vtkPVDataRepresentation* representation);

  ///@{
  /** Whether the points are lamps. Default off. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  ///@}

  ///@{
  /** As of vtkRelievoLamps. */
  void SetRadius(double radius);
  void SetIntensity(double intensity);
  void SetColor(double red, double green, double blue);
  void SetFalloff(int falloff);
  void SetAttenuation(double constant, double linear, double quadratic);
  ///@}

  ///@{
  /** Point arrays that the values are taken from; empty: one for all. */
  void SetRadiusArray(const char* name);
  void SetIntensityArray(const char* name);
  void SetColorArray(const char* name);
  ///@}

  /** Whether any points in the view are lamps. */
  static bool IsAny(vtkPVView* view);

  /** Before each picture: gives the stage the lamps in the view. */
  static void Prepare(
    vtkPVView* view, vtkRelievoLampsStage* stage, vtkMultiProcessController* controller);

protected:
  vtkPVRelievoLamps();
  ~vtkPVRelievoLamps() override;

  bool Enabled = false;

private:
  vtkPVRelievoLamps(const vtkPVRelievoLamps&) = delete;
  void operator=(const vtkPVRelievoLamps&) = delete;

  bool IsIn(vtkPVView* view);
  void TakeInput();
  void SetArray(const char* value, const char* name);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
