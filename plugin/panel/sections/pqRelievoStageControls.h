// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoStageControls
 * @brief The dock's section for further stages of the frame: a switch for each, with its
 * parameters. Stages of points, such as lamps, appear while the view shows any.
 *
 * Built from the view's properties, which are generated from the stages' own descriptions: a new
 * stage needs no code here. Hidden while there is none.
 */
#ifndef pqRelievoStageControls_h
#define pqRelievoStageControls_h

#include "pqRelievoControls.h"

class QVBoxLayout;

class pqRelievoStageControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;

public:
  explicit pqRelievoStageControls(QWidget* parent = nullptr);

  void SetView(pqView* view) override;
  void ShowScene() override;

private:
  void AddStage(const QStringList& properties, const QString& points);
  void AddProperties(const QStringList& properties, QWidget* part);

  QVBoxLayout* Rows;
  QPointer<pqView> Shown;     // the view of these stages
  QMap<QString, QWidget*> Of; // by the switch of the representations whose points a stage uses
  QVector<QWidget*> Parts;
};

#endif
