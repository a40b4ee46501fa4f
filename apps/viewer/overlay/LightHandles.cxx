// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightHandles.h"

#include "LightOptions.h"
#include "Pick.h"
#include "PictureView.h"

#include "vtkMath.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
// Pixels
constexpr double HandleRadius = 9.0;
constexpr double Ring = 7.0;  // radius
constexpr double Ray = 14.0;  // distance of its end from the centre
constexpr double Border = 20; // least distance of handles from the view's border
constexpr double Reach = 15;  // of a handle, for the mouse and for drawing

constexpr int Sides = 48; // of a cone's circle

constexpr double Digits = 1e-3; // precision of a place, relative to the scene's size

QColor GetColor(const look::LightChoice& light)
{
  return QColor::fromRgbF(static_cast<float>(std::min(light.Color[0], 1.0)),
    static_cast<float>(std::min(light.Color[1], 1.0)),
    static_cast<float>(std::min(light.Color[2], 1.0)));
}
}

//------------------------------------------------------------------------------
bool LightHandles::Handle::operator==(const Handle& other) const
{
  return this->Light == other.Light && this->IsTarget == other.IsTarget &&
    this->World == other.World && this->Place == other.Place && this->IsInside == other.IsInside &&
    this->Color == other.Color;
}

//------------------------------------------------------------------------------
LightHandles::LightHandles(Document* document, PictureView* view)
  : Overlay(view)
  , Edited(document)
  , View(view)
{
  this->setObjectName("lightHandles");
  this->setMouseTracking(true); // shows the values under the mouse
  QObject::connect(document, &Document::changed, this, [this] { this->Follow(); });
  this->Place();
  this->hide();
}

//------------------------------------------------------------------------------
void LightHandles::SetWanted(bool wanted)
{
  this->Wanted = wanted;
  this->Follow();
}

//------------------------------------------------------------------------------
void LightHandles::Select(int light)
{
  if (light != this->Current)
  {
    this->Current = light;
    this->Follow();
    this->update();
  }
}

//------------------------------------------------------------------------------
std::vector<LightHandles::Handle> LightHandles::FindHandles() const
{
  std::vector<Handle> handles;
  if (!this->Wanted || this->View->IsEmpty())
  {
    return handles;
  }
  const auto add = [&](int light, bool target, const std::array<double, 3>& world,
                     const QColor& color) {
    const std::array<double, 2> seen = Project(this->View->GetPicture(), world);
    const double half[] = { 0.5 * this->width(), 0.5 * this->height() };
    const double beyond = std::max(
      std::abs(seen[0]) / (1.0 - Border / half[0]), std::abs(seen[1]) / (1.0 - Border / half[1]));
    const double share = 1.0 / std::max(1.0, beyond);
    handles.push_back({ light, target, world,
      { half[0] * (1.0 + share * seen[0]), half[1] * (1.0 - share * seen[1]) },
      std::max(std::abs(seen[0]), std::abs(seen[1])) < 1.0, color });
  };
  const std::vector<std::string> words = this->Edited->Get().GetAll("--light");
  for (int i = 0; i < static_cast<int>(words.size()); ++i)
  {
    const look::LightChoice light = look::ParseLight(words[static_cast<std::size_t>(i)]);
    if (light.Is == look::LightChoice::Kind::Sun)
    {
      continue;
    }
    if (i == this->Current && light.Is == look::LightChoice::Kind::Spot)
    {
      add(i, true, light.FocalPoint, GetColor(light));
    }
    add(i, false, light.Position, GetColor(light));
  }
  std::stable_sort(handles.begin(), handles.end(), [this](const Handle& a, const Handle& b) {
    return a.Light != this->Current && b.Light == this->Current;
  });
  return handles;
}

