// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Explains the colours of a layer shown as the picture, or why the picture is empty.
 */
#ifndef LayerWords_h
#define LayerWords_h

#include <QImage>
#include <QString>

#include <map>
#include <string>

class vtkRelievoDisplayStage;

namespace relievoQt
{
struct LayerWords
{
  QString Title; ///< the layer's name
  QString Words;
  QString First, Last; ///< values at the strip's ends, the last one with their unit
  QImage Strip;        ///< the colours in a row; null if words suffice

  /// All texts, one per line.
  QString GetText() const;
};

/// Whether the layer is that of a volume, which is where `volume_depth` is finite, not `depth`.
bool IsOfVolume(const std::string& layer);

/// The names of lights, by their layers: shadow_0.
using LightNames = std::map<std::string, std::string>;

/// The display name: "Shadow of light 0" for shadow_0, or of the light's name if it is among
/// `lights`; an array's own name.
QString NameLayer(const std::string& layer, const LightNames& lights = {});

/// The group of a layer in lists: "Surfaces", "Objects", "Light and effects" or "Volumes"; empty
/// for an array.
QString GroupLayer(const std::string& layer);

/// The unit of a layer's values; empty if none is known.
QString GetUnit(const std::string& layer);

/// A layer's value with its unit, if it has a known one.
QString AddUnit(const QString& value, const std::string& layer);

/// `isDrawnHere`: the stage drew the last picture and knows its values; otherwise a server did.
LayerWords DescribeLayer(
  vtkRelievoDisplayStage* stage, bool isDrawnHere = true, const LightNames& lights = {});
}

#endif
