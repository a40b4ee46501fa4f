// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoLayerControls.h"

#include "LayerWords.h"
#include "RangeEdit.h"
#include "Rows.h"
#include "pqDataRepresentation.h"
#include "pqRelievoLegend.h"
#include "pqRelievoScene.h"
#include "pqServer.h"
#include "pqView.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVRelievoView.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkRelievoColormaps.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"
#include "vtkSMProperty.h"
#include "vtkSMRelievoCaptureProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStringList>
#include <QTableWidget>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
constexpr int LegendMilliseconds = 200;

const char* const Always[] = { "depth", "range", "position", "normal", "actor", "block", "cell" };

bool HasNothing(vtkImageData* image, const QString& layer, vtkIdType pixel)
{
  vtkDataArray* array = image->GetPointData()->GetArray(qUtf8Printable(layer));
  const bool ofVolume = relievoQt::IsOfVolume(layer.toStdString());
  vtkDataArray* depth = image->GetPointData()->GetArray(ofVolume ? "volume_depth" : "depth");
  if (array && layer == "volume_opacity")
  {
    return false;
  }
  if (!array || (depth && !std::isfinite(depth->GetComponent(pixel, 0))))
  {
    return true;
  }
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
  const bool telling = known.Kind == vtkRelievoLayer::ID ||
    (known.Source == vtkRelievoLayer::FROM_STAGE && known.Components == 1);
  return telling ? array->GetComponent(pixel, 0) == known.Background : isZero;
}

QString WriteNumber(double value)
{
  // Ids with all digits.
  const bool whole = std::abs(value) < 1e15 && value == std::floor(value);
  return whole ? QString::number(value, 'f', 0) : QString::number(value, 'g', 7);
}

// Omits digits below the precision of the largest component: normals have fewer bits.
QString WriteValues(vtkDataArray* array, bool normal, vtkIdType pixel)
{
  const double share = normal ? 1e-4 : 1e-7;
  double largest = 0.0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    largest = std::max(largest, std::abs(array->GetComponent(pixel, c)));
  }
  QStringList values;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    const double value = array->GetComponent(pixel, c);
    values.append(WriteNumber(std::abs(value) < share * largest ? 0.0 : value));
  }
  return values.join(", ");
}

void AddArrays(vtkPVDataSetAttributesInformation* about, QStringList& names)
{
  for (int i = 0; about && i < about->GetNumberOfArrays(); ++i)
  {
    const QString name = QString::fromUtf8(about->GetArrayInformation(i)->GetName());
    if (!names.contains(name))
    {
      names.append(name);
    }
  }
}
}

//------------------------------------------------------------------------------
pqRelievoLayerControls::pqRelievoLayerControls(QWidget* parent)
  : Superclass(parent)
  , Layer(new QComboBox(this))
  , Colormap(new QComboBox(this))
  , Reversed(new QCheckBox("Reversed", this))
  , Range(new relievoQt::RangeEdit(this))
  , Legend(new pqRelievoLegend(this))
  , All(new QCheckBox("Values under the mouse", this))
  , Values(new QTableWidget(0, 2, this))
  , Message(new QLabel(this))
{
  QFormLayout* rows = relievoQt::MakeRows(this);
  auto* head = new QLabel("Layers", this);
  MakeHead(head);
  rows->addRow(head);
  this->Layer->setObjectName("layer");
  this->Layer->setToolTip("A layer to show as the picture");
  this->Layer->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Layer->setMinimumContentsLength(9);
  this->Legend->setObjectName("legend");
  this->All->setObjectName("all");
  this->All->setToolTip("Reads all layers and arrays when the mouse moves over the view, with one "
                        "more picture after each change");
  this->Values->setObjectName("values");
  this->Values->horizontalHeader()->hide();
  this->Values->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  this->Values->horizontalHeader()->setStretchLastSection(true);
  this->Values->verticalHeader()->hide();
  this->Values->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Values->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  this->Values->setTabKeyNavigation(false);
  this->Values->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->Message->setObjectName("message");
  this->Message->setWordWrap(true);
  relievoQt::AddRow(rows, "Shown", this->Layer);
  rows->addRow(this->Legend);
  this->AddColors(rows);
  rows->addRow(this->All);
  rows->addRow(this->Message);
  rows->addRow(this->Values);
  this->LegendTimer.setSingleShot(true);
  this->LegendTimer.setInterval(LegendMilliseconds);
  QObject::connect(&this->LegendTimer, &QTimer::timeout, this, [this] { this->ShowLegend(); });
  QObject::connect(
    this->Layer, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int i) {
      pqRelievoViewSettings::SetShownLayer(this->View, this->Layer->itemData(i).toString());
    });
  QObject::connect(this->All, &QCheckBox::toggled, this, [this] { this->ShowState(); });
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::AddColors(QFormLayout* rows)
{
  this->Colors = new QWidget(this);
  this->Colors->setObjectName("colors");
  QFormLayout* colors = relievoQt::MakeRows(this->Colors);
  this->Colormap->setObjectName("colormap");
  const std::vector<std::string>& names = vtkRelievoColormaps::GetNames();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    this->Colormap->addItem(QString::fromStdString(names[i]), static_cast<int>(i));
  }
  this->Reversed->setObjectName("reversed");
  this->Reversed->setToolTip("Reverses the colours: the largest value has the first one");
  this->Range->setObjectName("range");
  this->Range->SetAutomaticToolTip("From the smallest to the largest visible value");
  relievoQt::AddRow(colors, "Colour map", this->Colormap);
  relievoQt::AddRow(colors, "", this->Reversed);
  relievoQt::AddRow(colors, "Range", this->Range);
  rows->addRow(this->Colors);
  this->Bind(this->Colormap, "RelievoDisplayColormap", "Layer's colour map");
  QObject::connect(this->Reversed, &QCheckBox::toggled, this, [this](bool on) {
    this->Apply("Layer's colour map", { { "RelievoDisplayReversed", on ? 1 : 0 } });
  });
  QObject::connect(this->Range, &relievoQt::RangeEdit::automaticSwitched, this,
    &pqRelievoLayerControls::SwitchRange);
  QObject::connect(this->Range, &relievoQt::RangeEdit::typed, this,
    [this](const QString& least, const QString& most) {
      bool good[2];
      const double ends[2] = { least.toDouble(&good[0]), most.toDouble(&good[1]) };
      if (good[0] && good[1] && ends[0] < ends[1])
      {
        this->SetRange(ends[0], ends[1]);
      }
      this->ShowState();
    });
}

