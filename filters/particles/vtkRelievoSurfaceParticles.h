// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSurfaceParticles
 * @brief Particles that a field moves, and that depth maps hold on a surface or inside it.
 *
 * Input 0: the surface: a data set or a composite of them; of what is not a vtkPolyData, the outer
 * surface counts. It is seen from six sides. Of inputs that change in time, the first time counts.
 *
 * Input 1, optional: depth images of parallel projection, from any sides, with the layer `depth`
 * and the field data of captures (vtkRelievoLayerSource, vtkRelievoDepthViews). They then take the
 * place of the surface.
 *
 * Input 2, optional: points where particles start, each at the nearest place that is seen. Their
 * point data go along; arrays with the names of the output's own are left out, with a warning.
 * Without them particles are spread evenly.
 *
 * Input 3, optional: the data that have FieldArray; without it, they are those of input 0.
 *
 * Output: vtkPolyData with a vertex for each particle, and the point arrays `velocity` (3 float),
 * `particle` (its number) and, on a surface, `normal` (3 float), which glyphs may be aligned to.
 *
 * The filter has time steps. Particles at a time are a function of the inputs, the settings and the
 * time, whichever times were asked for before, whatever the number of threads and pieces. Each
 * piece has its part of the particles, and needs the whole surface.
 *
 * On a surface, each particle is within one texel of a place that a view sees. Where its view sees
 * no more, at silhouettes and steps of depth, it goes over to what another view sees within 1.5
 * texels, or stays there. Inside, a particle that gets out is pushed back against the normal;
 * inside is what no view sees before its surface, so hollows that are not seen are a part of it. A
 * particle moves half a texel at once, and at most 256 texels a step. Where the field is not
 * finite it is 0.
 *
 * Errors: no input, an unknown array, depth images that do not fit, more memory than MemoryLimit. A
 * surface that covers no texel has no particles; that is none.
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
  /** Where particles are held. Default is ON_SURFACE. */
  vtkSetClampMacro(Place, int, ON_SURFACE, INSIDE);
  vtkGetMacro(Place, int);
  ///@}

  ///@{
  /** How many there are, where no points are given. Default is 10000. */
  vtkSetClampMacro(NumberOfParticles, vtkIdType, 0, VTK_ID_MAX / 64);
  vtkGetMacro(NumberOfParticles, vtkIdType);
  ///@}

  ///@{
  /** Of places to start at, and of noise. Default is 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** Texels along the longest side of the surface's box. Default is 256. */
  vtkSetClampMacro(Resolution, int, 1, 16384);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /** Side of the texels in world units. Default 0: by Resolution. */
  vtkSetClampMacro(TexelSize, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(TexelSize, double);
  ///@}

  ///@{
  /**
   * A velocity that is equal everywhere, in world units per unit of time. Default 0 0 0. This, the
   * noise and the array add up; on a surface, particles move by what is tangential of them.
   */
  vtkSetVector3Macro(Velocity, double);
  vtkGetVector3Macro(Velocity, double);
  ///@}

  ///@{
  /**
   * Speed (rms) by the curl of simplex noise, which has no sources and sinks, in world units per
   * unit of time. Negative: a hundredth of the longest side. Default is 0.
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
   * The name of an array of 3 components at points or cells, in world units per unit of time.
   * Between points it is interpolated; off the data, the nearest place counts, but beyond a
   * vtkImageData there is 0. Default is empty: none.
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
  /** From one step to the next. Default is 1. Times between steps are possible. */
  vtkSetClampMacro(TimeStep, double, VTK_DBL_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /** Steps that there are. Default is 100. Later times are the last, and earlier ones the start. */
  vtkSetClampMacro(NumberOfSteps, int, 0, 100000000);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Steps that are kept, so that earlier times need not be computed from the start, each with 25
   * bytes a particle. Default is 4.
   */
  vtkSetClampMacro(Checkpoints, int, 0, 10000);
  vtkGetMacro(Checkpoints, int);
  ///@}

  ///@{
  /**
   * Whether there is the point array `orientation` (quaternions w x y z, 4 float), which turns x to
   * the normal and y to the velocity, for vtkGlyph3DMapper. On a surface only. Default is off.
   */
  vtkSetMacro(Orientations, bool);
  vtkGetMacro(Orientations, bool);
  vtkBooleanMacro(Orientations, bool);
  ///@}

  ///@{
  /**
   * The most bytes that maps and particles may take; 0, the default: what the machine has left.
   * More are refused before they are made.
   */
  vtkSetClampMacro(MemoryLimit, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /** Side of a texel in the last update, the largest where they differ: what errors are below. */
  double GetUsedTexelSize();

  ///@{
  /** Parameters by name, with values in words, as of vtkRelievoStage. */
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
  std::unique_ptr<Internals> Self;
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
