// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonPanel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int LeastWidth = 340; // of other panels
constexpr int SwatchSide = 14;
constexpr Qt::Key HeldKey = Qt::Key_B;

QString WriteCount(double count)
{
  return QLocale().toString(static_cast<qlonglong>(count));
}

QLabel* AddText(QVBoxLayout* column, const char* name)
{
  auto* label = new QLabel(column->parentWidget());
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(label);
  return label;
}
}

//------------------------------------------------------------------------------
ComparisonPanel::ComparisonPanel(QWidget* parent)
  : QWidget(parent)
  , View(new ComparisonView(this))
  , Table(new QTableWidget(0, 3, this))
  , Again(new QPushButton("Compare again", this))
  , Save(new QPushButton("Save report...", this))
{
  auto* column = new QVBoxLayout(this);
  this->Summary = AddText(column, "comparisonSummary");
  QFont bold = this->Summary->font();
  bold.setBold(true);
  this->Summary->setFont(bold);
  this->About = AddText(column, "comparisonAbout");
  this->About->setText("Nothing is compared yet. File > Compare with compares the scene with a "
                       "baseline or a picture.");
  this->Outdated = AddText(column, "comparisonOutdated");
  this->Outdated->setText("The settings have changed since this comparison.");
  this->Outdated->hide();
  column->addWidget(this->MakeKinds());
  this->View->setObjectName("comparisonView");
  this->View->setToolTip("Hold B to see the baseline. The wheel zooms, a double click shows all");
  this->AddTable();
  auto* parts = new QSplitter(Qt::Vertical, this);
  parts->setChildrenCollapsible(false);
  parts->addWidget(this->View);
  parts->addWidget(this->Table);
  parts->setStretchFactor(0, 3);
  parts->setStretchFactor(1, 2);
  column->addWidget(parts, 1);
  this->Notes = AddText(column, "comparisonNotes");
  auto* buttons = new QHBoxLayout;
  this->Again->setObjectName("compareAgain");
  this->Again->setToolTip("Draws the scene as it is now, and compares it with the same file");
  this->Save->setObjectName("saveReport");
  this->Save->setToolTip("A page for browsers with both pictures and this table, in one file");
  buttons->addWidget(this->Again);
  buttons->addWidget(this->Save);
  buttons->addStretch(1);
  column->addLayout(buttons);
  this->setMinimumWidth(LeastWidth);
  for (QPushButton* button : { this->Again, this->Save })
  {
    button->setEnabled(false);
  }
  QObject::connect(this->Again, &QPushButton::clicked, this, &ComparisonPanel::againWanted);
  QObject::connect(this->Save, &QPushButton::clicked, this, &ComparisonPanel::reportWanted);
}

//------------------------------------------------------------------------------
QWidget* ComparisonPanel::MakeKinds()
{
  auto* all = new QWidget(this);
  auto* row = new QHBoxLayout(all);
  row->setContentsMargins(0, 0, 0, 0);
  const char* const names[][3] = { { "Baseline", "showBaseline", "The picture of the file" },
    { "Now", "showNow", "The picture of the scene, as it was when it was compared" },
    { "Causes", "showCauses", "The pixels that differ, in the colours of their causes" } };
  for (std::size_t i = 0; i < this->Kinds.size(); ++i)
  {
    auto* button = new QRadioButton(names[i][0], all);
    button->setObjectName(names[i][1]);
    button->setToolTip(names[i][2]);
    button->setEnabled(false);
    row->addWidget(button);
    this->Kinds[i] = button;
    QObject::connect(button, &QRadioButton::clicked, this,
      [this, i] { this->SetKind(static_cast<ComparisonView::Kind>(i)); });
  }
  row->addStretch(1);
  return all;
}

