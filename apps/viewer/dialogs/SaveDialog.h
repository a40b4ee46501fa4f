// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Dialogs for saving: the file and its contents.
 */
#ifndef SaveDialog_h
#define SaveDialog_h

#include "LayerWords.h"

#include <QSize>
#include <QString>

#include <optional>
#include <string>
#include <vector>

class QWidget;

namespace viewer
{
/// Asks for a path that ends in the suffix, such as ".png", in either case; empty if the user
/// cancels. An existing file is returned only after the user's consent. `more` is shown below the
/// files.
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
/// None if the user cancels. `size` is the view's, `lights` are the names of layers of lights.
std::optional<PictureChoice> AskPicture(QWidget* parent, const QSize& size);
std::optional<PictureChoice> AskFilm(QWidget* parent, const QSize& size);
std::optional<LayersChoice> AskLayers(QWidget* parent, const QSize& size,
  const std::vector<std::string>& layers, const relievoQt::LightNames& lights);
///@}
}

#endif
