// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSunExposure
 * @brief Hours of sun and irradiation on a mesh over a day, a season or a year, and its sky view
 * factor.
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
 * With Irradiance, also in kWh/m2 (float):
 * - irradiation: the sum of the next three;
 * - direct_irradiation, diffuse_irradiation, reflected_irradiation: from the sun, from the sky, and
 *   from the ground, which is everything below the horizon and reflects a share (Albedo) of the
 *   light of open level ground. Reflections between surfaces are not included;
 * - irradiation_bound: the largest error of the sampling; sun_hours_bound: that of sun_hours.
 *
 * Field data: possible_hours (double), hours of sun on open ground; with Irradiance also
 * open_irradiation (double), kWh/m2 on open level ground. Active scalars: sun_hours, or
 * irradiation.
 *
 * The light is that of a clear sky (P. Ineichen, R. Perez 2002, by Altitude and Turbidity), or of
 * weather data (WeatherFile, SetWeather), whose values are spread over the part of their interval
 * by day. With Irradiance all arrays but sky_view come from patches of the sky that are divided
 * until the bound is below Tolerance, or they are 0.3 degrees wide: no triangle meets a patch that
 * counts wholly, and triangles that share edges cover one that does not count. Others count by the
 * share of their free corners, and wholly in the bounds, which hold for occluders of any width.
 *
 * Each step counts by the sun's position in its middle; the last step of a day may be shorter, and
 * of steps with a sunrise or sunset only the part by day counts. Hours are exact to about one step
 * for each time that the sun appears or disappears behind something. The sun is a point; refraction
 * is ignored (vtkRelievoSolarPosition). Normals point outwards; a surface gets no light from
 * behind. Cells, convex or not, are evaluated at their middle, or within their largest triangle if
 * the middle lies outside; vertices and lines have 0. World units are arbitrary: north is z, -z or
 * y if x, y or z points up, turned by North.
 *
 * Rays are in double (vtkRelievoRayScene) and begin 1e-7 of the mesh's size in front of the
 * surface.
 *
 * Errors: an invalid date, an end before the start; an invalid time zone; unusable weather data.
 */
#ifndef vtkRelievoSunExposure_h
#define vtkRelievoSunExposure_h

#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for named parameters
#include "vtkRelievoSightAlgorithm.h"
#include "vtkRelievoText.h"  // for parameters' names and texts
#include "vtkSmartPointer.h" // for weather data

#include <string> // for error messages
#include <vector> // for the sun's positions

