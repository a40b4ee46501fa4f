// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoLayerControls
 * @brief The dock's section of the layer shown as the picture, with what its colours mean, and of
 * the values under the mouse.
 *
 * The shown layer is read when the mouse is over it. All values are read if that is switched on, by
 * a picture of their own, when the mouse first moves after one.
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
  /** The layers whose values were found last, with commas. */
  Q_PROPERTY(QString probedLayers READ GetProbedLayers)
  /** The values of the first of them, which is the one that is shown; or "nothing". */
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
  QWidget* Colors; // what gives layers of single values theirs
  pqRelievoLegend* Legend;
  QCheckBox* All;
  QTableWidget* Values;
  QLabel* Message;
  QPointer<QWidget> Screen; // of the view, watched for the mouse
  QTimer LegendTimer;
  QString Asked, Seen; // what the values are of
  vtkNew<vtkImageData> Image;
  bool Fresh = false;   // it is of the last picture
  bool Reading = false; // by a picture of our own
};

#endif
