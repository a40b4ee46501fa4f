// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A widget for a parameter of a stage, a material or an environment, built from the parameter's own
 * description.
 */
#ifndef ParameterEdit_h
#define ParameterEdit_h

#include <QString>
#include <QWidget>

#include <functional>

struct vtkRelievoParameter;

namespace viewer
{
class ParameterEdit : public QWidget
{
  Q_OBJECT

public:
  explicit ParameterEdit(const vtkRelievoParameter& parameter, QWidget* parent = nullptr);

  /// Sets the value in words of the description. Emits no signal.
  void SetValue(const QString& words) { this->Show(words); }

Q_SIGNALS:
  void edited(const QString& words);

private:
  QWidget* MakeFlag();
  QWidget* MakeNumber(const vtkRelievoParameter& parameter);
  QWidget* MakeChoice(const vtkRelievoParameter& parameter);
  QWidget* MakeColor();
  QWidget* MakeText();

  std::function<void(const QString&)> Show;
};
}

#endif
