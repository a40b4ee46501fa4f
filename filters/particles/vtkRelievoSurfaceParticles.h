// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSurfaceParticles
 * @brief Particles moved by a field, held on a surface or inside it by depth maps.
 *
 * Input 0: the surface, a data set or a composite of them; data sets other than vtkPolyData count
 * by their outer surface. Six views see it. Inputs that change in time count at their first time.
 *
 * Input 1, optional: depth images of parallel projection, from any sides, with the layer `depth`
 * and the field data of captures (vtkRelievoLayerSource, vtkRelievoDepthViews). They then replace
 * the surface.
 *
 * Input 2, optional: points where particles start, each moved to the nearest visible position.
 * Their point data are copied; arrays with the names of the output's own are left out, with a
 * warning. Without this input, particles are spread evenly.
 *
 * Input 3, optional: the data that have FieldArray; by default, input 0.
 *
 * Output: vtkPolyData with a vertex for each particle, and the point arrays `velocity` (3 float),
 * `particle` (its number) and, on a surface, `normal` (3 float), to which glyphs can be aligned.
 *
 * The filter has time steps. Particles at a time depend only on the inputs, the settings and the
 * time, and not on the times requested before or the number of threads and pieces. Each piece has
 * its part of the particles, and needs the whole surface.
 *
 * On a surface, each particle is within one texel of a position that a view sees. Where its view
 * ends, at silhouettes and steps of depth, it passes to a surface that another view sees within 1.5
 * texels, or stays there. Inside, a particle that gets out is pushed back against the normal. The
 * inside is the space that no view sees in front of its surface, so hidden hollows belong to it. A
 * particle moves half a texel at once, and at most 256 texels per step. Where the field is not
 * finite it is 0.
 *
 * Errors: no input, an unknown array, invalid depth images, more memory than MemoryLimit. A surface
 * that covers no texel has no particles; that is no error.
 */
#ifndef vtkRelievoSurfaceParticles_h
#define vtkRelievoSurfaceParticles_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

#include <memory> // for the internals
#include <string> // for a name

class VTKRELIEVOFILTERS_EXPORT vtkRelievoSurfaceParticles : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoSurfaceParticles* New();
  vtkTypeMacro(vtkRelievoSurfaceParticles, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PlaceType
  {
    ON_SURFACE = 0,
    INSIDE = 1
  };

  ///@{
  /** Where particles move. Default is ON_SURFACE. */
  vtkSetClampMacro(Place, int, ON_SURFACE, INSIDE);
  vtkGetMacro(Place, int);
  ///@}

  ///@{
  /** Number of particles if no points are given. Default is 10000. */
  vtkSetClampMacro(NumberOfParticles, vtkIdType, 0, VTK_ID_MAX / 64);
  vtkGetMacro(NumberOfParticles, vtkIdType);
  ///@}

  ///@{
  /** Seed of starting positions and of noise. Default is 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** Texels along the longest side of the surface's box. Default is 256. */
  vtkSetClampMacro(Resolution, int, 1, 16384);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /** Side of the texels in world units. Default 0: set by Resolution. */
  vtkSetClampMacro(TexelSize, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(TexelSize, double);
  ///@}

  ///@{
  /**
   * A constant velocity, in world units per unit of time. Default 0 0 0. This, the noise and the
   * array add up; on a surface, particles move by the tangential part of the sum.
   */
  vtkSetVector3Macro(Velocity, double);
  vtkGetVector3Macro(Velocity, double);
  ///@}

  ///@{
  /**
   * Rms speed of the curl of simplex noise, which has no sources and sinks, in world units per unit
   * of time. Negative: a hundredth of the longest side. Default is 0.
   */
  vtkSetMacro(NoiseSpeed, double);
  vtkGetMacro(NoiseSpeed, double);
  ///@}

  ///@{
  /** Width of the noise's whirls in world units. Default 0: a fifth of the longest side. */
  vtkSetClampMacro(NoiseScale, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseScale, double);
  ///@}

  ///@{
  /**
   * The name of an array of 3 components at points or cells, in world units per unit of time. It is
   * interpolated between points; off the data, the nearest position counts, but outside a
   * vtkImageData the field is 0. Default is empty: none.
   */
  void SetFieldArray(const char* name);
  const char* GetFieldArray() { return this->FieldArray.c_str(); }
  ///@}

  ///@{
  /** The time at which particles start. Default is 0. */
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /** Duration of a step. Default is 1. Times between steps are possible. */
  vtkSetClampMacro(TimeStep, double, VTK_DBL_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /** Number of steps. Default is 100. Later times give the last step, earlier ones the start. */
  vtkSetClampMacro(NumberOfSteps, int, 0, 100000000);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Number of steps to cache, so that earlier times need not be computed from the start; each takes
   * 25 bytes per particle. Default is 4.
   */
  vtkSetClampMacro(Checkpoints, int, 0, 10000);
  vtkGetMacro(Checkpoints, int);
  ///@}

  ///@{
  /**
   * Whether the output has the point array `orientation` (quaternions w x y z, 4 float), which
   * rotates x to the normal and y to the velocity, for vtkGlyph3DMapper. Only on a surface. Default
   * is off.
   */
  vtkSetMacro(Orientations, bool);
  vtkGetMacro(Orientations, bool);
  vtkBooleanMacro(Orientations, bool);
  ///@}

  ///@{
  /**
   * Upper bound of the bytes of maps and particles; 0, the default: all free memory. If more are
   * needed, nothing is made.
   */
  vtkSetClampMacro(MemoryLimit, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /** The largest side of a texel in the last update: an upper bound of errors. */
  double GetUsedTexelSize();

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoSurfaceParticles();
  ~vtkRelievoSurfaceParticles() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
  int Place = ON_SURFACE;
  vtkIdType NumberOfParticles = 10000;
  int Seed = 0;
  int Resolution = 256;
  double TexelSize = 0.;
  double Velocity[3] = { 0., 0., 0. };
  double NoiseSpeed = 0.;
  double NoiseScale = 0.;
  std::string FieldArray;
  double StartTime = 0.;
  double TimeStep = 1.;
  int NumberOfSteps = 100;
  int Checkpoints = 4;
  bool Orientations = false;
  double MemoryLimit = 0.;
  vtkRelievoParameterList Parameters;

  vtkRelievoSurfaceParticles(const vtkRelievoSurfaceParticles&) = delete;
  void operator=(const vtkRelievoSurfaceParticles&) = delete;
};

#endif
