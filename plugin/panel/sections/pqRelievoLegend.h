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

class pqRelievoLegend : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;
  /** All of its words, a line each. */
  Q_PROPERTY(QString text READ GetText)

public:
  explicit pqRelievoLegend(QWidget* parent = nullptr);

  enum Looks
  {
    WORDS, // no bar
    COLORS,
    GREYS
  };

  /** The words, and what stands below the first and the last colour. */
  void Set(const QString& words, Looks look, const QString& first, const QString& last);

  QString GetText() const;

private:
  QLabel *Words, *Bar, *First, *Last;
};

#endif
