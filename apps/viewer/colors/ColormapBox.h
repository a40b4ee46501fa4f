// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A combo box of colour maps that shows their colours.
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
  /// All named maps; an entry's text is its word.
  explicit ColormapBox(QWidget* parent);

  /// Shows a word of --colormap, as a new entry if needed. Emits no signal.
  void Show(const std::string& map);
};
}

#endif
