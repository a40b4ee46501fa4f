// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoRefiner
 * @brief Draws render views again while their soft shadows lack samples, and nobody is working.
 */
#ifndef pqRelievoRefiner_h
#define pqRelievoRefiner_h

#include <QObject>

class pqView;

class pqRelievoRefiner : public QObject
{
  Q_OBJECT
  using Superclass = QObject;

public:
  explicit pqRelievoRefiner(QObject* parent = nullptr);

private:
  void Watch(pqView* view);
  void Refine(pqView* view);
};

#endif