//------------------------------------------------------------------------------
// A circle as far from the light as the target, and lines to it. Without the lines that would pass
// behind the camera.
std::vector<QLineF> LightHandles::FindCone() const
{
  std::vector<QLineF> lines;
  const std::vector<std::string> words = this->Edited->Get().GetAll("--light");
  if (!this->Wanted || this->View->IsEmpty() || this->Current < 0 ||
    this->Current >= static_cast<int>(words.size()))
  {
    return lines;
  }
  const look::LightChoice light = look::ParseLight(words[static_cast<std::size_t>(this->Current)]);
  double along[3], right[3], up[3];
  vtkMath::Subtract(light.FocalPoint.data(), light.Position.data(), along);
  const double length = vtkMath::Normalize(along);
  if (light.Is != look::LightChoice::Kind::Spot || light.ConeAngle > 90.0 || length == 0.0)
  {
    return lines;
  }
  vtkMath::Perpendiculars(along, right, up, 0.0);
  const Picture& picture = this->View->GetPicture();
  const auto place = [&](const std::array<double, 3>& world) {
    const std::array<double, 2> seen = Project(picture, world);
    return QPointF(0.5 * this->width() * (1.0 + seen[0]), 0.5 * this->height() * (1.0 - seen[1]));
  };
  const double half = vtkMath::RadiansFromDegrees(light.ConeAngle);
  std::vector<QPointF> circle;
  for (int i = 0; i < Sides; ++i)
  {
    const double turn = 2.0 * vtkMath::Pi() * i / Sides;
    std::array<double, 3> world = light.Position;
    for (std::size_t k = 0; k < 3; ++k)
    {
      world[k] += length *
        (std::cos(half) * along[k] +
          std::sin(half) * (std::cos(turn) * right[k] + std::sin(turn) * up[k]));
    }
    circle.push_back(place(world));
  }
  const auto add = [&](const QPointF& from, const QPointF& to) {
    const double far = 4.0 * std::max(this->width(), this->height());
    if (std::max({ std::abs(from.x()), std::abs(from.y()), std::abs(to.x()), std::abs(to.y()) }) <
      far)
    {
      lines.emplace_back(from, to);
    }
  };
  const QPointF top = place(light.Position);
  for (std::size_t i = 0; i < circle.size(); ++i)
  {
    add(circle[i], circle[(i + 1) % circle.size()]);
    if (i % (circle.size() / 8) == 0)
    {
      add(top, circle[i]);
    }
  }
  return lines;
}

//------------------------------------------------------------------------------
// While a sample is drawn, the handles stay; another call follows the sample.
void LightHandles::Follow()
{
  if (!this->View->IsDrawing())
  {
    this->Show(this->FindHandles(), this->FindCone());
  }
}

//------------------------------------------------------------------------------
// The mask leaves the mouse to the picture outside the handles.
void LightHandles::Show(const std::vector<Handle>& handles, const std::vector<QLineF>& cone)
{
  this->setVisible(!handles.empty());
  if (handles == this->Handles && cone == this->Cone)
  {
    return;
  }
  this->Handles = handles;
  this->Cone = cone;
  QRegion region;
  const auto addLine = [&region](const QLineF& drawn) {
    QPainterPath line(drawn.p1());
    line.lineTo(drawn.p2());
    QPainterPathStroker wide;
    wide.setWidth(4.0);
    region += QRegion(wide.createStroke(line).toFillPolygon().toPolygon(), Qt::WindingFill);
  };
  for (const Handle& handle : handles)
  {
    const QRectF around(handle.Place - QPointF(Reach, Reach), QSizeF(2 * Reach, 2 * Reach));
    region += QRegion(around.toAlignedRect(), QRegion::Ellipse);
    const Handle* ball = handle.IsTarget ? this->Find(handle.Light, false) : nullptr;
    if (ball)
    {
      addLine(QLineF(handle.Place, ball->Place));
    }
  }
  for (const QLineF& line : this->Cone)
  {
    addLine(line);
  }
  if (!handles.empty())
  {
    this->setMask(region);
  }
  this->update();
}

