// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Every stage of a frame: a switch, its parameters, and why it does nothing where it does not. Made
 * from the stages' own descriptions.
 */
#ifndef StagesPanel_h
#define StagesPanel_h

#include "Panel.h"

#include <map>
#include <optional>
#include <string>

class QGroupBox;
class QLabel;
class vtkRelievoPass;
class vtkRelievoStage;

namespace viewer
{
class ParameterEdit;
class PointsEdit;

class StagesPanel : public Panel
{
  Q_OBJECT

public:
  explicit StagesPanel(Document* document, QWidget* parent = nullptr);

  /// Says of stages that are on and did not run why. nullptr: there is no frame.
  void ShowReasons(vtkRelievoPass* frame);

private:
  struct Group
  {
    std::string Stage;
    QGroupBox* Box;
    QLabel* Reason;
    PointsEdit* Points = nullptr; // of a stage that works on data
    std::map<std::string, ParameterEdit*> Edits;
    std::optional<scene::Settings> Kept; // while it is switched off
  };

  void AddStage(vtkRelievoStage* stage);
  void Switch(Group& group, bool on);
  bool IsOn(const Group& group) const;
  void ShowSettings();

  std::map<std::string, Group> Groups;
};
}

#endif
