// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StopsEdit.h"

#include "ColorButton.h"
#include "Numbers.h"

#include "vtkColorTransferFunction.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
// Pixels
constexpr int StripHeight = 18;
constexpr int HandleHeight = 9;
constexpr int HandleHalf = 5;
constexpr int Reach = 9; // of the mouse

constexpr int StopDigits = 6;

QColor MakeQColor(const look::Color& color)
{
  return QColor::fromRgbF(color[0], color[1], color[2]);
}

// The map's colour at a place.
look::Color GetColorAt(const std::vector<look::ColorStop>& stops, double place)
{
  const auto map = look::MakeColormap(look::WriteStops(stops), { 0.0, 1.0 });
  look::Color color;
  map->GetColor(place, color.data());
  return color;
}
}

//------------------------------------------------------------------------------
StopStrip::StopStrip(QWidget* parent)
  : QWidget(parent)
{
  this->setObjectName("stopStrip");
  this->setToolTip("Drag a handle to move its colour; a double click adds one");
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

//------------------------------------------------------------------------------
void StopStrip::Show(const std::vector<look::ColorStop>& stops)
{
  if (this->Held < 0)
  {
    this->Stops = stops;
    this->update();
  }
}

//------------------------------------------------------------------------------
QSize StopStrip::sizeHint() const
{
  return { 120, StripHeight + HandleHeight + 1 };
}

//------------------------------------------------------------------------------
double StopStrip::GetPlace(int x) const
{
  return std::clamp(
    static_cast<double>(x - HandleHalf) / std::max(1, this->width() - 2 * HandleHalf - 1), 0.0,
    1.0);
}

//------------------------------------------------------------------------------
int StopStrip::GetX(double place) const
{
  return HandleHalf + static_cast<int>(std::lround(place * (this->width() - 2 * HandleHalf - 1)));
}

//------------------------------------------------------------------------------
void StopStrip::paintEvent(QPaintEvent*)
{
  if (this->Stops.size() < 2)
  {
    return;
  }
  QPainter painter(this);
  const auto map = look::MakeColormap(look::WriteStops(this->Stops), { 0.0, 1.0 });
  for (int x = HandleHalf; x < this->width() - HandleHalf; ++x)
  {
    const double* rgb = map->GetColor(this->GetPlace(x));
    painter.fillRect(x, 0, 1, StripHeight, QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(this->palette().color(QPalette::WindowText));
  for (const look::ColorStop& stop : this->Stops)
  {
    const double x = this->GetX(stop.Place) + 0.5;
    painter.setBrush(MakeQColor(stop.Shown));
    painter.drawPolygon(QPolygonF({ QPointF(x, StripHeight - 2),
      QPointF(x + HandleHalf - 0.5, StripHeight + HandleHeight - 0.5),
      QPointF(x - HandleHalf + 0.5, StripHeight + HandleHeight - 0.5) }));
  }
}

//------------------------------------------------------------------------------
void StopStrip::mousePressEvent(QMouseEvent* event)
{
  this->Held = -1;
  this->Moved = false;
  int nearest = Reach + 1;
  for (std::size_t i = 0; event->button() == Qt::LeftButton && i < this->Stops.size(); ++i)
  {
    const int away = std::abs(this->GetX(this->Stops[i].Place) - event->pos().x());
    if (away < nearest)
    {
      nearest = away;
      this->Held = static_cast<int>(i);
    }
  }
}

//------------------------------------------------------------------------------
void StopStrip::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Held >= 0)
  {
    const auto held = static_cast<std::size_t>(this->Held);
    const double least = held > 0 ? this->Stops[held - 1].Place : 0.0;
    const double most = held + 1 < this->Stops.size() ? this->Stops[held + 1].Place : 1.0;
    this->Stops[held].Place = std::clamp(this->GetPlace(event->pos().x()), least, most);
    this->Moved = true;
    this->update();
  }
}

//------------------------------------------------------------------------------
void StopStrip::mouseReleaseEvent(QMouseEvent*)
{
  const int held = this->Held;
  this->Held = -1;
  if (held >= 0 && this->Moved)
  {
    const auto stop = static_cast<std::size_t>(held);
    Q_EMIT this->moved(stop, this->Stops[stop].Place);
  }
}

//------------------------------------------------------------------------------
void StopStrip::mouseDoubleClickEvent(QMouseEvent* event)
{
  Q_EMIT this->addWanted(this->GetPlace(event->pos().x()));
}

//------------------------------------------------------------------------------
StopsEdit::StopsEdit(QWidget* parent)
  : QWidget(parent)
  , Strip(new StopStrip(this))
  , Rows(new QVBoxLayout())
{
  this->setObjectName("stops");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->Strip);
  this->Rows->setSpacing(2);
  column->addLayout(this->Rows);
  auto* add = new QPushButton("Add a colour", this);
  add->setObjectName("addStop");
  add->setToolTip("In the middle of the widest gap");
  column->addWidget(add, 0, Qt::AlignLeft);
  QObject::connect(add, &QPushButton::clicked, this, &StopsEdit::Add);
  QObject::connect(this->Strip, &StopStrip::moved, this, [this](std::size_t stop, double place) {
    std::vector<look::ColorStop> stops = this->Stops;
    if (stop < stops.size()) // the number may have decreased during the drag
    {
      stops[stop].Place = place;
      this->Tell(stops);
    }
  });
  QObject::connect(this->Strip, &StopStrip::addWanted, this, [this](double place) {
    std::vector<look::ColorStop> stops = this->Stops;
    stops.push_back({ place, GetColorAt(this->Stops, place) });
    this->Tell(stops);
  });
}

