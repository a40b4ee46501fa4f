// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Volumes: opacity by value, the step of rays, and shadows.
 */
#ifndef VolumeGroup_h
#define VolumeGroup_h

#include "Document.h"
#include "FoldGroup.h"
#include "VolumeFacts.h"

#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class OpacityCurve;

class VolumeGroup : public FoldGroup
{
  Q_OBJECT

public:
  /// `read`: the present picture's first volume; none without a volume, which hides the group.
  using Reader = std::function<std::optional<VolumeFacts>()>;
  VolumeGroup(Document* document, Reader read, QWidget* parent = nullptr);

private:
  void ShowVolume();
  void ShowSettings();

  Document* Edited;
  Reader Read;
  OpacityCurve* Curve;
  QCheckBox* Found;
  relievoQt::Number* Step;
  QComboBox* Shadows;
};
}

#endif
