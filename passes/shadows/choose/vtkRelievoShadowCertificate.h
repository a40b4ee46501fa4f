// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoShadowCertificate
 * @brief The share of wrong shadow verdicts in a picture, found by vtkRelievoShadowStage::Certify.
 *
 * A verdict states whether one pixel is lit by one light. It is compared with a ray from the
 * pixel's surface to the light, in double precision, past the casters' own triangles: it is wrong
 * if the layer shadow_N is on the other side of one half, or, with attenuating translucent casters,
 * off by more than 0.02. Volumes dim the light: the share that passes them is traced in double
 * through their scalars and opacity functions, and the verdict is also wrong if the layer is off by
 * more than 0.02 from it.
 *
 * Counted separately, and not part of any share:
 * - ties: within the pixel's own rounding, 1/256 of a pixel in each direction, OpenGL's step for
 *   edges, the ray's verdict changes, another triangle with another verdict is visible, or the
 *   surface ends; this does not depend on the drawn verdict;
 * - grazing: the surface is turned away from the light, or nearly so (n.l at most 0.05);
 * - unlit: outside a spot's cone, beyond a light's reach, or on a surface without shadows;
 * - unknown: the surface, or a possible caster between it and the light, cannot be traced triangle
 * by
 *   triangle (points, lines, impostors, cut-outs, clipping planes, custom shaders).
 */
#ifndef vtkRelievoShadowCertificate_h
#define vtkRelievoShadowCertificate_h

#include "vtkObject.h"
#include "vtkRelievoShadowsModule.h" // for the export macro

#include <string> // for the sentence

class VTKRELIEVOSHADOWS_EXPORT vtkRelievoShadowCertificate : public vtkObject
{
public:
  static vtkRelievoShadowCertificate* New();
  vtkTypeMacro(vtkRelievoShadowCertificate, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Judged verdicts, and the wrong ones among them: drawn dark but lit, and drawn lit but dark. */
  vtkGetMacro(Judged, long long);
  long long GetWrong() { return this->FalseShadow + this->FalseLight; }
  vtkGetMacro(FalseShadow, long long);
  vtkGetMacro(FalseLight, long long);
  ///@}

  ///@{
  /** Verdicts of the random sample that are counted separately. */
  vtkGetMacro(Ties, long long);
  vtkGetMacro(Grazing, long long);
  vtkGetMacro(Unlit, long long);
  vtkGetMacro(Unknown, long long);
  ///@}

  /** The share of wrong ones among the judged verdicts, 0 to 1; NaN if none was judged. */
  double GetWrongShare();

  /** GetBound of the judged verdicts, with a confidence of 0.95. */
  double GetWrongShareBound();

  /**
   * The upper bound of the share of wrong verdicts, after `wrong` of `judged` random ones were
   * found wrong: a larger share would have shown so few with a probability of at most 1 -
   * confidence (C. Clopper, E. Pearson, The use of confidence or fiducial limits, 1934; one-sided).
   * For n without an error it is close to 3 / n. 1 if nothing was judged; NaN, with a warning, for
   * negative numbers, more wrong than judged, or a confidence that is not between 0 and 1.
   */
  static double GetBound(long long wrong, long long judged, double confidence = 0.95);

  /** The certificate in a sentence. */
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
