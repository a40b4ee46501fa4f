// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelGroup.h"

#include "OptionEdits.h"
#include "Readers.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include <algorithm>

namespace viewer
{
//------------------------------------------------------------------------------
ModelGroup::ModelGroup(Document* document, QWidget* parent)
  : FoldGroup("Models with bones", "model", parent)
  , Edited(document)
  , Loop(MakeFlag(document, "--loop", this))
  , Skeleton(MakeFlag(document, "--skeleton", this))
{
  this->setToolTip("Also for glTF scenes, which are static without any of these");
  QFormLayout* rows = this->GetRows();
  this->Animation = AddChoice(document, rows, "--animation", "the first", "");
  this->Skin = AddChoice(document, rows, "--skin", "linear", "How bones move points",
    { { "dual-quaternion", "dual quaternions" }, { "key-matrix", "matrices between keys" },
      { "off", "not at all" } });
  rows->addRow(this->Loop);
  rows->addRow(this->Skeleton);
  QObject::connect(document, &Document::changed, this, &ModelGroup::ShowSettings);
  QObject::connect(document, &Document::factsChanged, this, &ModelGroup::ShowAnimations);
  this->ShowAnimations();
}

//------------------------------------------------------------------------------
void ModelGroup::ShowAnimations()
{
  {
    const QSignalBlocker quiet(this->Animation);
    this->Animation->clear();
    this->Animation->addItem("the first", "");
    for (const std::string& name : this->Edited->GetFacts().Animations)
    {
      const QString words = QString::fromStdString(name);
      this->Animation->addItem(words, words);
    }
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void ModelGroup::ShowSettings()
{
  const scene::Settings& settings = this->Edited->Get();
  ShowChoice(this->Animation, settings, "--animation");
  ShowChoice(this->Skin, settings, "--skin");
  ShowFlag(this->Loop, settings, "--loop");
  ShowFlag(this->Skeleton, settings, "--skeleton");
  this->setVisible(std::any_of(settings.Files.begin(), settings.Files.end(),
    [](const std::string& file) { return reading::IsModel(file); }));
}
}
