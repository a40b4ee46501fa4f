// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PresetsLights.h"

#include "Options.h"

namespace viewer
{
//------------------------------------------------------------------------------
PresetsLights::PresetsLights(Document* document, const QString& own, QWidget* parent)
  : QLabel(parent)
  , Edited(document)
  , Own(own)
{
  this->setObjectName("presetsLights");
  this->setWordWrap(true);
  QObject::connect(document, &Document::changed, this, &PresetsLights::ShowSettings);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void PresetsLights::ShowSettings()
{
  const scene::RenderOptions options = this->Edited->Get().Parse();
  const std::size_t given = this->Edited->Get().GetAll("--light").size();
  const QString preset = QString::fromStdString(options.Preset);
  this->setVisible(options.Lights.size() > given);
  this->setText(given > 0
      ? QString("The fill of the preset %1 is on as well, weaker than without lights of your own.")
          .arg(preset)
      : QString("The lights of the preset %1 are on%2. In the place of its first light comes %3; "
                "its fill stays, weaker.")
          .arg(preset, options.YieldsToFile ? ", unless the file has its own" : "", this->Own));
}
}
