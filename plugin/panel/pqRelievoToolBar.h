// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoToolBar
 * @brief Shadows, and a world-fixed sun with its shadows, of the active view with one click each.
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

  /** Looks again at the active view: it may have changed, or got Relievo's settings. */
  void Rewatch();

private Q_SLOTS:
  void ShowState();

private:
  QAction* Shadows;
  QAction* Sun;
  vtkNew<vtkEventQtSlotConnect> Connector;
};

#endif
