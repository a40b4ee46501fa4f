// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionEdits.h"

#include "Number.h"
#include "OptionNames.h"
#include "Options.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>

namespace viewer
{
namespace
{
// Shows the option, now and after each change, while its control exists.
template <typename Show>
void Follow(Document* document, QWidget* control, const Show& show)
{
  show();
  QObject::connect(document, &Document::changed, control, show);
}

void AddText(Document* document, QFormLayout* rows, const vtkRelievoOption& option)
{
  const char* const name = option.Name.c_str();
  auto* line = new QLineEdit(rows->parentWidget());
  line->setObjectName(QString(name).remove('-'));
  line->setPlaceholderText(QString::fromStdString(option.Form));
  rows->addRow(QString::fromStdString(option.Label), line);
  const auto show = [document, line, name] {
    line->setText(QString::fromStdString(document->Get().Get(name)));
  };
  Follow(document, line, show);
  QObject::connect(line, &QLineEdit::editingFinished, document, [document, line, name, show] {
    const std::string text = line->text().toStdString();
    if (text != document->Get().Get(name))
    {
      document->Change([&](scene::Settings& settings) { SetOption(settings, name, text); });
      show(); // a refused text is replaced
    }
  });
}
}

//------------------------------------------------------------------------------
void SetOption(scene::Settings& settings, const char* option, const std::string& value)
{
  value.empty() ? settings.Remove(option) : settings.Set(option, value);
}

//------------------------------------------------------------------------------
QComboBox* AddChoice(Document* document, QFormLayout* rows, const char* option,
  const QString& first, const QString& help, const std::map<std::string, QString>& labels)
{
  auto* box = new QComboBox(rows->parentWidget());
  box->setObjectName(QString(option).remove('-'));
  box->setToolTip(help);
  box->addItem(first, "");
  for (const std::string& word : scene::GetRenderCommand().Find(option)->Words)
  {
    const QString data = QString::fromStdString(word);
    const auto label = labels.find(word);
    if (data != first)
    {
      box->addItem(label == labels.end() ? data : label->second, data);
    }
  }
  rows->addRow(FindOptionName(option).Label, box);
  QObject::connect(box, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged),
    document, [document, box, option] {
      document->Change([&](scene::Settings& settings) {
        SetOption(settings, option, box->currentData().toString().toStdString());
      });
    });
  return box;
}

//------------------------------------------------------------------------------
void ShowChoice(QComboBox* box, const scene::Settings& settings, const char* option)
{
  const QSignalBlocker quiet(box);
  const QString words = QString::fromStdString(settings.Get(option));
  if (box->findData(words) < 0)
  {
    box->addItem(words, words);
  }
  box->setCurrentIndex(box->findData(words));
}

//------------------------------------------------------------------------------
QCheckBox* MakeFlag(Document* document, const char* option, QWidget* parent)
{
  auto* box = new QCheckBox(FindOptionName(option).Label, parent);
  box->setObjectName(QString(option).remove('-'));
  QObject::connect(box, &QCheckBox::toggled, document, [document, option](bool on) {
    document->Change(
      [&](scene::Settings& settings) { on ? settings.Set(option, "") : settings.Remove(option); });
  });
  return box;
}

//------------------------------------------------------------------------------
void AddOption(Document* document, QFormLayout* rows, const vtkRelievoOption& option)
{
  const char* const name = option.Name.c_str();
  if (option.IsFlag())
  {
    QCheckBox* box = MakeFlag(document, name, rows->parentWidget());
    rows->addRow(box);
    const auto show = [=] { ShowFlag(box, document->Get(), name); };
    Follow(document, box, show);
    QObject::connect(box, &QCheckBox::toggled, box, show); // the edit may have had no effect
  }
  else if (!option.Words.empty())
  {
    QComboBox* box = AddChoice(document, rows, name, "default", "");
    const auto show = [=] { ShowChoice(box, document->Get(), name); };
    Follow(document, box, show);
    QObject::connect(
      box, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), box, show);
  }
  else
  {
    AddText(document, rows, option);
  }
  rows->parentWidget()
    ->findChild<QWidget*>(QString(name).remove('-'))
    ->setToolTip(QString::fromStdString(option.Help));
}

//------------------------------------------------------------------------------
relievoQt::Number* MakeNumber(const char* option, double step, int decimals, QWidget* parent)
{
  const vtkRelievoOption::Bounds& range = scene::GetRenderCommand().Find(option)->Range;
  const double inset = range.Open ? step : 0.0;
  return new relievoQt::Number(range.Least + inset, range.Most - inset, step, decimals, parent);
}

//------------------------------------------------------------------------------
void ShowFlag(QCheckBox* box, const scene::Settings& settings, const char* option)
{
  const QSignalBlocker quiet(box);
  box->setChecked(settings.Has(option));
}
}