//------------------------------------------------------------------------------
void ComparisonPanel::AddTable()
{
  this->Table->setObjectName("causes");
  this->Table->setHorizontalHeaderLabels({ "Object", "Cause", "Pixels" });
  this->Table->setToolTip(
    "Click a row to highlight its pixels. Click it again to show those of all causes");
  QHeaderView* header = this->Table->horizontalHeader();
  header->setHighlightSections(false);
  header->setSectionResizeMode(0, QHeaderView::Stretch);
  header->setSectionResizeMode(1, QHeaderView::Stretch);
  header->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  this->Table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->Table->verticalHeader()->hide();
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->setIconSize({ SwatchSide, SwatchSide });
  this->Table->setTabKeyNavigation(false); // Tab moves to the next control
  this->Table->setMinimumHeight(60);
  this->Table->installEventFilter(this);
  QObject::connect(
    this->Table, &QTableWidget::itemSelectionChanged, this, &ComparisonPanel::ShowChosen);
  QObject::connect(this->Table, &QTableWidget::cellClicked, this, [this](int row) {
    this->Clicked = row == this->Clicked ? -1 : row;
    if (this->Clicked < 0)
    {
      this->Table->clearSelection();
    }
  });
}

//------------------------------------------------------------------------------
void ComparisonPanel::Show(vtkRelievoFrameComparison* comparison, const QString& about)
{
  this->Compared = comparison;
  const QString text = QString::fromStdString(comparison->GetText());
  QString summary = text.section('\n', 0, 0);
  summary[0] = summary[0].toUpper();
  summary.replace(QRegularExpression("(\\d) (?=\\d{3})"), QString("\\1") + QChar(QChar::Nbsp));
  this->Summary->setText(summary);
  this->About->setText(about);
  this->SetOutdated(false);
  this->ShowCauses(
    QJsonDocument::fromJson(QByteArray::fromStdString(comparison->GetJSON())).object());
  vtkImageData* causes = comparison->GetCauses();
  this->View->SetFrames(comparison->GetBaseline(), comparison->GetFrame(), causes, this->Colors);
  for (QAbstractButton* button : this->findChildren<QAbstractButton*>())
  {
    button->setEnabled(true);
  }
  this->Kinds[ComparisonView::CAUSES]->setEnabled(causes != nullptr);
  this->SetKind(causes || this->Kind != ComparisonView::CAUSES ? this->Kind : ComparisonView::NOW);
}

//------------------------------------------------------------------------------
void ComparisonPanel::SetOutdated(bool on)
{
  this->Outdated->setVisible(on && this->Compared);
}

//------------------------------------------------------------------------------
void ComparisonPanel::SetKind(ComparisonView::Kind kind)
{
  this->Kind = kind;
  this->Kinds[kind]->setChecked(true);
  this->View->SetKind(kind);
}

//------------------------------------------------------------------------------
// While the key is down, the other picture is shown, so that the eye sees the differences.
void ComparisonPanel::Hold(bool on)
{
  this->View->SetKind(!on                      ? this->Kind
      : this->Kind == ComparisonView::BASELINE ? ComparisonView::NOW
                                               : ComparisonView::BASELINE);
}

//------------------------------------------------------------------------------
bool ComparisonPanel::HoldKey(const QKeyEvent& event, bool isDown)
{
  const bool is =
    event.key() == HeldKey && event.modifiers() == Qt::NoModifier && this->Compared != nullptr;
  if (is && !event.isAutoRepeat())
  {
    this->Hold(isDown);
  }
  return is;
}

//------------------------------------------------------------------------------
void ComparisonPanel::keyPressEvent(QKeyEvent* event)
{
  if (!this->HoldKey(*event, true))
  {
    this->QWidget::keyPressEvent(event);
  }
}

//------------------------------------------------------------------------------
void ComparisonPanel::keyReleaseEvent(QKeyEvent* event)
{
  if (!this->HoldKey(*event, false))
  {
    this->QWidget::keyReleaseEvent(event);
  }
}

