// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSunExposure
 * @brief Hours of sun on a mesh over a day, a season or a year, and its sky view factor.
 *
 * Input 0: a vtkPolyData. Input 1 (optional, repeatable): data sets that also cast shade. Output:
 * the mesh with arrays on its cells, or on its points:
 * - sun_hours (float): hours in which the sun's centre is above the horizon and in front of the
 *   surface, without an occluder;
 * - insolation (float): these hours times the cosine between the sun and the surface's normal,
 *   which is the equivalent number of hours at perpendicular incidence;
 * - sky_view (float), if SkySamples is not 0: the share of the light of a uniform sky that arrives,
 *   0 to 1: 1 on open level ground, 1/2 on an open wall.
 *
 * Field data: possible_hours (double), hours of sun on open ground. Active scalars: sun_hours.
 *
 * Each step counts by the sun's position in its middle; the last step of a day may be shorter, and
 * of steps with a sunrise or sunset only the part by day counts. Hours are exact to about one step
 * for each time that the sun appears or disappears behind something. The sun is a point; refraction
 * is ignored (vtkRelievoSolarPosition). Normals point outwards; a surface gets no sun from behind.
 * Cells, convex or not, are evaluated at their middle, or within their largest triangle if the
 * middle lies outside; vertices and lines have 0. World units are arbitrary: north is z, -z or y if
 * x, y or z points up.
 *
 * Rays are in double (vtkRelievoRayScene) and begin 1e-7 of the mesh's size in front of the
 * surface.
 *
 * Errors: an invalid date, an end before the start.
 */
#ifndef vtkRelievoSunExposure_h
#define vtkRelievoSunExposure_h

#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for named parameters
#include "vtkRelievoSightAlgorithm.h"
#include "vtkRelievoText.h" // for parameters' names and texts

#include <string> // for error messages
#include <vector> // for the sun's positions

class VTKRELIEVOFILTERS_EXPORT vtkRelievoSunExposure : public vtkRelievoSightAlgorithm
{
public:
  static vtkRelievoSunExposure* New();
  vtkTypeMacro(vtkRelievoSunExposure, vtkRelievoSightAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Degrees; north and east are positive. Default 48, 0. */
  vtkSetClampMacro(Latitude, double, -90.0, 90.0);
  vtkGetMacro(Latitude, double);
  vtkSetMacro(Longitude, double);
  vtkGetMacro(Longitude, double);
  ///@}

  ///@{
  /**
   * Year, month and day of the first and of the last day, both included, from midnight of local
   * mean time. Default 2026, 6, 21 both.
   */
  vtkSetVector3Macro(FirstDay, int);
  vtkGetVector3Macro(FirstDay, int);
  vtkSetVector3Macro(LastDay, int);
  vtkGetVector3Macro(LastDay, int);
  ///@}

  /** The error of a first and a last day: "got ..., expected ..."; empty if both are valid. */
  static std::string CheckDays(const int first[3], const int last[3]);

  ///@{
  /**
   * Only every DayStep-th day is computed and counts DayStep times; 7 suffices for a year. 1 to
   * 366; default 1.
   */
  vtkSetClampMacro(DayStep, int, 1, 366);
  vtkGetMacro(DayStep, int);
  ///@}

  ///@{
  /** Minutes between positions of the sun, 0.1 to 240. Default 20. */
  vtkSetClampMacro(Step, double, 0.1, 240.0);
  vtkGetMacro(Step, double);
  ///@}

  ///@{
  /** Which axis points up: 0 x, 1 y (default), 2 z. */
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /** Whether to evaluate points instead of cells. Default off. */
  vtkSetMacro(Points, bool);
  vtkGetMacro(Points, bool);
  vtkBooleanMacro(Points, bool);
  ///@}

  ///@{
  /**
   * Rays into the sky for each position, 0 to 65536; 0, the default: no sky_view. Its error is
   * about 1 / SkySamples for simple horizons.
   */
  vtkSetClampMacro(SkySamples, int, 0, 65536);
  vtkGetMacro(SkySamples, int);
  ///@}

  ///@{
  /**
   * Access to parameters by name, with values as text, as in vtkRelievoStage; the days are not
   * included.
   */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoSunExposure();
  ~vtkRelievoSunExposure() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoSunExposure(const vtkRelievoSunExposure&) = delete;
  void operator=(const vtkRelievoSunExposure&) = delete;

  struct Sun;
  std::vector<Sun> GetSuns() const;

  vtkRelievoParameterList Parameters;
  double Latitude = 48.0;
  double Longitude = 0.0;
  int FirstDay[3] = { 2026, 6, 21 };
  int LastDay[3] = { 2026, 6, 21 };
  int DayStep = 1;
  double Step = 20.0;
  int UpAxis = 1;
  bool Points = false;
  int SkySamples = 0;
};

#endif
