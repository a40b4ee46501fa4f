// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneText.h"

#include "FileFacts.h"
#include "Picture.h"

#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <QFileInfo>
#include <QLocale>

namespace viewer
{
namespace
{
QString WriteNumber(double value)
{
  return QString::number(value, 'g', 6);
}

QString WriteRow(const QString& name, const QString& text)
{
  return "<tr><td>" + name.toHtmlEscaped() + "&nbsp;&nbsp;&nbsp;</td><td>" + text.toHtmlEscaped() +
    "</td></tr>";
}

QString WriteArray(const ArrayFacts& array)
{
  const QString many = array.Components > 1
    ? QString(", %1 components, magnitude ").arg(array.Components)
    : QString(", ");
  return WriteRow(QString::fromStdString(array.Name) + (array.OfCells ? " (cells)" : " (points)"),
    QString::fromStdString(array.Type) + many +
      (array.Range[0] <= array.Range[1]
          ? WriteNumber(array.Range[0]) + " to " + WriteNumber(array.Range[1])
          : QString("no finite value")));
}

QString WriteFile(const FileFacts& facts)
{
  const QFileInfo file(QString::fromStdString(facts.Path));
  const QLocale english(QLocale::English);
  QString rows = WriteRow("Folder", file.absolutePath()) +
    WriteRow("Size", english.formattedDataSize(file.size())) +
    WriteRow("Format", file.suffix().toUpper()) + WriteRow("Parts", QString::number(facts.Parts)) +
    WriteRow("Points", english.toString(qlonglong(facts.Points))) +
    WriteRow("Cells", english.toString(qlonglong(facts.Cells)));
  if (facts.Dimensions[0] > 0)
  {
    rows += WriteRow("Image", WriteDimensions(facts.Dimensions));
  }
  if (facts.Textures > 0)
  {
    rows += WriteRow("Textures", QString::number(facts.Textures));
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    rows += WriteRow(QString("xyz").mid(static_cast<int>(axis), 1),
      WriteNumber(facts.Bounds[2 * axis]) + " to " + WriteNumber(facts.Bounds[2 * axis + 1]));
  }
  for (const ArrayFacts& array : facts.Arrays)
  {
    rows += WriteArray(array);
  }
  return "<h3>" + file.fileName().toHtmlEscaped() + "</h3><table>" + rows + "</table>";
}
}

//------------------------------------------------------------------------------
QString WriteDimensions(const std::array<int, 3>& dimensions)
{
  const QString times = QString(" ") + QChar(0xd7) + " ";
  return QString::number(dimensions[0]) + times + QString::number(dimensions[1]) + times +
    QString::number(dimensions[2]) + " points";
}

//------------------------------------------------------------------------------
QString WriteScene(const Picture& picture, const std::vector<std::string>& files)
{
  if (picture.IsEmpty())
  {
    return "Nothing is open.";
  }
  const scene::Scene& scene = picture.GetScene().GetScene();
  QString text;
  for (const FileFacts& file : GetFileFacts(picture, files, true))
  {
    text += WriteFile(file);
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
