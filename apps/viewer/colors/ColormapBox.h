// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A choice of colour maps that shows their colours.
 */
#ifndef ColormapBox_h
#define ColormapBox_h

#include <QComboBox>

#include <string>

namespace viewer
{
class ColormapBox : public QComboBox
{
  Q_OBJECT

public:
  /// All maps that have a name; an entry's text is the word.
  explicit ColormapBox(QWidget* parent);

  /// Shows a word of --colormap, as a new entry where there is none. Sends no signal.
  void Show(const std::string& map);
};
}

#endif
