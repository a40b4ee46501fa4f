// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MaterialGroup.h"

#include "FileEdit.h"
#include "Labels.h"
#include "Number.h"
#include "OptionEdits.h"
#include "Options.h"
#include "SurfaceOptions.h"
#include "SurfaceValues.h"
#include "vtkRelievoParameter.h"

#include <QComboBox>
#include <QFormLayout>

namespace viewer
{
namespace
{
}

//------------------------------------------------------------------------------
MaterialGroup::MaterialGroup(Document* document, QWidget* parent)
  : FoldGroup("Material", "material", parent)
  , Edited(document)
  , Normals(new FileEdit("Normal map", this))
  , Heights(new FileEdit("Height map", this))
  , Depth(new relievoQt::Number(0.0, 1e9, 0.01, 6, this))
{
  QFormLayout* rows = this->GetRows();
  this->Normals->setObjectName("normalmap");
  this->Normals->setToolTip("Normals from an image, placed by the meshes' texture coordinates; "
                            "linear values, not sRGB");
  this->Heights->setObjectName("heightmap");
  this->Heights->setToolTip("Heights from an image: the brightest lie on the mesh");
  this->Depth->setObjectName("depth");
  this->Depth->SetSpecial("automatic");
  this->Depth->SetUnit("world units");
  this->Depth->setToolTip(
    "Depth of the lowest heights below the mesh; default 0.02 of the scene's longest side");
  rows->addRow("Normal map", this->Normals);
  rows->addRow("Height map", this->Heights);
  rows->addRow("Relief depth", this->Depth);
  this->Relief = AddChoice(document, this->GetAdvanced(), "--relief", "relief",
    "How heights are drawn", { { "off", "as normals only" } });
  this->Coordinates = AddChoice(document, this->GetAdvanced(), "--texture-coordinates", "automatic",
    "For meshes without texture coordinates: how maps are placed");
  this->Values = new SurfaceValues(document, this);
  for (const vtkRelievoParameter& value : look::GetMaterialValues().Parameters)
  {
    if (value.OnlyIf != "environment") // those are in the environment's group
    {
      this->Values->Add(value);
    }
  }
  QObject::connect(this->Normals, &FileEdit::edited, this,
    [this](const QString& path) { this->SetNormalMap(path.toStdString()); });
  QObject::connect(this->Heights, &FileEdit::edited, this, [this](const QString& path) {
    this->SetHeightMap(path.toStdString(), this->Depth->GetValue());
  });
  QObject::connect(this->Depth, &relievoQt::Number::edited, this, [this](double depth) {
    this->SetHeightMap(this->Edited->Get().Parse().Surface.HeightMap, depth);
  });
  QObject::connect(document, &Document::changed, this, &MaterialGroup::ShowSettings);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void MaterialGroup::SetNormalMap(const std::string& file)
{
  this->Edited->Change(
    [&file](scene::Settings& settings) { SetOption(settings, "--normal-map", file); });
}

//------------------------------------------------------------------------------
void MaterialGroup::SetHeightMap(const std::string& file, double depth)
{
  this->Edited->Change([&](scene::Settings& settings) {
    SetOption(
      settings, "--height-map", file.empty() ? file : words::WriteFileAndNumber(file, depth));
  });
}

//------------------------------------------------------------------------------
void MaterialGroup::ShowSettings()
{
  const scene::Settings& settings = this->Edited->Get();
  const scene::RenderOptions options = settings.Parse();
  const bool heights = !options.Surface.HeightMap.empty();
  this->Normals->SetPath(QString::fromStdString(options.Surface.NormalMap));
  this->Heights->SetPath(QString::fromStdString(options.Surface.HeightMap));
  this->Depth->SetValue(options.Surface.HeightScale.value_or(0.0));
  ShowChoice(this->Relief, settings, "--relief");
  ShowChoice(this->Coordinates, settings, "--texture-coordinates");
  this->Values->ShowSettings();
  const QString whyFlat = heights ? "" : "Has an effect with a height map.";
  SetIdle(this->Depth, whyFlat);
  SetIdle(this->Relief, whyFlat);
  SetIdle(this->Coordinates,
    heights || !options.Surface.NormalMap.empty()
      ? ""
      : "Has an effect with a normal map or a height map.");
}
}
