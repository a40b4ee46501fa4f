// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerLegend.h"

#include "Colormaps.h"
#include "LookOptions.h"

#include "vtkColorTransferFunction.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoLayer.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoPass.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
// Pixels
constexpr int Left = 108; // beside the axes
constexpr int Width = 300;
constexpr int Margin = 10;
constexpr int Strip = 12;

QString WriteValue(double value)
{
  return QString::number(value, 'g', 4);
}

QString GetUnit(const std::string& layer)
{
  for (const char* name : { "depth", "range", "light_depth" })
  {
    if (layer == name)
    {
      return " (world units)";
    }
  }
  return QString();
}

// The most components that an array has, by its name in the words of layers.
int CountComponents(const std::string& layer, const Facts& facts)
{
  const std::size_t colon = layer.find(':');
  for (const std::string& name :
    { layer, colon == std::string::npos ? layer : layer.substr(colon + 1) })
  {
    const auto found = facts.Components.find(name);
    if (found != facts.Components.end())
    {
      return found->second;
    }
  }
  return 1;
}
}

//------------------------------------------------------------------------------
LayerLegend::LayerLegend(QWidget* parent)
  : Overlay(parent)
{
  this->setObjectName("layerLegend");
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->hide();
}

//------------------------------------------------------------------------------
void LayerLegend::Follow(vtkRelievoPass* frame, const Facts& facts)
{
  auto* stage = frame ? vtkRelievoDisplayStage::SafeDownCast(frame->GetStage("display")) : nullptr;
  const std::string layer = stage ? stage->GetLayer() : std::string();
  this->setVisible(!layer.empty());
  if (layer.empty())
  {
    return;
  }
  // Whose name may be any that the user gave it.
  const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::GetIsOfLight(layer)
    ? vtkRelievoLayerCatalogue::GetOfLight()
    : vtkRelievoLayerCatalogue::Find(layer);
  const double* range = stage->GetShownRange();
  this->Title = QString::fromStdString(layer) + GetUnit(layer);
  this->Words = QString::fromStdString(known.Help);
  this->First.clear();
  this->Last.clear();
  this->Grey = stage->GetGrey() || known.Kind == vtkRelievoLayer::SHARE;
  if (stage->GetReasonCode() != "ran")
  {
    this->Words = "Nothing to see: " + QString::fromStdString(stage->GetReason());
  }
  else if (!std::isfinite(range[0]))
  {
    this->Words = "Nothing to see: no pixel has a value";
  }
  else if (stage->GetSame())
  {
    this->Words = "Nothing to see: all pixels are alike (" + this->Words + ")";
  }
  else if (known.Kind == vtkRelievoLayer::ID)
  {
    this->Words += "; each has a colour of its own";
  }
  else if (known.Kind == vtkRelievoLayer::VECTOR)
  {
    this->Words += "; x, y and z from -1 to 1 as red, green and blue";
  }
  else if (known.Kind == vtkRelievoLayer::POSITION)
  {
    this->Words += "; x, y and z as red, green and blue, each from the least to the greatest seen";
  }
  else if (known.Kind == vtkRelievoLayer::ARRAY && CountComponents(layer, facts) > 2)
  {
    this->Words = "The first three components as red, green and blue, each from the least to the "
                  "greatest seen";
  }
  else if (known.Kind != vtkRelievoLayer::COLOR)
  {
    this->First = WriteValue(range[0]);
    this->Last = WriteValue(range[1]);
  }
  this->Place();
  this->update();
}

//------------------------------------------------------------------------------
QString LayerLegend::GetText() const
{
  return this->isHidden()
    ? QString()
    : QStringList({ this->Title, this->Words, this->First, this->Last }).join('\n');
}

//------------------------------------------------------------------------------
void LayerLegend::Place()
{
  const QFontMetrics letters(this->font());
  const int width = std::min(Width, this->parentWidget()->width() - Left - 4);
  const int words =
    letters.boundingRect(0, 0, width - 2 * Margin, 1000, Qt::TextWordWrap, this->Words).height();
  const int strip = this->First.isEmpty() ? 0 : Strip + letters.height() + 6;
  const int height = 2 * Margin + letters.height() + words + strip;
  this->setGeometry(Left, this->parentWidget()->height() - height - 8, width, height);
}

//------------------------------------------------------------------------------
// White on dark, which can be read over any picture.
void LayerLegend::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 20, 20, 190));
  painter.drawRoundedRect(this->rect(), 5, 5);
  painter.setPen(Qt::white);
  const QFontMetrics letters(this->font());
  QRect room = this->rect().adjusted(Margin, Margin, -Margin, -Margin);
  QFont bold = this->font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.drawText(room, Qt::AlignTop | Qt::AlignLeft, this->Title);
  painter.setFont(this->font());
  room.setTop(room.top() + letters.height());
  if (!this->First.isEmpty())
  {
    const auto map =
      scene::MakeColormap(this->Grey ? "grey" : scene::DefaultColormap, { 0.0, 1.0 });
    QLinearGradient colors(room.left(), 0, room.right(), 0);
    constexpr int Steps = 32;
    for (int i = 0; i <= Steps; ++i)
    {
      const double share = static_cast<double>(i) / Steps;
      const double* rgb = map->GetColor(share);
      colors.setColorAt(share, QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
    }
    const QRect strip(room.left(), room.top() + 3, room.width(), Strip);
    painter.fillRect(strip, colors);
    room.setTop(strip.bottom() + 3);
    painter.drawText(room, Qt::AlignTop | Qt::AlignLeft, this->First);
    painter.drawText(room, Qt::AlignTop | Qt::AlignRight, this->Last);
    room.setTop(room.top() + letters.height());
  }
  painter.drawText(room, Qt::TextWordWrap, this->Words);
}
}