//------------------------------------------------------------------------------
// The table would search its rows for the letter.
bool ComparisonPanel::eventFilter(QObject* watched, QEvent* event)
{
  const bool isDown = event->type() == QEvent::KeyPress;
  return ((isDown || event->type() == QEvent::KeyRelease) &&
           this->HoldKey(*static_cast<QKeyEvent*>(event), isDown)) ||
    this->QWidget::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void ComparisonPanel::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::ActivationChange && this->Compared)
  {
    this->Hold(false); // the key's release goes to another window
  }
  this->QWidget::changeEvent(event);
}

//------------------------------------------------------------------------------
void ComparisonPanel::ShowCauses(const QJsonObject& result)
{
  const QSignalBlocker quiet(this->Table);
  this->Table->setRowCount(0);
  this->Colors.clear();
  this->Clicked = -1;
  const QJsonArray causes = result["causes"].toArray();
  for (int i = 0; i < causes.size(); ++i)
  {
    const QJsonObject cause = causes[i].toObject();
    const QString word = cause["cause"].toString();
    const QString words = cause["words"].toString();
    this->AddRow(i, word, { cause["label"].toString(), words.isEmpty() ? word : words },
      cause["pixels"].toDouble());
    if (cause["kind"].toString() == "light")
    {
      this->Table->item(this->Table->rowCount() - 1, 1)
        ->setData(Qt::UserRole, cause["name"].toString());
    }
  }
  const QJsonObject within = result["within_limits"].toObject();
  this->AddRow(ComparisonView::Unexplained, "unexplained",
    { "unexplained", "no cause explains these" }, result["unexplained"].toDouble());
  this->AddRow(ComparisonView::Edge, "edge", { "smooth edges", "within the limits" },
    within["edge"].toDouble());
  this->AddRow(ComparisonView::Rounding, "rounding", { "rounding", "within the limits" },
    within["rounding"].toDouble());
  QStringList unknown;
  for (const QJsonValue& word : result["cannot_be_detected"].toArray())
  {
    unknown += word.toString();
  }
  this->Notes->setText("Cannot be detected in these files: " + unknown.join(", "));
  this->Notes->setVisible(!unknown.isEmpty());
}

//------------------------------------------------------------------------------
// Causes of the list have a row even without pixels, because their records differ.
void ComparisonPanel::AddRow(
  int cause, const QString& word, const QStringList& cells, double pixels)
{
  if (cause < 0 && pixels == 0.0)
  {
    return;
  }
  const QColor color(
    QString::fromStdString(vtkRelievoFrameComparison::GetCauseColor(word.toUtf8())));
  this->Colors[cause] = color;
  const int row = this->Table->rowCount();
  this->Table->insertRow(row);
  const QStringList texts = cells + QStringList(WriteCount(pixels));
  for (int i = 0; i < texts.size(); ++i)
  {
    auto* item = new QTableWidgetItem(texts[i]);
    item->setToolTip("<p>" + texts[i].toHtmlEscaped() + "</p>");
    item->setTextAlignment((i == 2 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    this->Table->setItem(row, i, item);
  }
  QTableWidgetItem* first = this->Table->item(row, 0);
  QPixmap swatch(SwatchSide, SwatchSide);
  swatch.fill(pixels > 0.0 ? color : Qt::transparent);
  QIcon icon(swatch);
  icon.addPixmap(swatch, QIcon::Selected); // in its own colour
  first->setIcon(icon);
  if (pixels > 0.0)
  {
    first->setData(Qt::UserRole, cause);
  }
}

//------------------------------------------------------------------------------
void ComparisonPanel::ShowChosen()
{
  const QList<QTableWidgetItem*> items = this->Table->selectedItems();
  if (items.isEmpty())
  {
    this->View->Choose(std::nullopt);
    return;
  }
  const int row = items.first()->row();
  const QVariant cause = this->Table->item(row, 0)->data(Qt::UserRole);
  this->View->Choose(cause.isValid() ? std::optional(cause.toInt()) : std::nullopt);
  const QVariant light = this->Table->item(row, 1)->data(Qt::UserRole);
  if (light.isValid())
  {
    Q_EMIT this->lightChosen(light.toString());
  }
}
}
