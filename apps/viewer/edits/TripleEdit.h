// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Three spin boxes in a row for a place, of any magnitude.
 */
#ifndef TripleEdit_h
#define TripleEdit_h

#include <QWidget>

#include <array>

namespace relievoQt
{
class DigitsBox;
}

namespace viewer
{
class TripleEdit : public QWidget
{
  Q_OBJECT

public:
  explicit TripleEdit(QWidget* parent = nullptr);

  /// Emits no signal. Unedited numbers are not rounded.
  void SetValue(const std::array<double, 3>& value);
  std::array<double, 3> GetValue() const { return this->Value; }

Q_SIGNALS:
  void edited();

private:
  std::array<double, 3> Value{};
  std::array<relievoQt::DigitsBox*, 3> Boxes{};
};
}

#endif
