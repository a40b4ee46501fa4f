// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoLayerControls
 * @brief The dock's section of the layer shown as the picture, with its values under the mouse.
 *
 * A layer is read once after each picture, when the mouse is over it.
 */
#ifndef pqRelievoLayerControls_h
#define pqRelievoLayerControls_h

#include "pqRelievoControls.h"

class QComboBox;
class QLabel;
class QPoint;
class vtkImageData;

class pqRelievoLayerControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;
  /** The values that the probe found last, or "nothing". */
  Q_PROPERTY(QString probed READ GetProbed)

public:
  explicit pqRelievoLayerControls(QWidget* parent = nullptr);
  ~pqRelievoLayerControls() override;

  void SetView(pqView* view) override;
  void ShowState() override;

  QString GetProbed() const { return this->Probed; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void Probe(const QPoint& place);
  bool ReadLayer(const QString& layer);

  QComboBox* Layer;
  QLabel* Values;
  QPointer<QWidget> Screen; // of the view, watched for the mouse
  vtkNew<vtkImageData> Image;
  bool Fresh = false; // it is of the last picture
  QString Probed;
};

#endif