//------------------------------------------------------------------------------
double StopsEdit::GetValue(double place) const
{
  if (!this->Range)
  {
    return place;
  }
  const double from = (*this->Range)[0];
  const double to = (*this->Range)[1];
  return this->Log ? from * std::pow(to / from, place) : from + place * (to - from);
}

//------------------------------------------------------------------------------
double StopsEdit::GetPlace(double value) const
{
  if (!this->Range)
  {
    return value;
  }
  const double from = (*this->Range)[0];
  const double to = (*this->Range)[1];
  return this->Log ? (value > 0.0 ? std::log(value / from) / std::log(to / from) : 0.0)
                   : (value - from) / (to - from);
}

//------------------------------------------------------------------------------
void StopsEdit::Show(const std::vector<look::ColorStop>& stops,
  const std::optional<std::array<double, 2>>& range, bool log)
{
  this->Stops = stops;
  this->Range = range && (*range)[0] < (*range)[1] ? range : std::nullopt;
  this->Log = log && this->Range && (*this->Range)[0] > 0.0;
  this->Strip->Show(stops);
  while (this->Rows->count() > static_cast<int>(stops.size()))
  {
    QLayoutItem* item = this->Rows->takeAt(this->Rows->count() - 1);
    item->widget()->findChild<QLineEdit*>("value")->blockSignals(true); // hidden, it is edited
    item->widget()->hide();
    item->widget()->deleteLater(); // may be the sender of the click
    delete item;
  }
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    if (static_cast<int>(i) >= this->Rows->count())
    {
      this->AddRow(i);
    }
    QWidget* row = this->Rows->itemAt(static_cast<int>(i))->widget();
    row->findChild<QLineEdit*>("value")->setText(
      QString::number(this->GetValue(stops[i].Place), 'g', StopDigits));
    row->findChild<ColorButton*>("shown")->SetColor(MakeQColor(stops[i].Shown));
    row->findChild<QToolButton*>("remove")->setEnabled(stops.size() > 2);
  }
}

//------------------------------------------------------------------------------
void StopsEdit::AddRow(std::size_t stop)
{
  auto* row = new QWidget(this);
  auto* value = new QLineEdit(row);
  value->setObjectName("value");
  value->setMinimumWidth(40);
  value->setToolTip("The value that has this colour");
  auto* color = new ColorButton(row);
  color->setObjectName("shown");
  auto* remove = new QToolButton(row);
  remove->setObjectName("remove");
  remove->setText(QChar(0x2715));
  remove->setAutoRaise(true);
  remove->setToolTip("Removes this colour");
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(value, 1);
  line->addWidget(color, 1);
  line->addWidget(remove);
  this->Rows->addWidget(row);
  QObject::connect(value, &QLineEdit::editingFinished, this,
    [this, stop, value] { this->Take(stop, value->text()); });
  QObject::connect(color, &ColorButton::edited, this, [this, stop](const QColor& chosen) {
    std::vector<look::ColorStop> stops = this->Stops;
    stops[stop].Shown = { chosen.redF(), chosen.greenF(), chosen.blueF() };
    this->Tell(stops);
  });
  QObject::connect(remove, &QToolButton::clicked, this, [this, stop] {
    std::vector<look::ColorStop> stops = this->Stops;
    stops.erase(stops.begin() + static_cast<std::ptrdiff_t>(stop));
    this->Tell(stops);
  });
}

//------------------------------------------------------------------------------
void StopsEdit::Take(std::size_t stop, const QString& value)
{
  if (stop >= this->Stops.size() ||
    value == QString::number(this->GetValue(this->Stops[stop].Place), 'g', StopDigits))
  {
    return;
  }
  bool number = false;
  const double place = this->GetPlace(value.toDouble(&number));
  std::vector<look::ColorStop> stops = this->Stops;
  if (number)
  {
    stops[stop].Place = std::clamp(place, 0.0, 1.0);
  }
  number ? this->Tell(stops) : this->Show(this->Stops, this->Range, this->Log);
}

//------------------------------------------------------------------------------
void StopsEdit::Add()
{
  std::size_t widest = 0;
  const auto getGap = [this](
                        std::size_t i) { return this->Stops[i + 1].Place - this->Stops[i].Place; };
  for (std::size_t i = 0; i + 1 < this->Stops.size(); ++i)
  {
    widest = getGap(i) > getGap(widest) + 1e-9 ? i : widest;
  }
  const double place = this->Stops[widest].Place + 0.5 * getGap(widest);
  std::vector<look::ColorStop> stops = this->Stops;
  stops.push_back({ place, GetColorAt(this->Stops, place) });
  this->Tell(stops);
}

//------------------------------------------------------------------------------
void StopsEdit::Tell(std::vector<look::ColorStop> stops)
{
  std::stable_sort(stops.begin(), stops.end(),
    [](const look::ColorStop& a, const look::ColorStop& b) { return a.Place < b.Place; });
  for (look::ColorStop& stop : stops)
  {
    stop.Place = std::round(stop.Place * 1e6) / 1e6; // keeps the word short
  }
  Q_EMIT this->edited(stops);
}
}
