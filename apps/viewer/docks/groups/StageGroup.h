// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A stage of the frame: a switch, its parameters, and the reason if it has no effect. Built from
 * the stage's own description.
 */
#ifndef StageGroup_h
#define StageGroup_h

#include "Document.h"
#include "FoldGroup.h"

#include "vtkRelievoParameterList.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class vtkRelievoPass;
struct vtkRelievoStageDescription;

namespace viewer
{
class ParameterEdit;
class PointsEdit;

class StageGroup : public FoldGroup
{
  Q_OBJECT

public:
  StageGroup(
    Document* document, const vtkRelievoStageDescription& description, QWidget* parent = nullptr);

  /// Where a stage appears: beside the lights, in the look, or among expert settings there.
  enum Place
  {
    LIGHT,
    LOOK,
    ADVANCED
  };

  /// The groups of all configurable stages of that place, from any module; stages without a place
  /// of their own are last in LOOK.
  static std::vector<StageGroup*> MakeAll(Document* document, Place place, QWidget* parent);

  /// Shows why an enabled stage did not run. nullptr: there is no frame.
  void ShowReason(vtkRelievoPass* frame);

private:
  void AddParameter(const vtkRelievoParameter& parameter);
  void Switch(bool on);
  bool IsOn() const;
  void ShowSettings();
  QString WhyIdle(const vtkRelievoParameter& parameter, const scene::Settings& settings) const;

  Document* Edited;
  std::string Stage;
  vtkRelievoParameterList Parameters; // descriptions, without values
  QLabel* Reason;
  PointsEdit* Points = nullptr; // for a stage of points
  std::map<std::string, ParameterEdit*> Edits;
  bool Waiting = false;                 // switched on without a file; not in the words yet
  std::optional<scene::Settings> Saved; // the words while switched off
};
}

#endif
