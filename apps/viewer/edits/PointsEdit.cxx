// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointsEdit.h"

#include "ColorButton.h"
#include "Labels.h"
#include "LinearColor.h"
#include "RecentFiles.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace viewer
{
namespace
{
using Pairs = words::NamedWords;

QString Words(const std::string& text)
{
  return QString::fromStdString(text);
}
}

//------------------------------------------------------------------------------
PointsEdit::PointsEdit(Document* document, const std::string& stage, QWidget* parent)
  : QWidget(parent)
  , Edited(document)
  , Stage(stage)
  , Option("--" + stage)
  , Hint(new QLabel(this))
  , Files(new QListWidget(this))
  , RemoveFile(new QPushButton("Remove", this))
  , Values(new QWidget(this))
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  this->Hint->setObjectName("hint");
  this->Hint->setWordWrap(true);
  column->addWidget(this->Hint);
  this->Files->setObjectName("files");
  this->Files->setMaximumHeight(60);
  auto* add = new QPushButton("Add file...", this);
  add->setObjectName("add");
  this->RemoveFile->setObjectName("remove");
  auto* buttons = new QHBoxLayout();
  buttons->addWidget(add);
  buttons->addWidget(this->RemoveFile);
  column->addWidget(this->Files);
  column->addLayout(buttons);
  column->addWidget(this->Values);
  auto* rows = new QFormLayout(this->Values);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (const scene::PointStage& known : scene::GetPointStages())
  {
    if (known.Name == stage)
    {
      this->Described = &known.Points->GetDescription();
      this->Hint->setText(
        "The points of files become " + Words(known.Points->GetThings()) + ": add a file.");
      this->Rows.reserve(this->Described->Parameters.size());
      for (const vtkRelievoParameter& value : this->Described->Parameters)
      {
        this->AddRow(rows, value);
      }
    }
  }
  QObject::connect(add, &QPushButton::clicked, this, &PointsEdit::Ask);
  QObject::connect(this->RemoveFile, &QPushButton::clicked, this, &PointsEdit::Remove);
  QObject::connect(this->Files, &QListWidget::currentRowChanged, this, [this] {
    this->ShowArrays();
    this->ShowValues(true);
  });
  QObject::connect(document, &Document::changed, this, &PointsEdit::ShowSettings);
  QObject::connect(document, &Document::factsChanged, this, &PointsEdit::ShowArrays);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void PointsEdit::AddRow(QFormLayout* rows, const vtkRelievoParameter& value)
{
  this->Rows.emplace_back();
  Row& row = this->Rows.back();
  row.Name = value.Name;
  row.Default = value.Default;
  row.Conditions = value.GetConditions();
  row.Edit = value.Type == vtkRelievoParameter::COLOR ? this->MakeColor(row, value)
                                                      : this->MakeBox(row, value, this->Values);
  row.Edit->setObjectName(Words(value.Name));
  row.Edit->setToolTip(Words(value.Help + " Takes " + value.GetExpected() + "."));
  AddParameterRow(rows, value, row.Edit);
}

//------------------------------------------------------------------------------
QComboBox* PointsEdit::MakeBox(Row& row, const vtkRelievoParameter& value, QWidget* parent)
{
  auto* box = new QComboBox(parent);
  if (!value.Choices.empty() && !value.PerPoint)
  {
    for (std::size_t i = 0; i < value.Choices.size(); ++i)
    {
      const std::string& choice = value.Choices[i];
      box->addItem(
        Words(value.GetChoiceLabel(i)), choice == value.Default ? QString() : Words(choice));
    }
    row.Show = [box](const QString& text) {
      const QSignalBlocker quiet(box);
      box->setCurrentIndex(std::max(0, box->findData(text)));
    };
    QObject::connect(box, static_cast<void (QComboBox::*)(int)>(&QComboBox::activated), this,
      [this, box, name = row.Name] { this->Write(name, box->currentData().toString()); });
    return box;
  }
  box->setEditable(true);
  box->setInsertPolicy(QComboBox::NoInsert);
  box->setCompleter(nullptr); // must not complete a number to a name
  box->setMinimumContentsLength(8);
  box->lineEdit()->setPlaceholderText(
    Words((value.PerPoint ? "array " + value.Name + ", or " : "") + value.Default));
  for (const std::string& choice : value.Choices)
  {
    box->addItem(Words(choice));
  }
  box->setEditText(QString()); // starts without a choice
  if (value.PerPoint)
  {
    row.Arrays = box;
    row.Own = box->count();
  }
  row.Show = [box](const QString& text) {
    const QSignalBlocker quiet(box);
    box->setEditText(text);
  };
  this->Connect(box, row.Name);
  return box;
}

//------------------------------------------------------------------------------
void PointsEdit::Connect(QComboBox* box, const std::string& name)
{
  QObject::connect(box->lineEdit(), &QLineEdit::editingFinished, this,
    [this, box, name] { this->Write(name, box->currentText().trimmed()); });
  QObject::connect(box, static_cast<void (QComboBox::*)(int)>(&QComboBox::activated), this,
    [this, box, name](int item) { this->Write(name, box->itemText(item)); });
}

//------------------------------------------------------------------------------
// A name or three numbers, and the colour for display.
QWidget* PointsEdit::MakeColor(Row& row, const vtkRelievoParameter& value)
{
  auto* both = new QWidget(this->Values);
  auto* layout = new QHBoxLayout(both);
  layout->setContentsMargins(0, 0, 0, 0);
  QComboBox* box = this->MakeBox(row, value, both);
  auto* button = new ColorButton(both);
  button->ShowNames(false);
  layout->addWidget(box, 1);
  layout->addWidget(button);
  both->setFocusProxy(box);
  const std::function<void(const QString&)> show = row.Show;
  row.Show = [show, button, standard = Words(row.Default)](const QString& text) {
    show(text);
    button->SetColor(ReadLinearColor(text.isEmpty() ? standard : text));
  };
  row.Show(QString());
  QObject::connect(button, &ColorButton::edited, this,
    [this, name = row.Name](const QColor& color) { this->Write(name, WriteLinearColor(color)); });
  return both;
}

//------------------------------------------------------------------------------
void PointsEdit::Ask()
{
  const QString file =
    QFileDialog::getOpenFileName(this, "Points for " + Words(this->Stage), GetLastFolder());
  if (!file.isEmpty())
  {
    std::vector<std::string> words = this->Edited->Get().GetAll(this->Option);
    const int last = static_cast<int>(words.size());
    words.push_back(scene::WriteFileAndValues(file.toStdString(), {}));
    this->Edited->Change([&](scene::Settings& settings) { settings.SetAll(this->Option, words); });
    this->Files->setCurrentRow(last);
  }
}

//------------------------------------------------------------------------------
void PointsEdit::Remove()
{
  const int row = this->Files->currentRow();
  std::vector<std::string> words = this->Edited->Get().GetAll(this->Option);
  if (row >= 0 && row < static_cast<int>(words.size()))
  {
    words.erase(words.begin() + row);
    this->Edited->Change([&](scene::Settings& settings) {
      settings.SetAll(this->Option, words);
      settings.AskStage(this->Stage, !words.empty() && settings.IsStageAsked(this->Stage));
    });
  }
}

//------------------------------------------------------------------------------
// Why the value has no effect; empty if it has one.
QString PointsEdit::WhyIdle(const Row& row, const words::NamedWords& values) const
{
  for (const vtkRelievoParameter::Condition& condition : row.Conditions)
  {
    std::string value = words::FindWords(values, condition.Name);
    value = value.empty() ? this->Described->GetDefault(condition.Name) : value;
    if ((value == condition.Value) == condition.Other)
    {
      return WriteCondition(*this->Described, condition);
    }
  }
  return QString();
}

//------------------------------------------------------------------------------
void PointsEdit::Write(const std::string& name, const QString& text)
{
  const int row = this->Files->currentRow();
  std::vector<std::string> words = this->Edited->Get().GetAll(this->Option);
  if (row < 0 || row >= static_cast<int>(words.size()))
  {
    return;
  }
  std::string& word = words[static_cast<std::size_t>(row)];
  Pairs values;
  const std::string file = scene::ParseFileAndValues(this->Option, word, values);
  words::SetWords(values, name, text.toStdString());
  for (const Row& other : this->Rows)
  {
    if (!this->WhyIdle(other, values).isEmpty())
    {
      words::SetWords(values, other.Name, "");
    }
  }
  word = scene::WriteFileAndValues(file, values);
  this->Edited->Change([&](scene::Settings& settings) { settings.SetAll(this->Option, words); });
  this->ShowValues(true); // restores a refused value
}

//------------------------------------------------------------------------------
void PointsEdit::ShowSettings()
{
  const std::vector<std::string> words = this->Edited->Get().GetAll(this->Option);
  {
    const QSignalBlocker quiet(this->Files);
    const int row = this->Files->currentRow();
    this->Files->clear();
    for (const std::string& word : words)
    {
      Pairs values;
      const QString path = Words(scene::ParseFileAndValues(this->Option, word, values));
      auto* item = new QListWidgetItem(QFileInfo(path).fileName(), this->Files);
      item->setToolTip(Words(word));
    }
    this->Files->setCurrentRow(std::min(std::max(row, 0), this->Files->count() - 1));
  }
  this->RemoveFile->setEnabled(!words.empty());
  this->Values->setVisible(!words.empty());
  this->Hint->setVisible(words.empty());
  this->ShowArrays();
  this->ShowValues(false);
}

//------------------------------------------------------------------------------
void PointsEdit::ShowValues(bool again)
{
  const int file = this->Files->currentRow();
  const std::vector<std::string> words = this->Edited->Get().GetAll(this->Option);
  if (file < 0 || file >= static_cast<int>(words.size()))
  {
    return;
  }
  Pairs values;
  scene::ParseFileAndValues(this->Option, words[static_cast<std::size_t>(file)], values);
  for (Row& row : this->Rows)
  {
    const QString text = Words(words::FindWords(values, row.Name));
    if (again || text != row.Shown) // keeps a text while the user types
    {
      row.Shown = text;
      row.Show(text);
    }
    SetIdle(row.Edit, this->WhyIdle(row, values));
  }
}

//------------------------------------------------------------------------------
void PointsEdit::ShowArrays()
{
  const auto& all = this->Edited->GetFacts().PointArrays;
  const auto found = all.find(this->Stage);
  const auto file = static_cast<std::size_t>(std::max(0, this->Files->currentRow()));
  const bool known = found != all.end() && file < found->second.size();
  for (const Row& row : this->Rows)
  {
    if (!row.Arrays)
    {
      continue;
    }
    const QSignalBlocker quiet(row.Arrays);
    const QString text = row.Arrays->currentText();
    while (row.Arrays->count() > row.Own)
    {
      row.Arrays->removeItem(row.Own);
    }
    for (const std::string& name : known ? found->second[file] : std::vector<std::string>())
    {
      row.Arrays->addItem(Words(name));
    }
    row.Arrays->setEditText(text);
  }
}
}
