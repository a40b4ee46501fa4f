// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoShadowCertificate
 * @brief How many of a picture's shadow verdicts are wrong: what vtkRelievoShadowStage::Certify
 * found.
 *
 * A verdict is that of one pixel about one light. It is judged against a ray from the pixel's
 * place to the light, in double precision, past the casters' own triangles: wrong if the layer
 * shadow_N is on the other side of one half, or, where translucent casters attenuate, off by more
 * than 0.02.
 *
 * Counted apart, and no part of any share:
 * - ties: within the pixel's own rounding, 1/256 of a pixel each way, to which OpenGL places edges,
 *   the verdict of the ray changes, another triangle is seen that has another, or the surface ends;
 *   it does not depend on what was drawn;
 * - grazing: the surface is turned away from the light, or nearly so (n.l at most 0.05);
 * - unlit: outside a spot's cone, beyond a light's reach, or on what receives no shadows;
 * - unknown: what is seen there, or may be between it and the light, cannot be followed triangle by
 *   triangle (points, lines, impostors, cut-outs, clipping planes, shaders of one's own).
 */
#ifndef vtkRelievoShadowCertificate_h
#define vtkRelievoShadowCertificate_h

#include "vtkObject.h"
#include "vtkRelievoShadowsModule.h" // for the export macro

#include <string> // for the words

class VTKRELIEVOSHADOWS_EXPORT vtkRelievoShadowCertificate : public vtkObject
{
public:
  static vtkRelievoShadowCertificate* New();
  vtkTypeMacro(vtkRelievoShadowCertificate, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Verdicts that were judged; of these the wrong ones: lit, but drawn dark, and dark but lit. */
  vtkGetMacro(Judged, long long);
  long long GetWrong() { return this->FalseShadow + this->FalseLight; }
  vtkGetMacro(FalseShadow, long long);
  vtkGetMacro(FalseLight, long long);
  ///@}

  ///@{
  /** Verdicts that were drawn by lot as well, and counted apart. */
  vtkGetMacro(Ties, long long);
  vtkGetMacro(Grazing, long long);
  vtkGetMacro(Unlit, long long);
  vtkGetMacro(Unknown, long long);
  ///@}

  /** The share of the judged verdicts that is wrong, 0 to 1; NaN if none was judged. */
  double GetWrongShare();

  /** GetBound of what was judged, with a confidence of 0.95. */
  double GetWrongShareBound();

  /**
   * The upper bound of the share in all, after `wrong` of `judged` drawn by lot were found wrong: a
   * larger share would have shown so few of them with a probability of at most 1 - confidence (C.
   * Clopper, E. Pearson, The use of confidence or fiducial limits, 1934; one-sided). Of n without
   * an error it is close to 3 / n. 1 if nothing was judged; NaN, with a warning, for negative
   * numbers, more wrong than judged, or a confidence that is not between 0 and 1.
   */
  static double GetBound(long long wrong, long long judged, double confidence = 0.95);

  /** All of it in a sentence. */
  std::string GetWords();

protected:
  vtkRelievoShadowCertificate() = default;
  ~vtkRelievoShadowCertificate() override = default;

  friend class vtkRelievoShadowCertifier;

  long long Judged = 0;
  long long FalseShadow = 0;
  long long FalseLight = 0;
  long long Ties = 0;
  long long Grazing = 0;
  long long Unlit = 0;
  long long Unknown = 0;

private:
  vtkRelievoShadowCertificate(const vtkRelievoShadowCertificate&) = delete;
  void operator=(const vtkRelievoShadowCertificate&) = delete;
};

#endif
