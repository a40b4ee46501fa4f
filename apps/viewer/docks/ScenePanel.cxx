// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScenePanel.h"

#include "CameraOptions.h"
#include "ModelGroup.h"
#include "Number.h"
#include "OptionEdits.h"
#include "Options.h"
#include "PathGroup.h"
#include "Presets.h"
#include "SceneText.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int NamePixels = 280;       // longer names are elided in the middle
constexpr std::size_t MostInFull = 3; // with more files, each is summarised
constexpr int MostArrays = 12;

QString MakeRow(const QString& title, const QString& text)
{
  return "<tr><td>" + title + "&nbsp;&nbsp;</td><td>" + text.toHtmlEscaped() + "</td></tr>";
}

QString WriteSize(const std::array<double, 6>& bounds)
{
  QStringList sides;
  for (std::size_t i = 0; i < 3; ++i)
  {
    sides += QLocale().toString(bounds[2 * i + 1] - bounds[2 * i], 'g', 4);
  }
  return sides.join(QString(" ") + QChar(0xd7) + " ");
}

QString WriteBounds(const std::array<double, 6>& bounds)
{
  QString rows;
  for (std::size_t i = 0; i < 3; ++i)
  {
    rows += MakeRow(QString("xyz").mid(static_cast<int>(i), 1),
      QLocale().toString(bounds[2 * i], 'g', 6) + " to " +
        QLocale().toString(bounds[2 * i + 1], 'g', 6));
  }
  return rows;
}

QString WriteArrays(const std::vector<ArrayFacts>& arrays)
{
  QStringList words;
  for (const ArrayFacts& array : arrays)
  {
    words += QString::fromStdString(array.Name) + (array.OfCells ? " (cells)" : "");
  }
  const auto more = words.size() - MostArrays;
  return more > 0 ? words.mid(0, MostArrays).join(", ") + QString(" and %1 more").arg(more)
                  : words.join(", ");
}

QLabel* MakeFile(QWidget* parent)
{
  auto* label = new QLabel(parent);
  label->setObjectName("file");
  label->setWordWrap(true);
  label->setTextFormat(Qt::RichText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

void ShowFile(const FileFacts& file, bool full, QLabel* label)
{
  const QFileInfo path(QString::fromStdString(file.Path));
  QFont bold = label->font();
  bold.setBold(true);
  const QString name = QFontMetrics(bold).elidedText(path.fileName(), Qt::ElideMiddle, NamePixels);
  const QString cells = QLocale().toString(static_cast<qlonglong>(file.Cells)) + " " +
    QString::fromStdString(file.Kind);
  const QString points = QLocale().toString(static_cast<qlonglong>(file.Points));
  const QString size = WriteSize(file.Bounds);
  QString rows = file.Dimensions[0] > 0 ? MakeRow("Image", WriteDimensions(file.Dimensions)) : "";
  rows += MakeRow("Cells", cells);
  if (full)
  {
    rows += MakeRow("Points", points) + MakeRow("Size", size);
    rows += file.Arrays.empty() ? QString() : MakeRow("Arrays", WriteArrays(file.Arrays));
    rows +=
      MakeRow("File", path.suffix().toUpper() + ", " + QLocale().formattedDataSize(path.size()));
  }
  label->setText("<b>" + name.toHtmlEscaped() + "</b><table>" + rows + "</table>");
  label->setToolTip("<p>" + path.absoluteFilePath().toHtmlEscaped() + "</p><table>" +
    MakeRow("Points", points) + MakeRow("Size", size) + WriteBounds(file.Bounds) + "</table>");
}
}

//------------------------------------------------------------------------------
ScenePanel::ScenePanel(Document* document, QWidget* parent)
  : Panel(document, parent)
{
  this->AddFiles();
  this->AddScene();
  this->AddGroup(new ModelGroup(document, this->widget()));
  this->AddCamera();
  this->Path = new PathGroup(this->widget());
  this->AddGroup(this->Path);
  this->AddOptions("Scene");
  QObject::connect(document, &Document::changed, this, &ScenePanel::ShowSettings);
  QObject::connect(document, &Document::factsChanged, this, &ScenePanel::ShowFiles);
  this->ShowSettings();
  this->ShowFiles();
}

//------------------------------------------------------------------------------
void ScenePanel::AddFiles()
{
  FoldGroup* group = this->AddGroup("Files", "shownFiles");
  this->FileRows = new QVBoxLayout();
  this->NoFiles = new QLabel("None yet: Ctrl+O opens some.", group);
  this->FileRows->addWidget(this->NoFiles);
  group->GetRows()->addRow(this->FileRows);
}

//------------------------------------------------------------------------------
void ScenePanel::AddScene()
{
  FoldGroup* group = this->AddGroup("Scene", "scene");
  this->Preset = new QComboBox(group);
  this->Preset->setObjectName("preset");
  for (const std::string& name : scene::GetPresetNames())
  {
    this->Preset->addItem(QString::fromStdString(name));
  }
  this->Preset->setToolTip(
    "Lights, shadows, ground, background and view, unless these panels set them");
  group->GetRows()->addRow("Preset", this->Preset);
  this->Up = AddChoice(this->Edited, group->GetRows(), "--up", "as the file",
    "The axis of the data that points up. North is then z, -z or y");
  this->Ground = AddChoice(this->Edited, group->GetRows(), "--ground", "as the preset",
    "A ground below the scene that catches its shadows, only in the picture");
  this->Grid = MakeFlag(this->Edited, "--grid", group);
  this->Grid->setToolTip("Round the scene, with numbers on its axes");
  group->GetRows()->addRow(this->Grid);
  this->ScaleBar = AddChoice(this->Edited, group->GetRows(), "--scale-bar", "off",
    "A scale bar of a round length at the lower right, with the unit of the scene's "
    "coordinates. In perspective it is correct at the depth of the camera's focal point",
    { { "none", "without a unit" } });
  for (const char* unit : { "nm", "µm", "mm", "cm", "m", "km" })
  {
    this->ScaleBar->addItem(unit, unit);
  }
  this->Images = AddChoice(this->Edited, group->GetRows(), "--image", "as the preset",
    "How images with depth are shown: regions of one value by their smooth surfaces, the surface "
    "where a value is reached, all values as a volume that light passes, or the outer faces",
    { { "labels", "regions (labels)" } });
  const auto changed = static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged);
  QObject::connect(this->Preset, changed, this, [this] {
    this->Edited->Change([this](scene::Settings& settings) {
      settings.Set("--preset", this->Preset->currentText().toStdString());
    });
  });
}

