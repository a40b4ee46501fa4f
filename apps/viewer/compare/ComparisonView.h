// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pictures of a comparison, one at a time: the baseline, the picture drawn now, or the pixels
 * of the causes. The wheel zooms, the mouse moves the picture, a double click shows all of it.
 */
#ifndef ComparisonView_h
#define ComparisonView_h

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QRect>
#include <QWidget>

#include <map>
#include <optional>
#include <vector>

class vtkImageData;

namespace viewer
{
class ComparisonView : public QWidget
{
  Q_OBJECT

public:
  /// Values of vtkRelievoFrameComparison::GetCauses() that are not in the list of causes.
  static constexpr int Rounding = -2, Edge = -3, Unexplained = -4;

  enum Kind
  {
    BASELINE,
    NOW,
    CAUSES
  };

  explicit ComparisonView(QWidget* parent = nullptr);

  /// Shows two frames. `causes` is vtkRelievoFrameComparison::GetCauses(), null if the pixels were
  /// not compared; `colors` has the colour of each of its values but -1.
  void SetFrames(vtkImageData* baseline, vtkImageData* now, vtkImageData* causes,
    const std::map<int, QColor>& colors);

  void SetKind(Kind kind);
  Kind GetKind() const { return this->Shown; }

  /// Highlights and frames the pixels of one cause; none: of all differences beyond the limits.
  void Choose(std::optional<int> cause);

  /// The displayed picture, in the pixels of its frame.
  QImage GetImage() const { return this->Image; }

  QSize sizeHint() const override { return { 340, 280 }; }

protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  void Compose();
  double GetScale() const;
  QRectF GetPlace() const;

  QImage Pictures[2]; // of the baseline and now
  QImage Image;
  std::vector<int> Causes; // by pixel, from the upper left; empty: none
  std::map<int, QColor> Colors;
  std::optional<int> Chosen;
  QRect Frame; // around the chosen pixels; empty: none
  Kind Shown = NOW;
  double Zoom = 1.0;
  QPointF Center; // of the view, in the image, 0 to 1
  QPointF Dragged;
};
}

#endif
