// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The picture in a widget: the mouse turns, moves and zooms it; soft shadows gather while it rests.
 */
#ifndef PictureView_h
#define PictureView_h

#include "Picture.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QElapsedTimer>
#include <QSize>
#include <QSurfaceFormat>
#include <QTimer>

#include <memory>

namespace viewer
{
class PictureView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  /// Programs make it their default before there is a view.
  static QSurfaceFormat GetFormat();

  explicit PictureView(QWidget* parent = nullptr);
  ~PictureView() override;

  Picture& GetPicture() { return *this->Shown; }

  /// The pixel of the window at a place of the widget, from the lower left.
  QPoint GetPixel(const QPoint& place) const;

  /// The next click of the left button is told as `picked`, and turns nothing.
  void PickNext(bool on);

  /// While one lives, the picture has this many pixels, and the vertical angle stays. An invalid
  /// size is the view's own. Throws scene::WorkError for more than OpenGL draws.
  class OtherSize
  {
  public:
    OtherSize(PictureView* view, const QSize& size);
    ~OtherSize();
    OtherSize(const OtherSize&) = delete;
    void operator=(const OtherSize&) = delete;

  private:
    PictureView* View;
    QSize Before;
  };

  /// Draws soon; several calls draw once.
  void Draw();

  /// Samples are drawn at once, however long the window does not answer; otherwise one by one where
  /// that takes long. Default off.
  void SetHurried(bool on);

Q_SIGNALS:
  void drawn();

  /// The display's OpenGL is older than 3.2, before VTK, which crashes then, is told.
  void openGLTooOld();

  /// The mouse is over a pixel of the window, from the lower left; -1 when it has left.
  void pointed(int x, int y);

  /// Pixels as of `pointed`.
  void picked(int x, int y);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void initializeGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void LetLinesBeWide();
  void OnDrawn();
  void GoOn();

  std::unique_ptr<Picture> Shown;
  unsigned long Beginning;
  bool Picking = false;
  QTimer Soon, Rest;
  QElapsedTimer Begun; // the frame
  QElapsedTimer SinceInput;
  bool Hurried = false;
  int SamplesLeft = 0;
};
}

#endif