//------------------------------------------------------------------------------
pqRelievoLayerControls::~pqRelievoLayerControls() = default;

//------------------------------------------------------------------------------
void pqRelievoLayerControls::SetView(pqView* view)
{
  if (this->Screen)
  {
    this->Screen->removeEventFilter(this);
  }
  this->Asked.clear();
  this->Superclass::SetView(view);
  this->Screen = this->View ? this->View->widget() : nullptr;
  if (this->View)
  {
    this->Connector->Connect(pqRelievoViewSettings::Find(view)->GetProperty("DisplayLayer"),
      vtkCommand::DomainModifiedEvent, this, SLOT(ShowState()));
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
    this->Layer->addItem(relievoQt::NameLayer(names[i].toStdString()), names[i]);
  }
  if (!layer.isEmpty() && !names.contains(layer))
  {
    this->Layer->addItem(relievoQt::NameLayer(layer.toStdString()), layer); // set by a script
  }
  this->Layer->setCurrentIndex(std::max(0, this->Layer->findData(layer)));
  const bool probing = this->View && (this->All->isChecked() || !layer.isEmpty());
  const QString asked = QString("%1 %2").arg(this->All->isChecked()).arg(layer);
  if (asked != this->Asked || !probing)
  {
    this->Asked = asked;
    this->DropValues();
  }
  this->Message->setVisible(probing);
  this->Legend->setVisible(!layer.isEmpty());
  this->ShowColors(layer);
  this->ShowScene();
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::DropValues()
{
  this->Values->setRowCount(0);
  this->Values->hide();
  this->Message->setText("Move the mouse over the picture.");
}

//------------------------------------------------------------------------------
// The picture's contents and view: when they change, so do the values under the mouse.
QString pqRelievoLayerControls::GetSeen() const
{
  auto* view = this->View ? vtkSMRenderViewProxy::SafeDownCast(this->View->getProxy()) : nullptr;
  vtkCamera* camera = view ? view->GetActiveCamera() : nullptr;
  if (!camera)
  {
    return QString();
  }
  QStringList words;
  for (const double* place :
    { camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp() })
  {
    for (int i = 0; i < 3; ++i)
    {
      words.append(QString::number(place[i], 'g', 17));
    }
  }
  words.append(QString::number(camera->GetViewAngle(), 'g', 17));
  words.append(QString::number(camera->GetParallelScale(), 'g', 17));
  for (pqDataRepresentation* each : pqRelievoScene::FindSurfaces(this->View))
  {
    words.append(each->getProxy()->GetGlobalIDAsString());
  }
  return words.join(' ');
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::ShowColors(const QString& layer)
{
  const std::string name = layer.toStdString();
  const int kind = vtkRelievoLayerCatalogue::GetIsOfLight(name)
    ? vtkRelievoLayer::SHARE
    : vtkRelievoLayerCatalogue::Find(name).Kind;
  this->Colors->setVisible(
    !layer.isEmpty() && (kind == vtkRelievoLayer::NUMBER || kind == vtkRelievoLayer::ARRAY));
  const QSignalBlocker quiet(this->Reversed);
  this->Reversed->setChecked(this->IsOn("RelievoDisplayReversed"));
  const bool grey = this->IsOn("RelievoDisplayGrey");
  this->Colormap->setEnabled(!grey);
  this->Reversed->setEnabled(!grey);
  const QVariantList range = this->Get("RelievoDisplayRange").toList();
  const bool given = range.size() == 2 && range[0].toDouble() < range[1].toDouble();
  this->Range->Show(given ? QString::number(range[0].toDouble()) : QString(),
    given ? QString::number(range[1].toDouble()) : QString());
  this->Range->SetUnit(relievoQt::GetUnit(name));
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::ShowScene()
{
  if (!this->Reading)
  {
    this->Fresh = false;
    const QString seen = this->GetSeen();
    if (seen != this->Seen)
    {
      this->Seen = seen;
      this->DropValues();
    }
    if (!pqRelievoViewSettings::GetShownLayer(this->View).isEmpty())
    {
      this->LegendTimer.start();
    }
  }
}

//------------------------------------------------------------------------------
bool pqRelievoLayerControls::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->Screen && event->type() == QEvent::MouseMove && this->isVisible())
  {
    auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->buttons() == Qt::NoButton && !this->Reading)
    {
      this->Probe(mouse->pos());
    }
  }
  return this->Superclass::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
QStringList pqRelievoLayerControls::FindLayers() const
{
  QStringList names;
  const QString shown = pqRelievoViewSettings::GetShownLayer(this->View);
  if (!shown.isEmpty())
  {
    names.append(shown);
  }
  for (const char* each : Always)
  {
    names.append(each);
  }
  if (vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View))
  {
    const QString lights = here->GetShadowLayers();
    if (!lights.isEmpty() && this->IsOn("RelievoShadows"))
    {
      names.append(lights.split(','));
    }
  }
  for (pqDataRepresentation* each : pqRelievoScene::FindSurfaces(this->View))
  {
    if (vtkPVDataInformation* about = each->getInputDataInformation())
    {
      AddArrays(about->GetPointDataInformation(), names);
      AddArrays(about->GetCellDataInformation(), names);
    }
  }
  names.removeDuplicates();
  return names;
}

