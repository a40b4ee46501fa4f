// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoArrayWidget.h"

#include "pqCoreUtilities.h"
#include "vtkCommand.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>

//------------------------------------------------------------------------------
pqRelievoArrayWidget::pqRelievoArrayWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parentWidget)
  : Superclass(proxy, parentWidget)
  , Arrays(new QComboBox(this))
{
  vtkPVXMLElement* hints = property->GetHints();
  if (vtkPVXMLElement* needed = hints ? hints->FindNestedElementByName("Array") : nullptr)
  {
    needed->GetScalarAttribute("components", &this->Components);
  }
  this->Arrays->setObjectName("Arrays");
  this->Arrays->setEditable(true);
  this->Arrays->setInsertPolicy(QComboBox::NoInsert);
  this->Arrays->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Arrays->lineEdit()->setPlaceholderText("none");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Arrays);
  this->ListArrays();

  vtkSMPropertyHelper input(proxy, "Input", /*quiet=*/true);
  if (input.GetNumberOfElements() > 0 && input.GetAsProxy())
  {
    pqCoreUtilities::connect(
      input.GetAsProxy(), vtkCommand::UpdateDataEvent, this, SLOT(ListArrays()));
  }
  QObject::connect(this->Arrays, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    [this](int i) { this->SetArray(this->Arrays->itemText(i)); });
  QObject::connect(this->Arrays->lineEdit(), &QLineEdit::editingFinished, this,
    [this]() { this->SetArray(this->Arrays->currentText()); });
  this->addPropertyLink(this, "array", SIGNAL(arrayChanged()), property);
  this->setChangeAvailableAsChangeFinished(true);
}

//------------------------------------------------------------------------------
pqRelievoArrayWidget::~pqRelievoArrayWidget() = default;

//------------------------------------------------------------------------------
void pqRelievoArrayWidget::ListArrays()
{
  const QSignalBlocker quiet(this->Arrays);
  const QString written = this->Arrays->currentText();
  this->Arrays->clear();
  this->Arrays->addItem(QString());
  vtkSMPropertyHelper input(this->proxy(), "Input", /*quiet=*/true);
  auto* source =
    input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  vtkPVDataInformation* about =
    source ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
  vtkPVDataSetAttributesInformation* points = about ? about->GetPointDataInformation() : nullptr;
  for (int i = 0; points && i < points->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* array = points->GetArrayInformation(i);
    const int components = array->GetNumberOfComponents();
    // Red, green and blue may come with an opacity, which is not used.
    if (components == this->Components || (this->Components == 3 && components == 4))
    {
      this->Arrays->addItem(QString::fromUtf8(array->GetName()));
    }
  }
  this->Arrays->setCurrentIndex(this->Arrays->findText(written));
  this->Arrays->setEditText(written);
}

//------------------------------------------------------------------------------
void pqRelievoArrayWidget::SetArray(const QString& array)
{
  if (array == this->Array)
  {
    return;
  }
  this->Array = array;
  const QSignalBlocker quiet(this->Arrays);
  this->Arrays->setCurrentIndex(this->Arrays->findText(array));
  this->Arrays->setEditText(array);
  Q_EMIT this->arrayChanged();
}
