// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Models with bones: the animation, and the method that moves points. Hidden unless a file can have
 * bones.
 */
#ifndef ModelGroup_h
#define ModelGroup_h

#include "Document.h"
#include "FoldGroup.h"

class QCheckBox;
class QComboBox;

namespace viewer
{
class ModelGroup : public FoldGroup
{
  Q_OBJECT

public:
  explicit ModelGroup(Document* document, QWidget* parent = nullptr);

private:
  void ShowAnimations();
  void ShowSettings();

  Document* Edited;
  QComboBox *Animation, *Skin;
  QCheckBox *Loop, *Skeleton;
};
}

#endif
