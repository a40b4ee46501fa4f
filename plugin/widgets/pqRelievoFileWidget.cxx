// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoFileWidget.h"

#include "pqApplicationCore.h"
#include "pqFileChooserWidget.h"
#include "pqServerManagerModel.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"

#include <QHBoxLayout>
#include <QLineEdit>

//------------------------------------------------------------------------------
QString pqRelievoFileWidget::GetFilter(vtkSMProperty* property)
{
  vtkPVXMLElement* hints = property ? property->GetHints() : nullptr;
  vtkPVXMLElement* files = hints ? hints->FindNestedElementByName("FileChooser") : nullptr;
  return files ? QString("%1 (*.%2)")
                   .arg(files->GetAttributeOrEmpty("file_description"))
                   .arg(QString(files->GetAttributeOrEmpty("extensions")).split(' ').join(" *."))
               : QString();
}

//------------------------------------------------------------------------------
pqRelievoFileWidget::pqRelievoFileWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parentWidget)
  : Superclass(proxy, parentWidget)
  , Chooser(new pqFileChooserWidget(this))
{
  this->Chooser->setObjectName("FileChooser");
  this->Chooser->setForceSingleFile(true);
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->Chooser->setServer(model->findServer(proxy->GetSession()));
  this->Chooser->setExtension(GetFilter(property));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Chooser);

  if (auto* line = this->Chooser->findChild<QLineEdit*>())
  {
    QObject::connect(
      line, &QLineEdit::textEdited, this, [this](const QString&) { this->Typing = true; });
    QObject::connect(line, &QLineEdit::editingFinished, this, [this]() { this->Finish(); });
  }
  QObject::connect(
    this->Chooser, &pqFileChooserWidget::filenameChanged, this, [this](const QString&) {
      if (!this->Typing)
      {
        this->Finish();
      }
    });
  this->addPropertyLink(this, "file", SIGNAL(fileChanged()), property);
  this->setChangeAvailableAsChangeFinished(true);
}

//------------------------------------------------------------------------------
pqRelievoFileWidget::~pqRelievoFileWidget() = default;

//------------------------------------------------------------------------------
void pqRelievoFileWidget::Finish()
{
  this->Typing = false;
  this->SetFile(this->Chooser->singleFilename());
}

//------------------------------------------------------------------------------
void pqRelievoFileWidget::SetFile(const QString& file)
{
  if (file == this->File)
  {
    return;
  }
  this->File = file;
  if (this->Chooser->singleFilename() != file)
  {
    this->Chooser->setSingleFilename(file);
  }
  Q_EMIT this->fileChanged();
}
