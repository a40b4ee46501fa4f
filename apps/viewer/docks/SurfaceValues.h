// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rows of values that materials and environments describe: those of --material and --environment.
 * Those without effect beside the others are hidden.
 */
#ifndef SurfaceValues_h
#define SurfaceValues_h

#include "Document.h"

#include <QObject>

#include <vector>

class QFormLayout;
class QLabel;
struct vtkRelievoParameter;

namespace viewer
{
class ParameterEdit;

class SurfaceValues : public QObject
{
  Q_OBJECT

public:
  SurfaceValues(Document* document, QFormLayout* rows, QWidget* parent);

  /// Adds the row of a value; its edit has the value's name.
  void Add(const vtkRelievoParameter& value);

  /// Shows what the settings say.
  void ShowSettings();

private:
  Document* Edited;
  QFormLayout* Rows;
  struct Row
  {
    const vtkRelievoParameter* Value;
    ParameterEdit* Edit;
    QLabel* Label;
  };
  std::vector<Row> All;
};
}

#endif
