// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Icons.h"

#include <QApplication>
#include <QIconEngine>
#include <QMap>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>
#include <functional>

namespace viewer
{
namespace
{
// In a square of 24 units, y downwards.
constexpr double Side = 24.0;
constexpr double Line = 1.6;

struct Sign
{
  QPainterPath Lines, Areas;
};

QPainterPath Polyline(std::initializer_list<QPointF> points)
{
  QPainterPath path;
  path.addPolygon(QPolygonF(QList<QPointF>(points).toVector()));
  return path;
}

//------------------------------------------------------------------------------
Sign DrawOpen()
{
  Sign sign;
  sign.Lines = Polyline({ { 3, 19 }, { 3, 5 }, { 9, 5 }, { 11, 8 }, { 19, 8 }, { 19, 11 } });
  sign.Lines.addPath(Polyline({ { 3, 19 }, { 6.5, 11 }, { 22, 11 }, { 18.5, 19 }, { 3, 19 } }));
  return sign;
}

Sign DrawSave()
{
  Sign sign;
  sign.Lines = Polyline({ { 12, 3 }, { 12, 14 } });
  sign.Lines.addPath(Polyline({ { 7.5, 9.5 }, { 12, 14 }, { 16.5, 9.5 } }));
  sign.Lines.addPath(Polyline({ { 4, 15 }, { 4, 20 }, { 20, 20 }, { 20, 15 } }));
  return sign;
}

// Two sheets.
Sign DrawCopy()
{
  Sign sign;
  sign.Lines.addRoundedRect(8.5, 8.5, 11.5, 12, 1.5, 1.5);
  sign.Lines.addPath(
    Polyline({ { 5.5, 15.5 }, { 4, 15.5 }, { 4, 3.5 }, { 15.5, 3.5 }, { 15.5, 5.5 } }));
  return sign;
}

// A window with the sign at which a shell waits for a command.
Sign DrawPrompt()
{
  Sign sign;
  sign.Lines.addRect(3, 4.5, 18, 15);
  sign.Lines.addPath(Polyline({ { 6.5, 9 }, { 10, 12 }, { 6.5, 15 } }));
  sign.Lines.addPath(Polyline({ { 12, 15.5 }, { 17.5, 15.5 } }));
  return sign;
}

Sign DrawUndo()
{
  Sign sign;
  sign.Lines = Polyline({ { 9, 4 }, { 4, 9 }, { 9, 14 } });
  QPainterPath back(QPointF(4, 9));
  back.lineTo(14.5, 9);
  back.arcTo(9.5, 9, 10, 10, 90, -180);
  back.lineTo(8, 19);
  sign.Lines.addPath(back);
  return sign;
}

Sign Mirror(const Sign& sign)
{
  const QTransform mirror(-1, 0, 0, 1, Side, 0);
  return { mirror.map(sign.Lines), mirror.map(sign.Areas) };
}

// Corners around the centre.
QPainterPath DrawCorners(double from, double to, double length)
{
  QPainterPath path;
  for (const double x : { from, to })
  {
    for (const double y : { from, to })
    {
      const double inX = x == from ? length : -length;
      const double inY = y == from ? length : -length;
      path.addPath(Polyline({ { x + inX, y }, { x, y }, { x, y + inY } }));
    }
  }
  return path;
}

Sign DrawFit()
{
  Sign sign;
  sign.Lines = DrawCorners(3.5, 20.5, 4.0);
  sign.Areas.addEllipse(QPointF(12, 12), 4.5, 4.5);
  return sign;
}

Sign DrawFullScreen()
{
  Sign sign;
  sign.Lines = DrawCorners(3.5, 20.5, 5.0);
  sign.Lines.addPath(Polyline({ { 4, 4 }, { 9.5, 9.5 } }));
  sign.Lines.addPath(Polyline({ { 20, 20 }, { 14.5, 14.5 } }));
  return sign;
}

// A box, one side of it filled.
Sign DrawViews()
{
  Sign sign;
  sign.Lines = Polyline(
    { { 12, 3 }, { 20, 7.5 }, { 20, 16.5 }, { 12, 21 }, { 4, 16.5 }, { 4, 7.5 }, { 12, 3 } });
  sign.Lines.addPath(Polyline({ { 4, 7.5 }, { 12, 12 }, { 20, 7.5 } }));
  sign.Lines.addPath(Polyline({ { 12, 12 }, { 12, 21 } }));
  sign.Areas = Polyline({ { 12, 12 }, { 20, 7.5 }, { 20, 16.5 }, { 12, 21 }, { 12, 12 } });
  return sign;
}

Sign DrawGrid()
{
  Sign sign;
  sign.Lines.addRect(4, 4, 16, 16);
  for (const double at : { 9.33, 14.67 })
  {
    sign.Lines.addPath(Polyline({ { at, 4 }, { at, 20 } }));
    sign.Lines.addPath(Polyline({ { 4, at }, { 20, at } }));
  }
  return sign;
}

// A window with a filled column.
Sign DrawPanels()
{
  Sign sign;
  sign.Lines.addRect(3.5, 5, 17, 14);
  sign.Areas.addRect(14.5, 5, 6, 14);
  return sign;
}

// A ball, and below it its shadow.
Sign DrawShadows()
{
  Sign sign;
  sign.Lines.addEllipse(QPointF(10, 8.5), 5.5, 5.5);
  sign.Areas.addEllipse(QPointF(13.5, 19), 7.5, 2.3);
  return sign;
}

Sign DrawPlay()
{
  Sign sign;
  sign.Areas = Polyline({ { 6, 3 }, { 21, 12 }, { 6, 21 }, { 6, 3 } });
  return sign;
}

Sign DrawPause()
{
  Sign sign;
  sign.Areas.addRect(5.5, 4, 4.5, 16);
  sign.Areas.addRect(14, 4, 4.5, 16);
  return sign;
}

//------------------------------------------------------------------------------
const QMap<QString, Sign>& GetSigns()
{
  static const QMap<QString, Sign> signs = { { "open", DrawOpen() }, { "savePicture", DrawSave() },
    { "copyPicture", DrawCopy() }, { "copyCommand", DrawPrompt() }, { "undo", DrawUndo() },
    { "redo", Mirror(DrawUndo()) }, { "fit", DrawFit() }, { "views", DrawViews() },
    { "grid", DrawGrid() }, { "panels", DrawPanels() }, { "shadowsOn", DrawShadows() },
    { "fullScreen", DrawFullScreen() }, { "play", DrawPlay() }, { "pause", DrawPause() } };
  return signs;
}

//------------------------------------------------------------------------------
// Looks up its colour at each painting.
class Engine : public QIconEngine
{
public:
  explicit Engine(const Sign& sign)
    : Drawn(sign)
  {
  }

  QIconEngine* clone() const override { return new Engine(this->Drawn); }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
  {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    this->paint(&painter, QRect(QPoint(), size), mode, state);
    return picture;
  }

  void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override
  {
    const QColor color = QApplication::palette().color(
      mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(place.topLeft());
    const double scale = std::min(place.width(), place.height()) / Side;
    painter->scale(scale, scale);
    painter->fillPath(this->Drawn.Areas, color);
    painter->strokePath(
      this->Drawn.Lines, QPen(color, Line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->restore();
  }

private:
  Sign Drawn;
};
}

//------------------------------------------------------------------------------
QIcon MakeIcon(const QString& name)
{
  const auto found = GetSigns().find(name);
  return found == GetSigns().end() ? QIcon() : QIcon(new Engine(*found));
}
}
