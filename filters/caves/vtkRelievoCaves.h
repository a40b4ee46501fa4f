// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCaves
 * @brief An image of winding caves, from a seed: a mask, a density, or labels for smooth blocks.
 *
 * Each point of the image is a sample of vtkRelievoCaveFunction, which defines the caves; its
 * settings are also here. A piece, or any extent, is made without its neighbours and equals that
 * part of the whole bit for bit, with any number of threads. Samples that the noise's slope proves
 * to be rock are not evaluated.
 *
 * Refused with an error, vtkErrorCode::UserError and an empty output: a size without points; an
 * origin or spacing that is not finite; tunnels wider than half of Scale; samples more than 5e8
 * cells of the noise from the origin; a function with a Transform, which only the function itself
 * applies; and images too large for the memory.
 */
#ifndef vtkRelievoCaves_h
#define vtkRelievoCaves_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for named parameters
#include "vtkRelievoText.h"            // for parameters' names and texts
#include "vtkSmartPointer.h"           // for the function

class vtkRelievoCaveFunction;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoCaves : public vtkImageAlgorithm
{
public:
  static vtkRelievoCaves* New();
  vtkTypeMacro(vtkRelievoCaves, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Also counts changes of the function. */
  vtkMTimeType GetMTime() override;

  enum ContentType
  {
    MASK = 0,
    DENSITY = 1,
    LABELS = 2
  };

  ///@{
  /**
   * The point array: "cave", 1 in the air and 0 in the rock (MASK, the default); "density", floats
   * from -1 in the middle of tunnels over 0 at their walls to 1 in the rock (DENSITY), for
   * contours; or "label", AirLabel and RockLabel (LABELS). Masks and labels are unsigned char.
   */
  vtkSetClampMacro(Content, int, MASK, LABELS);
  vtkGetMacro(Content, int);
  ///@}

  ///@{
  /** Labels of air and rock, 0 to 255. Default is 0 and 1. */
  vtkSetClampMacro(AirLabel, int, 0, 255);
  vtkGetMacro(AirLabel, int);
  vtkSetClampMacro(RockLabel, int, 0, 255);
  vtkGetMacro(RockLabel, int);
  ///@}

  ///@{
  /** Number of samples along each axis, from index 0. Default is 128 128 64. */
  vtkSetVector3Macro(Size, int);
  vtkGetVector3Macro(Size, int);
  ///@}

  ///@{
  /** The position of sample 0 0 0, and the distance between samples. Default is 0 0 0 and 1 1 1. */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  /**
   * The caves as an implicit function, which can also be sampled, contoured or used for clipping.
   * If it has a Transform, no image is made.
   */
  vtkRelievoCaveFunction* GetFunction();

  ///@{
  /** Settings of the function. */
  void SetSeed(int seed);
  int GetSeed();
  void SetScale(double scale);
  double GetScale();
  void SetVerticalScale(double scale);
  double GetVerticalScale();
  void SetUp(int axis);
  int GetUp();
  void SetTunnelWidth(double width);
  double GetTunnelWidth();
  void SetShell(double low, double high);
  void SetShell(const double shell[2]) VTK_SIZEHINT(2);
  double* GetShell() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /** Whether samples that are proven to be rock are skipped; the result is the same. Default is on.
   */
  vtkSetMacro(Skipping, bool);
  vtkGetMacro(Skipping, bool);
  vtkBooleanMacro(Skipping, bool);
  ///@}

  ///@{
  /**
   * Upper bound of the image's bytes; 0, the default: all free memory. A larger image is refused
   * before it is made.
   */
  vtkSetClampMacro(MemoryLimit, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** Access to parameters by name, with values as text, as in vtkRelievoStage. */
  vtkRelievoParametersMacro();
  ///@}

  ///@{
  /** Counts of the last update: evaluations of one noise, and samples in the air. */
  vtkGetMacro(NumberOfEvaluations, vtkTypeInt64);
  vtkGetMacro(NumberOfAirSamples, vtkTypeInt64);
  ///@}

protected:
  vtkRelievoCaves();
  ~vtkRelievoCaves() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkSmartPointer<vtkRelievoCaveFunction> Function;
  vtkRelievoParameterList Parameters;
  int Content = MASK;
  int AirLabel = 0;
  int RockLabel = 1;
  int Size[3] = { 128, 128, 64 };
  double Origin[3] = { 0., 0., 0. };
  double Spacing[3] = { 1., 1., 1. };
  bool Skipping = true;
  double MemoryLimit = 0.;
  vtkTypeInt64 NumberOfEvaluations = 0;
  vtkTypeInt64 NumberOfAirSamples = 0;
  vtkMTimeType RefusedAt = 0; // MTime of the refused settings

  vtkRelievoCaves(const vtkRelievoCaves&) = delete;
  void operator=(const vtkRelievoCaves&) = delete;
};

#endif
