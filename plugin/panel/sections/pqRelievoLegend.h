// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoLegend
 * @brief Explains the colours of the displayed layer: a bar with values at its ends, or words.
 */
#ifndef pqRelievoLegend_h
#define pqRelievoLegend_h

#include <QString>
#include <QWidget>

class QLabel;
namespace relievoQt
{
struct LayerWords;
}

class pqRelievoLegend : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;
  /** All of its texts, one per line. */
  Q_PROPERTY(QString text READ GetText)

public:
  explicit pqRelievoLegend(QWidget* parent = nullptr);

  void Show(const relievoQt::LayerWords& words);

  QString GetText() const;

private:
  QLabel *Words, *Bar, *First, *Last;
};

#endif
