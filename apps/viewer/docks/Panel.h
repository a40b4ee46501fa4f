// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Base of the window's panels: rows in a scrolling column, and a document.
 */
#ifndef Panel_h
#define Panel_h

#include "Document.h"
#include "FoldGroup.h"

#include <QScrollArea>

class QFormLayout;
class QVBoxLayout;

namespace viewer
{
class Panel : public QScrollArea
{
  Q_OBJECT

public:
  Panel(Document* document, QWidget* parent);

  /// Requests only the panel's minimum width, to leave space for the picture.
  QSize sizeHint() const override;

protected:
  /// Adds a group of rows below the others, or an existing group.
  FoldGroup* AddGroup(const QString& title, const QString& name);
  void AddGroup(FoldGroup* group);
  /// Adds a last group, of the options of this panel that have no control of their own, if any.
  void AddOptions(const std::string& panel);
  /// Gives one group the remaining space.
  void Fill(QGroupBox* group);
  static QFormLayout* GetRows(QGroupBox* group);

  Document* Edited;

private:
  QVBoxLayout *Outer, *Column;
};
}

#endif
