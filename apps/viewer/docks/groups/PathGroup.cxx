// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathGroup.h"

#include "Number.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <exception>

namespace viewer
{
namespace
{
constexpr int TickMilliseconds = 40;
constexpr double UsualSeconds = 2.0;
constexpr int LeastHeight = 45, MostHeight = 90; // of the list

QPushButton* MakeButton(const QString& text, const QString& name, const QString& tip, QWidget* of)
{
  auto* button = new QPushButton(text, of);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setMinimumWidth(1); // the panel's width is small
  return button;
}
}

//------------------------------------------------------------------------------
PathGroup::PathGroup(QWidget* parent)
  : FoldGroup("Camera path", "cameraPath", parent)
  , List(new QListWidget(this))
  , Seconds(new relievoQt::Number(0.1, 20.0, 0.1, 2, this))
{
  this->List->setObjectName("views");
  this->List->setMinimumHeight(LeastHeight);
  this->List->setMaximumHeight(MostHeight);
  this->List->setToolTip("Views of the camera, in their order; Enter or a double click shows one");
  this->Seconds->setObjectName("seconds");
  this->Seconds->SetUnit("s");
  this->Seconds->SetTypedRange(0.01, 3600.0);
  this->Seconds->setToolTip("Time from each view to the next");
  this->Seconds->SetValue(UsualSeconds);
  auto* adder =
    MakeButton("Add view", "addView", "Adds the present view behind the last one", this);
  this->Remover = MakeButton("Remove", "removeView", "Removes the selected view", this);
  this->Player = MakeButton("Play", "playPath", "Moves the camera through the views", this);
  this->Player->setCheckable(true);
  this->Film = MakeButton("Save film...", "saveFilm",
    "Draws the path as a film, frame by frame as Save picture draws them", this);
  const auto addBoth = [this](QWidget* left, QWidget* right) {
    auto* row = new QHBoxLayout();
    row->addWidget(left, 1);
    row->addWidget(right, 1);
    this->GetRows()->addRow(row);
  };
  addBoth(adder, this->Remover);
  this->GetRows()->addRow(this->List);
  this->GetRows()->addRow("Time", this->Seconds);
  addBoth(this->Player, this->Film);
  this->Copier = MakeButton("Copy film as command", "copyFilm",
    "Copies lines for a shell that write the views to a file and draw the same film", this);
  this->GetRows()->addRow(this->Copier);
  this->Tick.setInterval(TickMilliseconds);
  QObject::connect(adder, &QPushButton::clicked, this, &PathGroup::addWanted);
  QObject::connect(this->Remover, &QPushButton::clicked, this, &PathGroup::Remove);
  QObject::connect(this->Player, &QPushButton::toggled, this, &PathGroup::Play);
  QObject::connect(this->Film, &QPushButton::clicked, this, [this] {
    this->Player->setChecked(false);
    Q_EMIT this->filmWanted();
  });
  QObject::connect(this->Copier, &QPushButton::clicked, this, &PathGroup::copyWanted);
  QObject::connect(this->Seconds, &relievoQt::Number::edited, this,
    [this](double seconds) { this->SetSeconds(seconds); });
  QObject::connect(&this->Tick, &QTimer::timeout, this, &PathGroup::ShowMoment);
  QObject::connect(this->List, &QListWidget::itemActivated, this, [this](QListWidgetItem* view) {
    Q_EMIT this->viewWanted(this->Keys[static_cast<std::size_t>(this->List->row(view))].Place);
  });
  this->ShowKeys(-1);
  this->Fold(true);
}

//------------------------------------------------------------------------------
void PathGroup::SetKeys(const std::vector<scene::CameraKey>& keys)
{
  this->Player->setChecked(false);
  this->Keys = keys;
  if (keys.size() > 1)
  {
    this->Seconds->SetValue(keys[1].Time - keys[0].Time);
  }
  this->ShowKeys(-1);
  this->Fold(keys.empty());
}

//------------------------------------------------------------------------------
void PathGroup::Add(const look::CameraPlace& view)
{
  const double time = this->Keys.empty() ? 0.0 : this->Keys.back().Time + this->Seconds->GetValue();
  this->Keys.push_back({ time, view });
  this->ShowKeys(static_cast<int>(this->Keys.size()) - 1);
}

//------------------------------------------------------------------------------
// The next view takes the removed one's time, and the others keep their times after it.
void PathGroup::Remove()
{
  const int row = this->List->currentRow();
  if (row >= 0)
  {
    const auto at = static_cast<std::size_t>(row);
    const double gap =
      at + 1 < this->Keys.size() ? this->Keys[at + 1].Time - this->Keys[at].Time : 0.0;
    this->Keys.erase(this->Keys.begin() + row);
    std::for_each(this->Keys.begin() + row, this->Keys.end(),
      [gap](scene::CameraKey& key) { key.Time -= gap; });
    this->ShowKeys(std::min(row, static_cast<int>(this->Keys.size()) - 1));
  }
}

//------------------------------------------------------------------------------
void PathGroup::SetSeconds(double seconds)
{
  for (std::size_t i = 0; i < this->Keys.size(); ++i)
  {
    this->Keys[i].Time = static_cast<double>(i) * seconds;
  }
}

//------------------------------------------------------------------------------
void PathGroup::Play(bool on)
{
  this->Player->setText(on ? "Stop" : "Play");
  on ? this->Tick.start() : this->Tick.stop();
  this->Played.start();
}

//------------------------------------------------------------------------------
// Shows the camera of the time since Play.
void PathGroup::ShowMoment()
{
  try
  {
    const scene::CameraPath path(this->Keys, "Camera path");
    const double time =
      this->Keys.front().Time + 1e-3 * static_cast<double>(this->Played.elapsed());
    Q_EMIT this->viewWanted(path.Find(time));
    if (time >= this->Keys.back().Time)
    {
      this->Player->setChecked(false);
    }
  }
  catch (const std::exception& error)
  {
    this->Player->setChecked(false);
    Q_EMIT this->refused(QString::fromStdString(error.what()));
  }
}

//------------------------------------------------------------------------------
void PathGroup::ShowKeys(int current)
{
  this->List->clear();
  for (std::size_t i = 0; i < this->Keys.size(); ++i)
  {
    this->List->addItem(QString("View %1").arg(i + 1));
  }
  this->List->setCurrentRow(current);
  this->Remover->setEnabled(!this->Keys.empty());
  this->Player->setEnabled(this->Keys.size() > 1);
  this->Film->setEnabled(this->Keys.size() > 1);
  this->Copier->setEnabled(this->Keys.size() > 1);
}
}
