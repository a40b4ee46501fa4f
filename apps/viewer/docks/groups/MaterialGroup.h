// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Surface maps from images: normals and heights, and their placement on meshes.
 */
#ifndef MaterialGroup_h
#define MaterialGroup_h

#include "Document.h"
#include "FoldGroup.h"

class QComboBox;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class FileEdit;
class SurfaceValues;

class MaterialGroup : public FoldGroup
{
  Q_OBJECT

public:
  explicit MaterialGroup(Document* document, QWidget* parent = nullptr);

private:
  void SetNormalMap(const std::string& file);
  void SetHeightMap(const std::string& file, double depth);
  void ShowSettings();

  Document* Edited;
  FileEdit *Normals, *Heights;
  relievoQt::Number* Depth;
  QComboBox *Relief, *Coordinates;
  SurfaceValues* Values;
};
}

#endif
