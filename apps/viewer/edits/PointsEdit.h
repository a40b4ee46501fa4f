// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files of points for a stage, such as --lamps FILE,radius=R, and the values of the selected
 * file's points: each a number, or the name of a point array.
 */
#ifndef PointsEdit_h
#define PointsEdit_h

#include "Document.h"
#include "PointOptions.h"
#include "vtkRelievoParameter.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;

namespace viewer
{
class PointsEdit : public QWidget
{
  Q_OBJECT

public:
  /// `stage`: a stage of points, such as fog; its name is also an option.
  PointsEdit(Document* document, const std::string& stage, QWidget* parent = nullptr);

private:
  struct Row
  {
    std::string Name, Default; // of the parameter
    std::vector<vtkRelievoParameter::Condition> Conditions;
    QWidget* Edit;
    std::function<void(const QString&)> Show;
    QString Shown;
    QComboBox* Arrays = nullptr; // offers names of arrays
    int Own = 0;                 // entries before the arrays
  };

  void AddRow(QFormLayout* rows, const vtkRelievoParameter& value);
  QComboBox* MakeBox(Row& row, const vtkRelievoParameter& value, QWidget* parent);
  QWidget* MakeColor(Row& row, const vtkRelievoParameter& value);
  void Connect(QComboBox* box, const std::string& name);
  QString WhyIdle(const Row& row, const words::NamedWords& values) const;
  void Ask();
  void Remove();
  void Write(const std::string& name, const QString& text);
  void ShowSettings();
  void ShowValues(bool again);
  void ShowArrays();

  Document* Edited;
  std::string Stage, Option;
  QLabel* Hint;
  QListWidget* Files;
  QPushButton* RemoveFile;
  QWidget* Values;
  std::vector<Row> Rows;
  const vtkRelievoParameterList* Described = nullptr;
};
}

#endif
