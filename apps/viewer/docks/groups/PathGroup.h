// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The camera's path: views that the user stores, one after the other, to be played and drawn as a
 * film.
 */
#ifndef PathGroup_h
#define PathGroup_h

#include "CameraPath.h"
#include "FoldGroup.h"

#include <QElapsedTimer>
#include <QTimer>

#include <vector>

class QListWidget;
class QPushButton;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class PathGroup : public FoldGroup
{
  Q_OBJECT

public:
  explicit PathGroup(QWidget* parent = nullptr);

  const std::vector<scene::CameraKey>& GetKeys() const { return this->Keys; }
  void SetKeys(const std::vector<scene::CameraKey>& keys);

  /// Adds a view behind the last one.
  void Add(const look::CameraPlace& view);

Q_SIGNALS:
  /// The camera's present view is to be added.
  void addWanted();

  void viewWanted(const look::CameraPlace& view);
  void filmWanted();
  void copyWanted();

  /// No path leads through these views.
  void refused(const QString& why);

private:
  void Remove();
  void SetSeconds(double seconds);
  void Play(bool on);
  void ShowMoment();
  void ShowKeys(int current);

  std::vector<scene::CameraKey> Keys;
  QListWidget* List;
  relievoQt::Number* Seconds; // from each view to the next
  QPushButton *Remover, *Player, *Film, *Copier;
  QTimer Tick;
  QElapsedTimer Played;
};
}

#endif
