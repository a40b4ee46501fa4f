// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SaveDialog.h"

#include "Options.h"
#include "RecentFiles.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QSettings>
#include <QSpinBox>

#include <cmath>

namespace viewer
{
namespace
{
const char* const LayersKey = "saved_layers"; // of QSettings: names
constexpr int LayersHeight = 130;

const QStringList UsualLayers = { "color", "depth", "position", "normal", "actor", "block",
  "cell" };

//------------------------------------------------------------------------------
// Pixels: the view's size, a multiple of it, or any size.
class SizeEdit : public QWidget
{
public:
  explicit SizeEdit(const QSize& view)
    : Sizes(new QComboBox(this))
    , Width(new QSpinBox(this))
    , Height(new QSpinBox(this))
    , Linked(new QCheckBox("Linked", this))
  {
    this->Sizes->setObjectName("sizes");
    this->Width->setObjectName("width");
    this->Height->setObjectName("height");
    this->Linked->setObjectName("linked");
    this->Linked->setToolTip("A changed width changes the height too, and the other way round, so "
                             "that their ratio stays");
    this->Linked->setChecked(true);
    const std::pair<const char*, QSize> all[] = { { "As the view", view },
      { "Twice the view", 2 * view }, { "Four times the view", 4 * view },
      { "Full HD", { 1920, 1080 } }, { "4K", { 3840, 2160 } }, { "Other", {} } };
    for (const auto& [text, size] : all)
    {
      if (size.width() <= scene::LargestSize && size.height() <= scene::LargestSize)
      {
        this->Sizes->addItem(text, size);
      }
    }
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(this->Sizes);
    row->addWidget(this->Width);
    row->addWidget(new QLabel(QChar(0xd7), this));
    row->addWidget(this->Height);
    row->addWidget(new QLabel("pixels", this));
    row->addWidget(this->Linked);
    row->addStretch(1);
    for (QSpinBox* side : { this->Width, this->Height })
    {
      side->setRange(1, scene::LargestSize);
      QObject::connect(side, static_cast<void (QSpinBox::*)(int)>(&QSpinBox::valueChanged), this,
        [this, side] { this->Follow(side); });
    }
    QObject::connect(this->Linked, &QCheckBox::toggled, this, [this] { this->KeepRatio(); });
    QObject::connect(this->Sizes,
      static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this,
      [this] { this->ShowNumbers(); });
    this->ShowNumbers();
  }

  QSize GetSize() const { return { this->Width->value(), this->Height->value() }; }

private:
  void ShowNumbers()
  {
    const QSize size = this->Sizes->currentData().toSize();
    if (size.isValid())
    {
      const QSignalBlocker quiet[] = { QSignalBlocker(this->Width), QSignalBlocker(this->Height) };
      this->Width->setValue(size.width());
      this->Height->setValue(size.height());
      this->KeepRatio();
    }
  }

  void KeepRatio()
  {
    this->Ratio = static_cast<double>(this->Width->value()) / this->Height->value();
  }

  // The other side of a changed one, which stops where the other is largest.
  void Follow(QSpinBox* side)
  {
    if (this->Linked->isChecked())
    {
      QSpinBox* other = side == this->Width ? this->Height : this->Width;
      const double ratio = side == this->Width ? this->Ratio : 1.0 / this->Ratio;
      const QSignalBlocker quiet[] = { QSignalBlocker(side), QSignalBlocker(other) };
      const auto length = static_cast<int>(std::lround(side->value() / ratio));
      other->setValue(length);
      if (length > other->maximum())
      {
        side->setValue(static_cast<int>(std::lround(other->maximum() * ratio)));
      }
    }
    this->ShowName();
  }

  void ShowName()
  {
    const QSignalBlocker quiet(this->Sizes);
    const int found = this->Sizes->findData(this->GetSize());
    this->Sizes->setCurrentIndex(found < 0 ? this->Sizes->count() - 1 : found);
  }

