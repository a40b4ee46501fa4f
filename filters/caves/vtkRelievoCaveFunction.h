// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCaveFunction
 * @brief Winding caves as an implicit function: below 0 in the air of tunnels, above in the rock.
 *
 * Air is where two simplex noises of different seeds both lie in a shell, between two thresholds:
 * each shell is a winding sheet, and tunnels are where two sheets cross. The value is the larger
 * distance of both noises from the middle of the shell, as part of half its thickness, less 1: -1
 * in the middle of a tunnel, 0 at its walls. Each place is evaluated by itself, so any region can
 * be made without its neighbours, and threads may share the function.
 *
 * The noise has cells of integers: far from the origin nothing is lost but the digits that doubles
 * do not have, and caves begin again after 2^30 cells along each axis, from 2^29 cells around the
 * origin. A place that is not finite is rock.
 *
 * Settings that make no sense (NaN, infinite, thresholds that are not in order) are refused with an
 * error and leave the last ones.
 */
#ifndef vtkRelievoCaveFunction_h
#define vtkRelievoCaveFunction_h

#include "vtkImplicitFunction.h"
#include "vtkRelievoFiltersModule.h" // for the export macro

namespace relievo
{
struct CaveField;
}
struct vtkRelievoParameterList;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoCaveFunction : public vtkImplicitFunction
{
public:
  static vtkRelievoCaveFunction* New();
  vtkTypeMacro(vtkRelievoCaveFunction, vtkImplicitFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Seed of the noises, any integer; another seed gives other caves. Default is 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Size of the noise's cells along the ground, in world units, which sets the distance between the
   * bends of tunnels. Default is 64; above 0.
   */
  void SetScale(double scale);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /** Ratio of the width of caves to their height. Default is 2; above 0. */
  void SetVerticalScale(double scale);
  vtkGetMacro(VerticalScale, double);
  ///@}

  ///@{
  /** The axis that points up: 0, 1, or 2 (the default). */
  vtkSetClampMacro(Up, int, 0, 2);
  vtkGetMacro(Up, int);
  ///@}

  ///@{
  /**
   * Width of tunnels in world units, from which the thresholds follow: the mean length of air along
   * level lines, which is the side of a square tunnel. At most half of Scale; larger values count
   * as that. 0: use Shell. Default is 6.
   */
  void SetTunnelWidth(double width);
  vtkGetMacro(TunnelWidth, double);
  ///@}

  ///@{
  /**
   * The thresholds, used if TunnelWidth is 0, for both noises; the noises' values are in [-1, 1]
   * and densest around 0. The lower comes first. Default is -0.1 0.1.
   */
  void SetShell(double low, double high);
  void SetShell(const double shell[2]) VTK_SIZEHINT(2) { this->SetShell(shell[0], shell[1]); }
  vtkGetVector2Macro(Shell, double);
  ///@}

  /** The thresholds in use: Shell, or those of TunnelWidth. */
  void GetThresholds(double thresholds[2]) VTK_SIZEHINT(2);

  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double point[3]) override;

  /** Evaluates many points; VTK's own method reads arrays that do not exist. */
  void EvaluateFunction(vtkDataArray* points, vtkDataArray* values) override;

  /** The gradient, per world unit. */
  void EvaluateGradient(double point[3], double gradient[3]) override;

#ifndef __VTK_WRAP__
  ///@{
  /** For vtkRelievoCaves. */
  relievo::CaveField GetField() const;
  void Describe(vtkRelievoParameterList& list);
  ///@}
#endif

protected:
  vtkRelievoCaveFunction() = default;
  ~vtkRelievoCaveFunction() override = default;

private:
  void SetLength(const char* name, double& member, double value, bool orZero);

  int Seed = 0;
  double Scale = 64.;
  double VerticalScale = 2.;
  int Up = 2;
  double TunnelWidth = 6.;
  double Shell[2] = { -0.1, 0.1 };

  vtkRelievoCaveFunction(const vtkRelievoCaveFunction&) = delete;
  void operator=(const vtkRelievoCaveFunction&) = delete;
};

#endif
