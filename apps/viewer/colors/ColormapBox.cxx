// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColormapBox.h"

#include "Colormaps.h"

#include "vtkColorTransferFunction.h"

#include <QIcon>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>

namespace viewer
{
namespace
{
const QSize MapSize(56, 12);

// A strip from the first colour to the last.
QIcon DrawMap(const std::string& map)
{
  QPixmap strip(MapSize);
  QPainter painter(&strip);
  const auto colors = look::MakeColormap(map, { 0.0, 1.0 });
  for (int x = 0; x < MapSize.width(); ++x)
  {
    const double* rgb = colors->GetColor(static_cast<double>(x) / (MapSize.width() - 1));
    painter.fillRect(x, 0, 1, MapSize.height(), QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
  }
  painter.end();
  return strip;
}
}

//------------------------------------------------------------------------------
ColormapBox::ColormapBox(QWidget* parent)
  : QComboBox(parent)
{
  this->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->setMinimumContentsLength(8);
  this->setIconSize(MapSize);
  for (const std::string& name : look::GetColormapNames())
  {
    this->addItem(DrawMap(name), QString::fromStdString(name));
  }
}

//------------------------------------------------------------------------------
void ColormapBox::Show(const std::string& map)
{
  const QSignalBlocker quiet(this);
  const QString text = QString::fromStdString(map);
  if (this->findText(text) < 0)
  {
    this->addItem(DrawMap(map), text);
  }
  this->setCurrentIndex(this->findText(text));
  if (this->lineEdit())
  {
    this->lineEdit()->setCursorPosition(0); // shows the beginning of long words
  }
}
}
