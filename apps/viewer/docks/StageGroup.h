// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A stage of the frame: a switch, its parameters, and why it does nothing where it does not. Made
 * from the stage's own description.
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

  /// Where a stage is seen: beside the lights, with how things look, or with what few need there.
  enum Place
  {
    LIGHT,
    LOOK,
    ADVANCED
  };

  /// The groups of all stages of that place that can be set, whoever brings them; those without a
  /// place of their own are in LOOK, behind the others.
  static std::vector<StageGroup*> MakeAll(Document* document, Place place, QWidget* parent);

  /// Says why the stage did not run, if it is on. nullptr: there is no frame.
  void ShowReason(vtkRelievoPass* frame);

private:
  void AddParameter(const vtkRelievoParameter& parameter);
  void Switch(bool on);
  bool IsOn() const;
  void ShowSettings();
  QString WhyIdle(const vtkRelievoParameter& parameter, const scene::Settings& settings) const;

  Document* Edited;
  std::string Stage;
  vtkRelievoParameterList Parameters; // what they say of themselves, and not their values
  QLabel* Reason;
  PointsEdit* Points = nullptr; // of a stage that works on data
  std::map<std::string, ParameterEdit*> Edits;
  bool Waiting = false;                // for the first file: switched on, and no word says so yet
  std::optional<scene::Settings> Kept; // while it is switched off
};
}

#endif