  QComboBox* Sizes;
  QSpinBox *Width, *Height;
  QCheckBox* Linked;
  double Ratio = 1.0; // of width to height
};

//------------------------------------------------------------------------------
QString Run(QFileDialog& dialog, const QString& suffix)
{
  while (dialog.exec() == QDialog::Accepted)
  {
    QString path = dialog.selectedFiles().value(0);
    if (path.endsWith(suffix, Qt::CaseInsensitive))
    {
      return path; // the dialog has already asked about overwriting
    }
    path += suffix; // the dialog treats any text after a dot as a suffix
    if (!QFileInfo::exists(path) ||
      QMessageBox::question(dialog.parentWidget(), dialog.windowTitle(),
        QFileInfo(path).fileName() + " exists already. Do you want to replace it?",
        QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes)
    {
      return path;
    }
  }
  return QString();
}
}

//------------------------------------------------------------------------------
QString AskPlace(QWidget* parent, const QString& title, const QString& suffix, QWidget* more)
{
  QFileDialog dialog(parent, title, GetLastFolder(), "*" + suffix);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix.mid(1));
  if (const QFileInfo shown(parent->windowFilePath()); !shown.completeBaseName().isEmpty())
  {
    dialog.selectFile(shown.completeBaseName() + suffix);
  }
  if (more)
  {
    dialog.setOption(QFileDialog::DontUseNativeDialog); // native ones take no widgets
    auto* rows = static_cast<QGridLayout*>(dialog.layout());
    rows->addWidget(more, rows->rowCount(), 0, 1, rows->columnCount());
  }
  const QString path = Run(dialog, suffix);
  if (more)
  {
    more->setParent(nullptr); // the dialog does not own it
  }
  return path;
}

//------------------------------------------------------------------------------
std::optional<PictureChoice> AskPicture(QWidget* parent, const QSize& size)
{
  QWidget more;
  auto* rows = new QFormLayout(&more);
  rows->setContentsMargins(0, 0, 0, 0);
  auto* pixels = new SizeEdit(size);
  auto* transparent = new QCheckBox("Transparent background");
  transparent->setObjectName("transparent");
  transparent->setToolTip("The ground shows only its shadows, as translucent black");
  rows->addRow("Size", pixels);
  rows->addRow("", transparent);
  const QString path = AskPlace(parent, "Save picture", ".png", &more);
  if (path.isEmpty())
  {
    return std::nullopt;
  }
  return PictureChoice{ path, pixels->GetSize(), transparent->isChecked() };
}

//------------------------------------------------------------------------------
std::optional<PictureChoice> AskFilm(QWidget* parent, const QSize& size)
{
  QWidget more;
  auto* rows = new QFormLayout(&more);
  rows->setContentsMargins(0, 0, 0, 0);
  auto* pixels = new SizeEdit(size);
  rows->addRow("Size", pixels);
  const QString path = AskPlace(parent, "Save film", ".mp4", &more);
  return path.isEmpty() ? std::nullopt : std::optional<PictureChoice>({ path, pixels->GetSize() });
}

//------------------------------------------------------------------------------
std::optional<LayersChoice> AskLayers(QWidget* parent, const QSize& size,
  const std::vector<std::string>& layers, const relievoQt::LightNames& lights)
{
  QWidget more;
  auto* rows = new QFormLayout(&more);
  rows->setContentsMargins(0, 0, 0, 0);
  auto* pixels = new SizeEdit(size);
  auto* list = new QListWidget;
  list->setObjectName("layersToSave");
  list->setFlow(QListView::LeftToRight);
  list->setResizeMode(QListView::Adjust);
  list->setWrapping(true);
  list->setSpacing(2);
  list->setFixedHeight(LayersHeight);
  const QStringList kept = QSettings().value(LayersKey, UsualLayers).toStringList();
  for (const std::string& layer : layers)
  {
    const QString name = QString::fromStdString(layer);
    auto* item = new QListWidgetItem(relievoQt::NameLayer(layer, lights), list);
    item->setData(Qt::UserRole, name);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    item->setCheckState(kept.contains(name) ? Qt::Checked : Qt::Unchecked);
  }
  rows->addRow("Size", pixels);
  rows->addRow("Layers", list);
  LayersChoice choice;
  choice.Path = AskPlace(parent, "Save layers", ".exr", &more);
  QStringList names;
  for (int i = 0; i < list->count(); ++i)
  {
    if (list->item(i)->checkState() == Qt::Checked)
    {
      names += list->item(i)->data(Qt::UserRole).toString();
      choice.Layers.push_back(names.back().toStdString());
    }
  }
  if (choice.Path.isEmpty())
  {
    return std::nullopt;
  }
  QSettings().setValue(LayersKey, names);
  choice.Size = pixels->GetSize();
  return choice;
}
}