//------------------------------------------------------------------------------
void ScenePanel::AddCamera()
{
  FoldGroup* group = this->AddGroup("Camera", "camera");
  this->Angle = MakeNumber("--view-angle", 1.0, 2, group);
  this->Angle->setObjectName("viewangle");
  this->Angle->SetUnit("degrees");
  this->Angle->setToolTip("The full vertical angle of the perspective");
  group->GetRows()->addRow("View angle", this->Angle);
  QObject::connect(this->Angle, &relievoQt::Number::edited, this, [this](double angle) {
    this->Edited->Change([&](scene::Settings& settings) {
      SetOption(settings, "--view-angle",
        angle == look::StandardViewAngle ? "" : words::WriteNumber(angle));
    });
  });
}

//------------------------------------------------------------------------------
void ScenePanel::ShowFiles()
{
  // New labels would stay blank until layout, which a playing animation prevents.
  const std::vector<FileFacts>& files = this->Edited->GetFacts().Files;
  this->NoFiles->setVisible(files.empty());
  while (this->Files.size() > files.size())
  {
    delete this->Files.back();
    this->Files.pop_back();
  }
  while (this->Files.size() < files.size())
  {
    this->Files.push_back(MakeFile(this->widget()));
    this->FileRows->addWidget(this->Files.back());
  }
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    ShowFile(files[i], files.size() <= MostInFull, this->Files[i]);
  }
}

//------------------------------------------------------------------------------
void ScenePanel::ShowSettings()
{
  const QSignalBlocker quiet(this->Preset);
  const scene::Settings& settings = this->Edited->Get();
  const scene::RenderOptions options = settings.Parse();
  this->Preset->setCurrentText(QString::fromStdString(options.Preset));
  ShowChoice(this->Up, settings, "--up");
  ShowChoice(this->Ground, settings, "--ground");
  ShowFlag(this->Grid, settings, "--grid");
  ShowChoice(this->ScaleBar, settings, "--scale-bar");
  ShowChoice(this->Images, settings, "--image");
  this->Angle->SetValue(options.View.Angle.value_or(look::StandardViewAngle));
}
}
