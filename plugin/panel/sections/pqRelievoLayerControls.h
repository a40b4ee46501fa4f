// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoLayerControls
 * @brief The dock's section for the displayed layer, with its legend, and for the values under the
 * mouse.
 *
 * The displayed layer is read when the mouse is over the view. Reading all values is optional: it
 * needs an extra picture when the mouse first moves after a picture.
 */
#ifndef pqRelievoLayerControls_h
#define pqRelievoLayerControls_h

#include "pqRelievoControls.h"

#include <QTimer>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPoint;
class QTableWidget;
class pqRelievoLegend;
namespace relievoQt
{
class RangeEdit;
}
class vtkImageData;

class pqRelievoLayerControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;
  /** The layers of the last values, separated by commas. */
  Q_PROPERTY(QString probedLayers READ GetProbedLayers)
  /** The values of the first of these layers, which is displayed; or "nothing". */
  Q_PROPERTY(QString probed READ GetProbed)

public:
  explicit pqRelievoLayerControls(QWidget* parent = nullptr);
  ~pqRelievoLayerControls() override;

  void SetView(pqView* view) override;
  void ShowState() override;
  void ShowScene() override;

  QString GetProbedLayers() const;
  QString GetProbed() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QStringList FindLayers() const;
  bool ReadShown();
  bool ReadAll();
  void Probe(const QPoint& place);
  void ShowValues(vtkIdType pixel);
  void DropValues();
  QString GetSeen() const;
  void AddColors(QFormLayout* rows);
  void ShowColors(const QString& layer);
  void SwitchRange(bool automatic);
  void SetRange(double least, double most);
  void ShowLegend();

  QComboBox *Layer, *Colormap;
  QCheckBox* Reversed;
  relievoQt::RangeEdit* Range;
  QWidget* Colors; // settings of colours for layers of single values
  pqRelievoLegend* Legend;
  QCheckBox* All;
  QTableWidget* Values;
  QLabel* Message;
  QPointer<QWidget> Screen; // the view's widget, observed for mouse events
  QTimer LegendTimer;
  QString Asked, Seen; // sources of the requested and the present values
  vtkNew<vtkImageData> Image;
  bool Fresh = false;   // the values are of the last picture
  bool Reading = false; // an own picture is being drawn
};

#endif
