// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceValues.h"

#include "FoldGroup.h"
#include "Labels.h"
#include "Options.h"
#include "ParameterEdit.h"
#include "SurfaceOptions.h"
#include "SurfaceSettings.h"
#include "vtkRelievoParameter.h"

#include <algorithm>
#include <string>

namespace viewer
{
namespace
{
// Separates the numbers of a value by /, because commas separate values.
std::string Read(const look::SurfaceChoice& surface, const std::string& name)
{
  std::string words = look::GetSurfaceValue(surface, name);
  std::replace(words.begin(), words.end(), ',', '/');
  return words;
}
}

//------------------------------------------------------------------------------
SurfaceValues::SurfaceValues(Document* document, FoldGroup* group)
  : QObject(group)
  , Edited(document)
  , Group(group)
{
}

//------------------------------------------------------------------------------
void SurfaceValues::Add(const vtkRelievoParameter& value)
{
  auto* edit = new ParameterEdit(value, this->Group);
  edit->setObjectName(QString::fromStdString(value.Name));
  AddParameterRow(
    value.Advanced ? this->Group->GetAdvanced() : this->Group->GetRows(), value, edit);
  this->All.push_back({ &value, edit });
  QObject::connect(
    edit, &ParameterEdit::edited, this, [this, name = value.Name](const QString& words) {
      const std::string given = QString(words).replace(',', '/').toStdString();
      this->Edited->Change([&](scene::Settings& settings) {
        scene::SetSurfaceValue(settings, name, "");
        if (given != Read(settings.Parse().Surface, name))
        {
          scene::SetSurfaceValue(settings, name, given);
        }
      });
    });
}

//------------------------------------------------------------------------------
void SurfaceValues::ShowSettings()
{
  const look::SurfaceChoice surface = this->Edited->Get().Parse().Surface;
  for (const Row& row : this->All)
  {
    const auto failing = look::FindFailing(surface, *row.Value);
    SetIdle(row.Edit, failing ? WriteCondition(look::GetMaterialValues(), *failing) : QString());
    row.Edit->SetValue(QString::fromStdString(Read(surface, row.Value->Name)));
  }
}
}
