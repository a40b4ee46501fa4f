// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoRefiner
 * @brief Redraws render views while their soft shadows lack samples and the user is idle.
 */
#ifndef pqRelievoRefiner_h
#define pqRelievoRefiner_h

#include <QObject>

class QTimer;
class pqAnimationScene;
class pqView;

class pqRelievoRefiner : public QObject
{
  Q_OBJECT
  using Superclass = QObject;

public:
  explicit pqRelievoRefiner(QObject* parent = nullptr);

private:
  void Watch(pqView* view);
  void Follow(pqAnimationScene* scene);
  struct Progress
  {
    int Missing = 0;  // samples missing after the last picture
    int Vain = 0;     // consecutive own pictures without a new sample
    bool Own = false; // the current picture is ours
  };
  static void Refine(pqView* view, QTimer* timer, Progress& progress);

  bool Playing = false; // an animation plays
};

#endif
