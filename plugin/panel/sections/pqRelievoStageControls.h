// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoStageControls
 * @brief The dock's section for further stages of the frame: a switch each, and below it its
 * parameters. Those of points, such as lamps, are there while the view shows any.
 *
 * Made from the view's properties, which are made from the stages' own descriptions: a new stage
 * needs nothing here. Hidden while there is none.
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
  QPointer<pqView> Shown;     // whose stages these are
  QMap<QString, QWidget*> Of; // by the switch of a representation whose points it takes
  QVector<QWidget*> Parts;
};

#endif
