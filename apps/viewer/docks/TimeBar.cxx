// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeBar.h"

#include "Icons.h"
#include "Options.h"

#include <QAction>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
constexpr int Steps = 1000;
constexpr int FrameMilliseconds = 40;
}

//------------------------------------------------------------------------------
TimeBar::TimeBar(Document* document, QWidget* parent)
  : QToolBar("Time", parent)
  , Edited(document)
  , Playing(this->addAction("Play"))
  , Slider(new QSlider(Qt::Horizontal, this))
  , Words(new QLabel(this))
{
  this->setObjectName("time");
  this->setMovable(false);
  this->Playing->setIcon(MakeIcon("play"));
  this->Playing->setCheckable(true);
  this->Playing->setShortcut(QKeySequence(Qt::Key_Space));
  this->Slider->setObjectName("slider");
  this->Slider->setRange(0, Steps);
  this->Words->setMinimumWidth(90);
  this->addWidget(this->Slider);
  this->addWidget(this->Words);
  this->Next.setSingleShot(true);
  QObject::connect(&this->Next, &QTimer::timeout, this, [this] { this->Step(); });
  QObject::connect(this->Playing, &QAction::toggled, this, [this](bool on) { this->Play(on); });
  QObject::connect(this->Slider, &QSlider::valueChanged, this, [this](int position) {
    const std::array<double, 2>& times = this->Edited->GetFacts().Times;
    this->SetTime(times[0] + (times[1] - times[0]) * position / Steps);
  });
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  QObject::connect(document, &Document::factsChanged, this, [this] { this->ShowSettings(); });
  QObject::connect(document, &Document::shown, this, [this] {
    if (this->Playing->isChecked())
    {
      this->Next.start(FrameMilliseconds);
    }
  });
  QObject::connect(document, &Document::refused, this, &TimeBar::Stop);
  this->Playing->setEnabled(false);
  this->toggleViewAction()->setVisible(false);
  this->hide();
}

//------------------------------------------------------------------------------
double TimeBar::GetTime() const
{
  return this->Edited->Get().Parse().Model.Time.value_or(this->Edited->GetFacts().Times[0]);
}

//------------------------------------------------------------------------------
void TimeBar::SetTime(double seconds)
{
  this->Edited->Change(
    [seconds](scene::Settings& settings) { settings.Set("--time", words::WriteNumber(seconds)); },
    this->Played);
}

//------------------------------------------------------------------------------
void TimeBar::ShowSettings()
{
  const std::array<double, 2>& times = this->Edited->GetFacts().Times;
  const double length = times[1] - times[0];
  this->setVisible(length > 0.0);
  this->Playing->setEnabled(length > 0.0); // otherwise its key would start a missing animation
  if (length > 0.0)
  {
    const QSignalBlocker quiet(this->Slider);
    const double time = this->GetTime();
    this->Slider->setValue(static_cast<int>(std::lround(Steps * (time - times[0]) / length)));
    this->Words->setText(QString("%1 / %2 s").arg(time, 0, 'f', 2).arg(times[1], 0, 'f', 2));
  }
  else
  {
    this->Playing->setChecked(false);
  }
}

//------------------------------------------------------------------------------
void TimeBar::Play(bool on)
{
  this->Playing->setIcon(MakeIcon(on ? "pause" : "play"));
  this->Playing->setText(on ? "Pause" : "Play");
  this->Clock.start();
  this->Played = on ? this->Edited->MakeEdit() : 0;
  on ? this->Next.start(0) : this->Next.stop();
}

//------------------------------------------------------------------------------
// By the clock: slow models skip times instead of playing slowly.
void TimeBar::Step()
{
  const std::array<double, 2>& times = this->Edited->GetFacts().Times;
  const double length = times[1] - times[0];
  if (length > 0.0)
  {
    // At least a millisecond: an equal time would change nothing, and no picture calls again.
    const double passed = static_cast<double>(std::max<qint64>(this->Clock.restart(), 1)) / 1000.0;
    const double along = this->GetTime() - times[0] + passed;
    this->SetTime(times[0] + std::fmod(std::max(along, 0.0), length));
  }
}
}