class vtkDataSetAttributes;
class vtkRelievoRayScene;
class vtkRelievoSurfacePlaces;
class vtkTable;

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
   * Year, month and day of the first and of the last day, both included, from midnight of the
   * clock (TimeZone). Default 2026, 6, 21 both.
   */
  vtkSetVector3Macro(FirstDay, int);
  vtkGetVector3Macro(FirstDay, int);
  vtkSetVector3Macro(LastDay, int);
  vtkGetVector3Macro(LastDay, int);
  ///@}

  /** The error of the weather file, which is read; empty if it is usable, or if there is none. */
  std::string CheckWeatherFile() const;

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
  /**
   * Only the light of the sun and the sky between two times of day counts, hours of the clock.
   * Default 0, 24.
   */
  vtkSetClampMacro(BeginHour, double, 0.0, 24.0);
  vtkGetMacro(BeginHour, double);
  vtkSetClampMacro(EndHour, double, 0.0, 24.0);
  vtkGetMacro(EndHour, double);
  ///@}

  ///@{
  /**
   * Only times with a sun that is at least as high count, degrees, 0 to 90, for the light of the
   * sky as well: EN 17037 asks for a height that depends on the place. Default 0.
   */
  vtkSetClampMacro(MinimumElevation, double, 0.0, 90.0);
  vtkGetMacro(MinimumElevation, double);
  ///@}

  ///@{
  /**
   * Hours by which the clock is ahead of universal time (UTC), -12 to 14, as text. Empty, the
   * default: with Irradiance those of the weather file, otherwise local mean time.
   */
  void SetTimeZone(RELIEVO_TEXT hours);
  const char* GetTimeZone() const { return this->TimeZone.c_str(); }
  ///@}

  ///@{
  /** Degrees by which north is turned, clockwise from above. Default 0. */
  vtkSetClampMacro(North, double, -360.0, 360.0);
  vtkGetMacro(North, double);
  ///@}

  ///@{
  /**
   * Whether to compute irradiation: 0 not (default), 1 by a uniform sky, 2 by the sky of Perez et
   * al. (1990).
   */
  vtkSetClampMacro(Irradiance, int, 0, 2);
  vtkGetMacro(Irradiance, int);
  ///@}

  ///@{
  /**
   * The largest error of irradiation, percent of its light from the sun and the sky, 0.1 to 20:
   * patches are divided until the bound is below, or they are 0.3 degrees wide. Default 1.
   */
  vtkSetClampMacro(Tolerance, double, 0.1, 20.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Share of light that the ground reflects, 0 to 1. Default 0.2. */
  vtkSetClampMacro(Albedo, double, 0.0, 1.0);
  vtkGetMacro(Albedo, double);
  ///@}

  ///@{
  /**
   * Linke's turbidity of the clear air, 1 to 10: 2 is clear and cold, 3 usual, 5 hazy. Default 3.
   */
  vtkSetClampMacro(Turbidity, double, 1.0, 10.0);
  vtkGetMacro(Turbidity, double);
  ///@}

  ///@{
  /** Metres above the sea, -500 to 9000. Default 0. */
  vtkSetClampMacro(Altitude, double, -500.0, 9000.0);
  vtkGetMacro(Altitude, double);
  ///@}

  ///@{
  /**
   * A weather file of EnergyPlus (EPW), whose hourly data replace the clear sky, by month and day.
   * Default: none.
   */
  void SetWeatherFile(RELIEVO_TEXT file);
  const char* GetWeatherFile() const { return this->WeatherFile.c_str(); }
  ///@}

  ///@{
  /**
   * Weather data that replace the clear sky, and the file: a table with the columns dhi (diffuse,
   * on level ground), and dni (direct, on a plane that faces the sun) or ghi (both, on level
   * ground), W/m2, the means of equal intervals from the first midnight to the last. Default: none.
   */
  void SetWeather(vtkTable* table);
  vtkTable* GetWeather();
  ///@}

  vtkMTimeType GetMTime() override;

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
   * Access to parameters by name, with values as text, as in vtkRelievoStage.
   */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoSunExposure();
  ~vtkRelievoSunExposure() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoSunExposure(const vtkRelievoSunExposure&) = delete;
  void operator=(const vtkRelievoSunExposure&) = delete;

  struct Sun;
  std::string GetSuns(std::vector<Sun>& suns) const;
  bool FindHours(const vtkRelievoSurfacePlaces& places, vtkRelievoRayScene* scene,
    const std::vector<Sun>& suns, double share, vtkDataSetAttributes* data);
  bool FindIrradiation(const vtkRelievoSurfacePlaces& places, vtkRelievoRayScene* scene,
    const std::vector<Sun>& suns, double share, vtkPolyData* output, vtkDataSetAttributes* data);
  bool FindSky(const vtkRelievoSurfacePlaces& places, vtkRelievoRayScene* scene, double share,
    vtkDataSetAttributes* data);
  bool Advance(double done);

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
  double BeginHour = 0.0;
  double EndHour = 24.0;
  double MinimumElevation = 0.0;
  std::string TimeZone;
  double North = 0.0;
  int Irradiance = 0;
  double Tolerance = 1.0;
  double Albedo = 0.2;
  double Turbidity = 3.0;
  double Altitude = 0.0;
  std::string WeatherFile;
  vtkSmartPointer<vtkTable> Weather;
};

#endif
