// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the panels of the window have in common: rows in a column that scrolls, and a document.
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

  /// The panel asks for its least width only: the rest of the room is the picture's.
  QSize sizeHint() const override;

protected:
  /// A group of rows, below the others, or one that is made already.
  FoldGroup* AddGroup(const QString& title, const QString& name);
  void AddGroup(FoldGroup* group);
  /// One of these groups gets the room that is left.
  void Fill(QGroupBox* group);
  static QFormLayout* GetRows(QGroupBox* group);

  Document* Edited;

private:
  QVBoxLayout *Outer, *Column;
};
}

#endif
