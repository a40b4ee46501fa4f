// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoLegend
 * @brief What the colours of the layer that is shown mean: a bar with its ends, or words.
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
  /** All of its words, a line each. */
  Q_PROPERTY(QString text READ GetText)

public:
  explicit pqRelievoLegend(QWidget* parent = nullptr);

  void Show(const relievoQt::LayerWords& words);

  QString GetText() const;

private:
  QLabel *Words, *Bar, *First, *Last;
};

#endif
