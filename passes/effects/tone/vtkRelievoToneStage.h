// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoToneStage
 * @brief The stage that makes the picture from the linear colour: exposure, tone operator,
 * dithering.
 *
 * The linear colour has highlights above 1. The stage multiplies it by the exposure, maps it to [0,
 * 1] by the operator, encodes it by the sRGB curve, and rounds it to 8 bits; without the
 * stage only the curve applies. The layer `color` is not changed.
 *
 * Each pixel depends only on its own colour, and with AutoExposure on one number of this frame.
 * Negative components and NaN count as 0, infinite ones as 65504.
 *
 * Where alpha is below 1, and the renderer's background is black or otherwise premultiplied (no
 * component above its alpha), the stage maps the colour divided by alpha. Over other backgrounds
 * VTK's colours contain the background whatever their alpha, and are mapped unchanged.
 *
 * With the operator CLAMP, Exposure 0, and neither AutoExposure nor Dither, the stage is idle.
 * Beside VTK's own vtkToneMappingPass it does not run, and reports an error.
 */
#ifndef vtkRelievoToneStage_h
#define vtkRelievoToneStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <memory> // for the internals

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoToneStage : public vtkRelievoStage
{
public:
  static vtkRelievoToneStage* New();
  vtkTypeMacro(vtkRelievoToneStage, vtkRelievoStage);

  /** Operators, for linear light x. */
  enum Operators
  {
    CLAMP = 0,        ///< min(x, 1)
    SIMPLE = 1,       ///< x / (1 + x), for each component
    REINHARD = 2,     ///< x (1 + x / White^2) / (1 + x) of the luminance: keeps the hue
    REINHARD_RGB = 3, ///< the same for each component: shifts the hue of bright colours
    NEUTRAL = 4 ///< Khronos PBR Neutral (2024): light below 0.8 stays, brighter light is compressed
  };

  ///@{
  /** Maps light to [0, 1]. Default NEUTRAL. */
  vtkSetClampMacro(Operator, int, CLAMP, NEUTRAL);
  vtkGetMacro(Operator, int);
  void SetOperatorToClamp() { this->SetOperator(CLAMP); }
  void SetOperatorToSimple() { this->SetOperator(SIMPLE); }
  void SetOperatorToReinhard() { this->SetOperator(REINHARD); }
  void SetOperatorToReinhardRgb() { this->SetOperator(REINHARD_RGB); }
  void SetOperatorToNeutral() { this->SetOperator(NEUTRAL); }
  ///@}

  ///@{
  /**
   * The smallest luminance (REINHARD) or component (REINHARD_RGB) shown as 1, after exposure, from
   * 0.01 to 65504. Default 4.
   */
  vtkSetClampMacro(White, double, 0.01, 65504.0);
  vtkGetMacro(White, double);
  ///@}

  ///@{
  /** Stops: the light is multiplied by 2 to this power, from -20 to 20. Default 0. */
  vtkSetClampMacro(Exposure, double, -20.0, 20.0);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Whether the light is first scaled such that its log-average luminance becomes 0.18, over the
   * drawn pixels (opaque, or more so than the background), or over all pixels if none is drawn;
   * Exposure is then a correction. Measured from the frame's own colour, never from earlier frames.
   * Luminance below 0.0003, black in 8 bits, counts as 0.0003; pixels with negative, infinite or
   * NaN components are left out. Default off.
   */
  vtkSetMacro(AutoExposure, bool);
  vtkGetMacro(AutoExposure, bool);
  vtkBooleanMacro(AutoExposure, bool);
  ///@}

  /** Kinds of dithering. */
  enum Ditherings
  {
    DITHER_NONE = 0,      ///< to the nearest of 256 steps, as OpenGL rounds
    DITHER_ORDERED = 1,   ///< Bayer's matrix of 8 x 8
    DITHER_BLUE_NOISE = 2 ///< 64 x 64 thresholds without low frequencies, by void and cluster
  };

  ///@{
  /**
   * Rounding to 8 bits: by thresholds that depend only on the pixel's position in the viewport, so
   * that slow gradients have no bands. Default DITHER_NONE.
   */
  vtkSetClampMacro(Dither, int, DITHER_NONE, DITHER_BLUE_NOISE);
  vtkGetMacro(Dither, int);
  void SetDitherToNone() { this->SetDither(DITHER_NONE); }
  void SetDitherToOrdered() { this->SetDither(DITHER_ORDERED); }
  void SetDitherToBlueNoise() { this->SetDither(DITHER_BLUE_NOISE); }
  ///@}

  /** Whether the picture differs from the sRGB curve alone. */
  bool GetChangesPicture();

  /**
   * Stops by which the last picture's light was multiplied, read back from the GPU with
   * AutoExposure; NaN if none was measured, or the stage is off.
   */
  double GetUsedExposure();

  /**
   * Threshold of the blue noise at a pixel, between 0 and 1, both excluded; repeats every 64
   * pixels.
   */
  static double GetBlueNoise(int x, int y);

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoToneStage();
  ~vtkRelievoToneStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;

  int Operator = NEUTRAL;
  double White = 4.0;
  double Exposure = 0.0;
  bool AutoExposure = false;
  int Dither = DITHER_NONE;

private:
  vtkRelievoToneStage(const vtkRelievoToneStage&) = delete;
  void operator=(const vtkRelievoToneStage&) = delete;

  bool HasWork() const;
  void Fail(const std::string& error);
  void UploadThresholds(vtkRelievoFrameContext& context);
  const float* ToneBackground(const vtkRelievoFrameContext& context, float color[4]) const;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
