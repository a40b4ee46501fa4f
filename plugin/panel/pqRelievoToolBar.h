// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoToolBar
 * @brief One-click switches for shadows and for a world-fixed sun with shadows in the active view.
 */
#ifndef pqRelievoToolBar_h
#define pqRelievoToolBar_h

#include "vtkEventQtSlotConnect.h"
#include "vtkNew.h"

#include <QToolBar>

class QAction;

class pqRelievoToolBar : public QToolBar
{
  Q_OBJECT
  using Superclass = QToolBar;

public:
  explicit pqRelievoToolBar(QWidget* parent = nullptr);

  /** Updates for the active view, which may have changed or received Relievo's settings. */
  void Rewatch();

private Q_SLOTS:
  void ShowState();

private:
  QAction* Shadows;
  QAction* Sun;
  vtkNew<vtkEventQtSlotConnect> Connector;
};

#endif
