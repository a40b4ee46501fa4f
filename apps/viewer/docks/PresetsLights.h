// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Words on the lights of the preset, which no control shows: that they are on, and what lights of
 * the user's own change. Hidden where there are none.
 */
#ifndef PresetsLights_h
#define PresetsLights_h

#include "Document.h"

#include <QLabel>

namespace viewer
{
class PresetsLights : public QLabel
{
  Q_OBJECT

public:
  /// `own`: what the user may add.
  PresetsLights(Document* document, const QString& own, QWidget* parent = nullptr);

private:
  void ShowSettings();

  Document* Edited;
  QString Own;
};
}

#endif
