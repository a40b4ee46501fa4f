// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSunExposure
 * @brief Hours of sun on a mesh over a day, a season or a year, and how much of the sky it sees.
 *
 * Input 0: a vtkPolyData. Input 1 (by choice, several): what shades it as well, data sets. Output:
 * the mesh with arrays of its cells, or of its points:
 * - sun_hours (float): hours in which the sun's centre is above the horizon and before the surface,
 *   and nothing lies between;
 * - insolation (float): these hours, each times the cosine between the sun and the surface's
 *   normal: hours of sun at right angles that would bring as much;
 * - sky_view (float), if SkySamples is not 0: the share of the light of an even sky that arrives,
 *   0 to 1: 1 on open level ground, 1/2 on an open wall.
 *
 * Field data: possible_hours (double), hours of sun on open ground. Active scalars: sun_hours.
 *
 * Steps of time, the last of a day shorter if it must be, count by the sun in their middle; of the
 * steps in which the sun rises or sets, the part by day counts. Hours are right to about a step for
 * each time that the sun appears behind something or is hidden. The sun is a point; refraction is
 * left out (vtkRelievoSolarPosition). Normals point outwards; a surface gets no sun from behind.
 * Cells, convex or not, are judged at their middles, or within their largest triangle where the
 * middle lies outside; vertices and lines have 0. The world is in any unit: north is
 * z, -z or y where x, y or z points up.
 *
 * Rays are in double (vtkRelievoRayScene) and begin 1e-7 of the mesh's size before the surface.
 *
 * Errors: a date that is none, an end before the start.
 */
#ifndef vtkRelievoSunExposure_h
#define vtkRelievoSunExposure_h

#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoSightAlgorithm.h"
#include "vtkRelievoText.h" // for their names and words

#include <string> // for what is wrong
#include <vector> // for the sun's places

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
   * Year, month and day of the first and of the last day, which both count, from midnight of local
   * mean time. Default 2026, 6, 21 both.
   */
  vtkSetVector3Macro(FirstDay, int);
  vtkGetVector3Macro(FirstDay, int);
  vtkSetVector3Macro(LastDay, int);
  vtkGetVector3Macro(LastDay, int);
  ///@}

  /** What is wrong with a first and a last day: "got ..., expected ..."; empty if nothing is. */
  static std::string CheckDays(const int first[3], const int last[3]);

  ///@{
  /** Every so many days count, each for as many; for a year 7 will do. 1 to 366; default 1. */
  vtkSetClampMacro(DayStep, int, 1, 366);
  vtkGetMacro(DayStep, int);
  ///@}

  ///@{
  /** Minutes from one place of the sun to the next, 0.1 to 240. Default 20. */
  vtkSetClampMacro(Step, double, 0.1, 240.0);
  vtkGetMacro(Step, double);
  ///@}

  ///@{
  /** Which axis points up: 0 x, 1 y (default), 2 z. */
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /** Whether points are judged rather than cells. Default off. */
  vtkSetMacro(Points, bool);
  vtkGetMacro(Points, bool);
  vtkBooleanMacro(Points, bool);
  ///@}

  ///@{
  /**
   * Rays into the sky for each place, 0 to 65536; 0, the default: no sky_view. Its error is about
   * 1 / SkySamples for simple horizons.
   */
  vtkSetClampMacro(SkySamples, int, 0, 65536);
  vtkGetMacro(SkySamples, int);
  ///@}

  ///@{
  /** Parameters by name, with values in words, as of vtkRelievoStage; the days are none. */
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
