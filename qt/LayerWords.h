// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the colours of the layer that is shown as the picture mean, or why there is nothing to see.
 */
#ifndef LayerWords_h
#define LayerWords_h

#include <QImage>
#include <QString>

#include <string>

class vtkRelievoDisplayStage;

namespace relievoQt
{
struct LayerWords
{
  QString Title; ///< the layer, and the unit of its values
  QString Words;
  QString First, Last; ///< what the ends of the strip stand for
  QImage Strip;        ///< the colours in a row; null where words tell all

  /// All texts, a line each.
  QString GetText() const;
};

/// The name for people: "Shadow of light 0" for shadow_0; that of an array as it is.
QString NameLayer(const std::string& layer);

/// `isDrawnHere`: the stage drew the last picture, and knows its values; if not, a server did.
LayerWords DescribeLayer(vtkRelievoDisplayStage* stage, bool isDrawnHere = true);
}

#endif
