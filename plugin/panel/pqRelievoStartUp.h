// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoStartUp
 * @brief Refreshes ParaView's panels for a view that has just received Relievo's properties.
 */
#ifndef pqRelievoStartUp_h
#define pqRelievoStartUp_h

#include "vtkEventQtSlotConnect.h"
#include "vtkNew.h"

#include <QObject>

class pqRelievoStartUp : public QObject
{
  Q_OBJECT
  using Superclass = QObject;

public:
  explicit pqRelievoStartUp(QObject* parent = nullptr);

  ///@{
  /** Called when the plugin is loaded, and when ParaView ends. */
  void OnStartUp();
  void OnShutDown();
  ///@}

private Q_SLOTS:
  void Refresh();

private:
  vtkNew<vtkEventQtSlotConnect> Connector;
};

#endif
