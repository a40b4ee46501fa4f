// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoLayerControls.h"

#include "Rows.h"
#include "pqView.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPVRelievoView.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRenderWindow.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace
{
bool IsNothing(const QString& layer, vtkDataArray* array, vtkIdType pixel)
{
  bool isZero = array->GetNumberOfComponents() > 1;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    const double value = array->GetComponent(pixel, c);
    if (!std::isfinite(value))
    {
      return true;
    }
    isZero = isZero && value == 0.0;
  }
  const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::Find(layer.toStdString());
  return known.Kind == vtkRelievoLayer::ID ? array->GetComponent(pixel, 0) == known.Background
                                           : isZero;
}
}

//------------------------------------------------------------------------------
pqRelievoLayerControls::pqRelievoLayerControls(QWidget* parent)
  : Superclass(parent)
  , Layer(new QComboBox(this))
  , Values(new QLabel(this))
{
  QFormLayout* rows = relievoQt::MakeRows(this);
  auto* head = new QLabel("Layers", this);
  MakeHead(head);
  rows->addRow(head);
  this->Layer->setObjectName("layer");
  this->Layer->setToolTip("A layer to show as the picture");
  this->Layer->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Layer->setMinimumContentsLength(9);
  this->Values->setObjectName("values");
  this->Values->setWordWrap(true);
  this->Values->setTextInteractionFlags(Qt::TextSelectableByMouse);
  relievoQt::AddRow(rows, "Shown", this->Layer);
  rows->addRow(this->Values);
  QObject::connect(
    this->Layer, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int i) {
      pqRelievoViewSettings::SetShownLayer(this->View, this->Layer->itemData(i).toString());
    });
}

//------------------------------------------------------------------------------
pqRelievoLayerControls::~pqRelievoLayerControls() = default;

//------------------------------------------------------------------------------
void pqRelievoLayerControls::SetView(pqView* view)
{
  if (this->View)
  {
    QObject::disconnect(this->View, nullptr, this, nullptr);
  }
  if (this->Screen)
  {
    this->Screen->removeEventFilter(this);
  }
  this->Fresh = false;
  this->Superclass::SetView(view);
  this->Screen = this->View ? this->View->widget() : nullptr;
  if (this->View)
  {
    this->Connector->Connect(pqRelievoViewSettings::Find(view)->GetProperty("DisplayLayer"),
      vtkCommand::DomainModifiedEvent, this, SLOT(ShowState()));
    QObject::connect(this->View, &pqView::endRender, this, [this] { this->Fresh = false; });
  }
  if (this->Screen)
  {
    this->Screen->setMouseTracking(true);
    this->Screen->installEventFilter(this);
  }
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::ShowState()
{
  this->Superclass::ShowState();
  const QSignalBlocker quiet(this->Layer);
  const QString layer = pqRelievoViewSettings::GetShownLayer(this->View);
  const QVector<QString> names = pqRelievoViewSettings::GetLayerNames(this->View);
  this->Layer->clear();
  this->Layer->addItem("None", QString());
  for (int i = 1; i < names.size(); ++i)
  {
    this->Layer->addItem(names[i], names[i]);
  }
  if (!layer.isEmpty() && !names.contains(layer))
  {
    this->Layer->addItem(layer, layer); // by script: an array
  }
  this->Layer->setCurrentIndex(std::max(0, this->Layer->findData(layer)));
  this->Fresh = false;
  this->Values->setText(layer.isEmpty() ? "" : "Move the mouse over the picture to read values.");
  this->Values->setVisible(!layer.isEmpty());
}

//------------------------------------------------------------------------------
bool pqRelievoLayerControls::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->Screen && event->type() == QEvent::MouseMove && this->isVisible())
  {
    this->Probe(static_cast<QMouseEvent*>(event)->pos());
  }
  return this->Superclass::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
bool pqRelievoLayerControls::ReadLayer(const QString& layer)
{
  if (!this->Fresh)
  {
    vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View);
    auto* view = vtkPVRenderView::SafeDownCast(this->View->getProxy()->GetClientSideObject());
    this->Image->Initialize();
    this->Fresh = true;
    if (here && view && here->IsInPlace())
    {
      view->GetRenderWindow()->MakeCurrent();
      here->ReadShownLayer(qUtf8Printable(layer), this->Image);
    }
  }
  return this->Image->GetNumberOfPoints() > 0;
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::Probe(const QPoint& place)
{
  const QString layer = pqRelievoViewSettings::GetShownLayer(this->View);
  if (layer.isEmpty())
  {
    return;
  }
  if (!this->ReadLayer(layer))
  {
    this->Values->setText("The server draws this picture: Sources > Relievo > Relievo Layers has "
                          "its values.");
    return;
  }
  vtkDataArray* array = this->Image->GetPointData()->GetArray(qUtf8Printable(layer));
  const int* size = this->Image->GetDimensions();
  const int x = static_cast<int>((place.x() + 0.5) * size[0] / this->Screen->width());
  const int y = static_cast<int>((place.y() + 0.5) * size[1] / this->Screen->height());
  if (!array || x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return;
  }
  const vtkIdType pixel = x + static_cast<vtkIdType>(size[1] - 1 - y) * size[0];
  double largest = 0.0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    largest = std::max(largest, std::abs(array->GetComponent(pixel, c)));
  }
  QStringList values;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    const double value = array->GetComponent(pixel, c);
    values.append(QString::number(std::abs(value) < 1e-7 * largest ? 0.0 : value, 'g', 7));
  }
  this->Probed = IsNothing(layer, array, pixel) ? "nothing" : values.join(", ");
  this->Values->setText(QString("%1 at %2, %3: %4").arg(layer).arg(x).arg(y).arg(this->Probed));
}
