// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneText.h"

#include "DataSets.h"
#include "Picture.h"

#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <map>
#include <set>

namespace viewer
{
namespace
{
struct Array
{
  QString Type;
  int Components = 0;
  std::array<double, 2> Range = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX }; // of several, the magnitude
};

// What the actors of one file show.
struct Contents
{
  vtkIdType Points = 0, Cells = 0;
  int Parts = 0;
  std::set<vtkTexture*> Textures;
  vtkBoundingBox Bounds;
  std::map<QString, Array> Arrays; // by name and place
};

void AddArrays(vtkDataSetAttributes* attributes, const char* place, Contents& contents)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && array->GetName())
    {
      Array& known = contents.Arrays[QString("%1 (%2)").arg(array->GetName(), place)];
      known.Type = array->GetDataTypeAsString();
      known.Components = std::max(known.Components, array->GetNumberOfComponents());
      double range[2];
      array->GetFiniteRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
      known.Range = { std::min(known.Range[0], range[0]), std::max(known.Range[1], range[1]) };
    }
  }
}

void Add(vtkActor* actor, Contents& contents)
{
  ++contents.Parts;
  if (actor->GetTexture())
  {
    contents.Textures.insert(actor->GetTexture());
  }
  for (const auto& texture : actor->GetProperty()->GetAllTextures())
  {
    contents.Textures.insert(texture.second);
  }
  contents.Bounds.AddBounds(actor->GetBounds());
  scene::ForEachDataSet(actor->GetMapper()->GetInputDataObject(0, 0), [&](vtkDataSet* block) {
    contents.Points += block->GetNumberOfPoints();
    contents.Cells += block->GetNumberOfCells();
    AddArrays(block->GetPointData(), "points", contents);
    AddArrays(block->GetCellData(), "cells", contents);
  });
}

QString WriteNumber(double value)
{
  return QString::number(value, 'g', 6);
}

QString WriteRow(const QString& name, const QString& text)
{
  return "<tr><td>" + name.toHtmlEscaped() + "&nbsp;&nbsp;&nbsp;</td><td>" + text.toHtmlEscaped() +
    "</td></tr>";
}

QString WriteFile(const std::string& path, const Contents& contents)
{
  const QFileInfo file(QString::fromStdString(path));
  const QLocale english(QLocale::English);
  QString rows = WriteRow("Folder", file.absolutePath()) +
    WriteRow("Size", english.formattedDataSize(file.size())) +
    WriteRow("Format", file.suffix().toUpper()) +
    WriteRow("Parts", QString::number(contents.Parts)) +
    WriteRow("Points", english.toString(qlonglong(contents.Points))) +
    WriteRow("Cells", english.toString(qlonglong(contents.Cells)));
  if (!contents.Textures.empty())
  {
    rows += WriteRow("Textures", QString::number(contents.Textures.size()));
  }
  for (int axis = 0; axis < 3 && contents.Bounds.IsValid(); ++axis)
  {
    rows += WriteRow(QString("xyz").mid(axis, 1),
      WriteNumber(contents.Bounds.GetBound(2 * axis)) + " to " +
        WriteNumber(contents.Bounds.GetBound(2 * axis + 1)));
  }
  for (auto it = contents.Arrays.begin(); it != contents.Arrays.end(); ++it)
  {
    const Array& array = it->second;
    const QString many = array.Components > 1
      ? QString(", %1 components, magnitude ").arg(array.Components)
      : QString(", ");
    rows += WriteRow(it->first,
      array.Type + many +
        (array.Range[0] <= array.Range[1]
            ? WriteNumber(array.Range[0]) + " to " + WriteNumber(array.Range[1])
            : QString("no finite value")));
  }
  return "<h3>" + file.fileName().toHtmlEscaped() + "</h3><table>" + rows + "</table>";
}
}

//------------------------------------------------------------------------------
QString WriteScene(const Picture& picture, const std::vector<std::string>& files)
{
  const scene::BareScene& bare = picture.GetScene().GetBare();
  const scene::Scene& scene = bare.Get();
  std::vector<Contents> all(files.size());
  std::size_t file = 0;
  int left = scene.Counts.empty() ? 0 : scene.Counts.front();
  vtkActorCollection* actors = scene.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    if (!bare.Find(actor) || !actor->GetMapper()) // as the ground and skeletons
    {
      continue;
    }
    while (left == 0 && file + 1 < std::min(all.size(), scene.Counts.size()))
    {
      left = scene.Counts[++file];
    }
    --left;
    Add(actor, all[file]);
  }
  QString text;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    text += WriteFile(files[i], all[i]);
  }
  const int lights = scene.Renderer->GetLights()->GetNumberOfItems();
  QString rows = WriteRow("Lights", QString::number(lights));
  rows += WriteRow("Up axis", QString("xyz").mid(scene.UpAxis, 1));
  if (scene.Times)
  {
    rows += WriteRow(
      "Times", WriteNumber((*scene.Times)[0]) + " to " + WriteNumber((*scene.Times)[1]) + " s");
  }
  return text + "<h3>The scene</h3><table>" + rows + "</table>";
}
}
