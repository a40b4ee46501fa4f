// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceValues.h"

#include "Labels.h"
#include "Options.h"
#include "ParameterEdit.h"
#include "SurfaceOptions.h"

#include <QFormLayout>
#include <QLabel>

#include <algorithm>
#include <string>

namespace viewer
{
namespace
{
// Numbers of one value with / between them: commas are between values.
std::string Read(const scene::RenderOptions& options, const std::string& name)
{
  std::string words = scene::GetSurfaceValue(options, name);
  std::replace(words.begin(), words.end(), ',', '/');
  return words;
}
}

//------------------------------------------------------------------------------
SurfaceValues::SurfaceValues(Document* document, QFormLayout* rows, QWidget* parent)
  : QObject(parent)
  , Edited(document)
  , Rows(rows)
{
}

//------------------------------------------------------------------------------
void SurfaceValues::Add(const vtkRelievoParameter& value)
{
  auto* edit = new ParameterEdit(value, static_cast<QWidget*>(this->parent()));
  edit->setObjectName(QString::fromStdString(value.Name));
  this->All.push_back({ &value, edit, AddParameterRow(this->Rows, value, edit) });
  QObject::connect(
    edit, &ParameterEdit::edited, this, [this, name = value.Name](const QString& words) {
      const std::string given = QString(words).replace(',', '/').toStdString();
      this->Edited->Change([&](scene::Settings& settings) {
        scene::SetSurfaceValue(settings, name, "");
        if (given != Read(settings.Parse(), name))
        {
          scene::SetSurfaceValue(settings, name, given);
        }
      });
    });
}

//------------------------------------------------------------------------------
void SurfaceValues::ShowSettings()
{
  const scene::RenderOptions options = this->Edited->Get().Parse();
  for (const Row& row : this->All)
  {
    const bool has = scene::HasEffect(options, *row.Value);
    row.Label->setVisible(has);
    row.Edit->setVisible(has);
    row.Edit->SetValue(QString::fromStdString(Read(options, row.Value->Name)));
  }
}
}
