// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoRefiner
 * @brief Draws render views again while their soft shadows lack samples, and nobody is working.
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
    int Missing = 0;  // samples, after the last picture
    int Vain = 0;     // pictures of ours in a row that brought no sample
    bool Own = false; // the picture that is being drawn is ours
  };
  static void Refine(pqView* view, QTimer* timer, Progress& progress);

  bool Playing = false; // an animation
};

#endif