//------------------------------------------------------------------------------
bool pqRelievoLayerControls::ReadShown()
{
  vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View);
  auto* view = vtkPVRenderView::SafeDownCast(this->View->getProxy()->GetClientSideObject());
  this->Image->Initialize();
  if (here && view && here->IsInPlace())
  {
    view->GetRenderWindow()->MakeCurrent();
    here->ReadShownLayer(
      qUtf8Printable(pqRelievoViewSettings::GetShownLayer(this->View)), this->Image);
  }
  return this->Image->GetNumberOfPoints() > 0;
}

//------------------------------------------------------------------------------
bool pqRelievoLayerControls::ReadAll()
{
  this->Image->Initialize();
  const auto capture = vtk::TakeSmartPointer(vtkSMRelievoCaptureProxy::SafeDownCast(
    this->View->getServer()->proxyManager()->NewProxy("relievo", "Capture")));
  if (!capture)
  {
    return false;
  }
  this->Reading = true;
  const QStringList all = this->FindLayers();
  std::vector<std::string> names(all.size());
  std::transform(
    all.begin(), all.end(), names.begin(), [](const QString& each) { return each.toStdString(); });
  // A single missing array makes all reading fail: retries without arrays.
  for (const auto& each : { names, std::vector<std::string>(std::begin(Always), std::end(Always)) })
  {
    if (this->Image->GetNumberOfPoints() == 0 &&
      capture->Capture(
        this->View->getViewProxy(), each, vtkSMRelievoCaptureProxy::TO_CLIENT, true) &&
      capture->GetImage())
    {
      this->Image->ShallowCopy(capture->GetImage());
    }
  }
  this->Reading = false;
  return this->Image->GetNumberOfPoints() > 0;
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::Probe(const QPoint& place)
{
  const bool all = this->All->isChecked();
  if (!all && pqRelievoViewSettings::GetShownLayer(this->View).isEmpty())
  {
    return;
  }
  if (!this->Fresh)
  {
    all ? this->ReadAll() : this->ReadShown();
    this->Fresh = true;
  }
  const bool any = this->Image->GetNumberOfPoints() > 0;
  const int* size = this->Image->GetDimensions();
  const int x = static_cast<int>((place.x() + 0.5) * size[0] / this->Screen->width());
  const int y = static_cast<int>((place.y() + 0.5) * size[1] / this->Screen->height());
  const bool inside = any && x >= 0 && y >= 0 && x < size[0] && y < size[1];
  this->Message->setText(any ? QString("At pixel %1, %2").arg(x).arg(y)
      : all || pqRelievoViewSettings::IsDrawnHere(this->View)
      ? QString("Nothing is drawn that has values.")
      : QString("The server draws this picture: switch on Values under the mouse to fetch them."));
  this->Values->setVisible(inside);
  if (inside)
  {
    this->ShowValues(x + static_cast<vtkIdType>(size[1] - 1 - y) * size[0]);
  }
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::ShowValues(vtkIdType pixel)
{
  vtkPointData* layers = this->Image->GetPointData();
  QStringList names;
  for (int i = 0; i < layers->GetNumberOfArrays(); ++i)
  {
    names.append(layers->GetArrayName(i));
  }
  const QString shown = pqRelievoViewSettings::GetShownLayer(this->View);
  if (!this->All->isChecked())
  {
    names = QStringList(shown);
  }
  this->Values->setRowCount(names.size());
  for (int row = 0; row < names.size(); ++row)
  {
    vtkDataArray* array = layers->GetArray(qUtf8Printable(names[row]));
    const bool normal =
      vtkRelievoLayerCatalogue::Find(names[row].toStdString()).Kind == vtkRelievoLayer::VECTOR;
    const std::string layer = names[row].toStdString();
    const QString texts[] = { relievoQt::NameLayer(layer),
      HasNothing(this->Image, names[row], pixel)
        ? "nothing"
        : relievoQt::AddUnit(WriteValues(array, normal, pixel), layer) };
    for (int column = 0; column < 2; ++column)
    {
      if (!this->Values->item(row, column))
      {
        this->Values->setItem(row, column, new QTableWidgetItem);
      }
      this->Values->item(row, column)->setText(texts[column]);
      this->Values->item(row, column)->setToolTip(texts[column]);
      this->Values->item(row, column)->setData(Qt::UserRole, names[row]);
    }
  }
  this->Values->resizeRowsToContents();
  int height = 2 * this->Values->frameWidth();
  for (int row = 0; row < names.size(); ++row)
  {
    height += this->Values->rowHeight(row);
  }
  this->Values->setFixedHeight(height);
}

//------------------------------------------------------------------------------
QString pqRelievoLayerControls::GetProbedLayers() const
{
  QStringList names;
  for (int row = 0; row < this->Values->rowCount(); ++row)
  {
    names.append(this->Values->item(row, 0)->data(Qt::UserRole).toString());
  }
  return names.join(",");
}

//------------------------------------------------------------------------------
QString pqRelievoLayerControls::GetProbed() const
{
  return this->Values->rowCount() > 0 ? this->Values->item(0, 1)->text() : QString();
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::ShowLegend()
{
  vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View);
  auto* stage =
    here ? vtkRelievoDisplayStage::SafeDownCast(here->GetFrame()->GetStage("display")) : nullptr;
  if (!stage || stage->GetLayer().empty())
  {
    return;
  }
  const bool isDrawnHere = pqRelievoViewSettings::IsDrawnHere(this->View);
  this->Legend->Show(relievoQt::DescribeLayer(stage, isDrawnHere));
  const double* shown = stage->GetShownRange();
  this->Range->ShowFound(
    isDrawnHere ? std::array<double, 2>{ shown[0], shown[1] } : std::array<double, 2>{ 0.0, 0.0 });
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::SwitchRange(bool automatic)
{
  vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View);
  auto* stage =
    here ? vtkRelievoDisplayStage::SafeDownCast(here->GetFrame()->GetStage("display")) : nullptr;
  double range[2] = { 0.0, 0.0 };
  if (!automatic)
  {
    const double* shown = stage ? stage->GetShownRange() : range;
    const bool known = pqRelievoViewSettings::IsDrawnHere(this->View) && shown[0] < shown[1];
    range[0] = known ? shown[0] : 0.0;
    range[1] = known ? shown[1] : 1.0;
  }
  this->SetRange(range[0], range[1]);
}

//------------------------------------------------------------------------------
void pqRelievoLayerControls::SetRange(double least, double most)
{
  this->Apply("Layer's range", { { "RelievoDisplayRange", QVariantList{ least, most } } });
}
