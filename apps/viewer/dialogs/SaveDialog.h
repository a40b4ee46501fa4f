// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where to save to, and what.
 */
#ifndef SaveDialog_h
#define SaveDialog_h

#include <QSize>
#include <QString>

#include <optional>
#include <string>
#include <vector>

class QWidget;

namespace viewer
{
/// A path to save to that ends in the suffix, such as ".png", in letters of any case; empty if the
/// user wants none. Nothing that exists is given without the user's word. `more` is shown below
/// the files.
QString AskPlace(
  QWidget* parent, const QString& title, const QString& suffix, QWidget* more = nullptr);

struct PictureChoice
{
  QString Path;
  QSize Size; ///< pixels
  bool Transparent = false;
};

struct LayersChoice
{
  QString Path;
  QSize Size;
  std::vector<std::string> Layers;
};

///@{
/// None: the user wants none. `size` is the view's.
std::optional<PictureChoice> AskPicture(QWidget* parent, const QSize& size);
std::optional<LayersChoice> AskLayers(
  QWidget* parent, const QSize& size, const std::vector<std::string>& layers);
///@}
}

#endif