//------------------------------------------------------------------------------
const LightHandles::Handle* LightHandles::Find(const QPointF& at) const
{
  for (auto handle = this->Handles.rbegin(); handle != this->Handles.rend(); ++handle)
  {
    const QPointF away = handle->Place - at;
    if (std::hypot(away.x(), away.y()) <= Reach)
    {
      return &*handle;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
const LightHandles::Handle* LightHandles::Find(int light, bool target) const
{
  for (const Handle& handle : this->Handles)
  {
    if (handle.Light == light && handle.IsTarget == target)
    {
      return &handle;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::optional<QPointF> LightHandles::GetPlace(int light, bool target) const
{
  const Handle* handle = this->Find(light, target);
  return handle ? std::optional<QPointF>(handle->Place) : std::nullopt;
}

//------------------------------------------------------------------------------
void LightHandles::mousePressEvent(QMouseEvent* event)
{
  const Handle* handle = this->Find(event->pos());
  if (!handle || event->button() != Qt::LeftButton)
  {
    event->ignore(); // passed to the picture below
    return;
  }
  this->Held = *handle;
  this->Away = handle->IsInside ? handle->Place - event->pos() : QPointF();
  this->Surfaces.Forget();
  this->setCursor(Qt::ClosedHandCursor);
  Q_EMIT this->selected(handle->Light);
}

//------------------------------------------------------------------------------
void LightHandles::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Held && (event->buttons() & Qt::LeftButton))
  {
    this->Drag((event->pos() + this->Away).toPoint());
    return;
  }
  const Handle* handle = this->Find(event->pos());
  handle ? this->setCursor(Qt::OpenHandCursor) : this->unsetCursor();
  this->setToolTip(!handle ? QString()
      : handle->IsTarget   ? "Where it shines: drag it over the surfaces"
      : handle->IsInside   ? "A light: drag it in the plane of the view"
                           : "A light outside of the picture: drag it into it");
  event->ignore();
}

//------------------------------------------------------------------------------
void LightHandles::mouseReleaseEvent(QMouseEvent* event)
{
  if (!this->Held)
  {
    event->ignore();
    return;
  }
  this->Held.reset();
  this->Surfaces.Forget(); // frees its memory
  this->setCursor(Qt::OpenHandCursor);
}

//------------------------------------------------------------------------------
void LightHandles::Drag(const QPoint& at)
{
  const Picture& picture = this->View->GetPicture();
  std::vector<std::string> lights = this->Edited->Get().GetAll("--light");
  const auto light = static_cast<std::size_t>(this->Held->Light);
  if (picture.IsEmpty() || light >= lights.size())
  {
    return; // the light was removed during the drag
  }
  const QPoint pixel = this->View->GetPixel(at);
  std::array<double, 3> place =
    (this->Held->IsTarget ? Pick(picture, this->Surfaces, pixel.x(), pixel.y()) : std::nullopt)
      .value_or(MoveInView(picture, this->Held->World, pixel.x(), pixel.y()));
  const std::array<double, 6>& b = this->Edited->GetFacts().Bounds;
  const double size = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  const look::LightChoice before = look::ParseLight(lights[light]);
  std::vector<double> numbers;
  const auto add = [&](const std::array<double, 3>& v, bool moved) {
    for (const double value : v)
    {
      numbers.push_back(moved && size > 0.0 ? words::RoundTo(value, Digits * size) : value);
    }
  };
  add(this->Held->IsTarget ? before.Position : place, !this->Held->IsTarget);
  if (before.Is == look::LightChoice::Kind::Spot)
  {
    add(this->Held->IsTarget ? place : before.FocalPoint, this->Held->IsTarget);
    numbers.push_back(before.ConeAngle);
  }
  look::LightWords words = look::SplitLight(lights[light]);
  words.Numbers = words::WriteNumbers(numbers);
  lights[light] = look::WriteLight(words);
  this->Edited->Change(
    [&lights](scene::Settings& settings) { settings.SetAll("--light", lights); });
}

//------------------------------------------------------------------------------
void LightHandles::Place()
{
  this->setGeometry(this->parentWidget()->rect());
  this->Follow();
}

//------------------------------------------------------------------------------
void LightHandles::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  // A dark and a bright outline: one contrasts with any picture.
  const auto stroke = [&](double width, const auto& draw) {
    for (const bool bright : { false, true })
    {
      painter.setPen(QPen(bright ? QColor(255, 255, 255, 230) : QColor(0, 0, 0, 150),
        bright ? width : width + 2.0, Qt::SolidLine, Qt::RoundCap));
      draw();
    }
  };
  for (const Handle& handle : this->Handles)
  {
    const Handle* ball = handle.IsTarget ? this->Find(handle.Light, false) : nullptr;
    if (ball)
    {
      stroke(1.0, [&] { painter.drawLine(ball->Place, handle.Place); });
    }
  }
  stroke(1.0, [&] {
    for (const QLineF& line : this->Cone)
    {
      painter.drawLine(line);
    }
  });
  for (const Handle& handle : this->Handles)
  {
    painter.setOpacity(handle.IsInside ? 1.0 : 0.7);
    painter.setBrush(Qt::NoBrush);
    if (handle.IsTarget)
    {
      stroke(1.5, [&] { painter.drawEllipse(handle.Place, Ring, Ring); });
      continue;
    }
    stroke(1.5, [&] {
      for (int i = 0; i < 8; ++i)
      {
        const QPointF along(std::cos(0.25 * M_PI * i), std::sin(0.25 * M_PI * i));
        painter.drawLine(handle.Place + HandleRadius * along, handle.Place + (Ray - 2.0) * along);
      }
    });
    painter.setBrush(handle.Color);
    const QColor rim = handle.Light == this->Current ? this->palette().color(QPalette::Highlight)
                                                     : QColor(40, 40, 40);
    painter.setPen(QPen(rim, handle.Light == this->Current ? 2.5 : 1.5));
    painter.drawEllipse(handle.Place, HandleRadius - 2.0, HandleRadius - 2.0);
  }
}
}
