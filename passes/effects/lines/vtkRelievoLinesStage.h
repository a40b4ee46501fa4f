// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLinesStage
 * @brief A stage that draws outlines, creases and folds as lines, as in a technical illustration.
 *
 * A line runs between two neighbouring pixels in these cases:
 * - outline: they show different parts (actors, blocks, glyphs), or a part and the background;
 * - crease: the triangles' normals of one part jump between them, and do not on either side;
 * - fold: the depth of one part jumps: one side lies in front of the other, and neither side's
 *   slope leads there. Slopes are those of 1 / depth, in which planes are linear in a perspective
 *   picture (Saito and Takahashi 1990 draw lines from such differences).
 *
 * A line is centred on the border between the pixels, within half a pixel of the true edge.
 *
 * Hidden lines are optional, and dashed (Hidden): the edges of the opaque meshes at boundaries, at
 * creases, and at silhouettes. They are found in the meshes, in double, and drawn where the frame's
 * depth has a surface in front of them.
 */
#ifndef vtkRelievoLinesStage_h
#define vtkRelievoLinesStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <memory> // for the drawing half

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoLinesStage : public vtkRelievoStage
{
public:
  static vtkRelievoLinesStage* New();
  vtkTypeMacro(vtkRelievoLinesStage, vtkRelievoStage);

  ///@{
  /** Kinds of lines. Default all of them; with all off the stage does not run. */
  vtkSetMacro(Outlines, bool);
  vtkGetMacro(Outlines, bool);
  vtkBooleanMacro(Outlines, bool);
  vtkSetMacro(Creases, bool);
  vtkGetMacro(Creases, bool);
  vtkBooleanMacro(Creases, bool);
  vtkSetMacro(Folds, bool);
  vtkGetMacro(Folds, bool);
  vtkBooleanMacro(Folds, bool);
  ///@}

  ///@{
  /** Width in pixels, from 0 (the stage does not run) to 16. Default 1.5. */
  vtkSetClampMacro(Width, double, 0.0, 16.0);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /** Colour of the lines: red, green, blue from 0 to 1, sRGB. Default black. */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /** Smallest angle between two triangles that counts as a crease, 1 to 180 degrees. Default 30. */
  vtkSetClampMacro(CreaseAngle, double, 1.0, 180.0);
  vtkGetMacro(CreaseAngle, double);
  ///@}

  ///@{
  /**
   * Whether volumes have outlines and folds, from the layer volume_depth: where the volume of the
   * rule of the stage `volumes` begins, and where it overlaps itself. Default off.
   */
  vtkSetMacro(Volumes, bool);
  vtkGetMacro(Volumes, bool);
  vtkBooleanMacro(Volumes, bool);
  ///@}

  enum HiddenLines
  {
    OFF = 0,
    DASHED = 1
  };

  ///@{
  /**
   * Whether lines behind opaque surfaces are drawn, dashed. They include creases if Creases is on,
   * and silhouettes and boundaries if Outlines or Folds is. Default OFF.
   */
  vtkSetClampMacro(Hidden, int, OFF, DASHED);
  vtkGetMacro(Hidden, int);
  void SetHiddenToOff() { this->SetHidden(OFF); }
  void SetHiddenToDashed() { this->SetHidden(DASHED); }
  ///@}

  ///@{
  /**
   * Length of a dash in pixels, 1 to 100; gaps are half as long. Both are stretched so that whole
   * dashes fit a line. Default 6.
   */
  vtkSetClampMacro(Dash, double, 1.0, 100.0);
  vtkGetMacro(Dash, double);
  ///@}

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoLinesStage();
  ~vtkRelievoLinesStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;

  bool Outlines = true;
  bool Creases = true;
  bool Folds = true;
  bool Volumes = false;
  double Width = 1.5;
  double Color[3] = { 0.0, 0.0, 0.0 };
  double CreaseAngle = 30.0;
  int Hidden = OFF;
  double Dash = 6.0;

private:
  vtkRelievoLinesStage(const vtkRelievoLinesStage&) = delete;
  void operator=(const vtkRelievoLinesStage&) = delete;

  bool HasVolumes(const vtkRelievoFrameContext& context) const;
  std::string Draw(vtkRelievoFrameContext& context);
  std::string FindSides(vtkRelievoFrameContext& context, bool ofVolumes);
  std::string DrawSides(vtkRelievoFrameContext& context, bool ofVolumes);
  std::string DrawHidden(vtkRelievoFrameContext& context);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
