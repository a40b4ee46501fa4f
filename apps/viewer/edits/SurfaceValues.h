// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rows for the values of --material and --environment, built from the descriptions of materials and
 * environments.
 */
#ifndef SurfaceValues_h
#define SurfaceValues_h

#include "Document.h"

#include <QObject>

#include <vector>

struct vtkRelievoParameter;

namespace viewer
{
class FoldGroup;
class ParameterEdit;

class SurfaceValues : public QObject
{
  Q_OBJECT

public:
  SurfaceValues(Document* document, FoldGroup* group);

  /// Adds the row of a value to the group, or to its section Advanced; the edit's object name is
  /// the value's name.
  void Add(const vtkRelievoParameter& value);

  /// Shows the settings' values.
  void ShowSettings();

private:
  Document* Edited;
  FoldGroup* Group;
  struct Row
  {
    const vtkRelievoParameter* Value;
    ParameterEdit* Edit;
  };
  std::vector<Row> All;
};
}

#endif
