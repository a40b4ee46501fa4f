// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A widget with the picture: the mouse turns, moves and zooms it; soft shadows accumulate while it
 * rests.
 */
#ifndef PictureView_h
#define PictureView_h

#include "Picture.h"
#include "SampleThread.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QElapsedTimer>
#include <QSize>
#include <QSurfaceFormat>
#include <QTimer>

#include <functional>
#include <memory>
#include <vector>

class QLabel;

namespace viewer
{
class PictureView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  /// Programs set it as the default before the first view.
  static QSurfaceFormat GetFormat();

  explicit PictureView(QWidget* parent = nullptr);
  ~PictureView() override;

  /// The picture. While a sample is drawn, this waits for it.
  Picture& GetPicture();

  ///@{
  /// Properties that drawing does not change, without waiting.
  bool IsEmpty() const { return this->Shown->IsEmpty(); }
  bool IsDrawing() const { return this->Sample.IsLent(); }
  ///@}

  /// The window's pixel at a widget position, from the lower left.
  QPoint GetPixel(const QPoint& place) const;

  /// The next left click emits `picked` instead of turning the view.
  void PickNext(bool on);

  /// While one lives, the picture has this many pixels, the vertical angle stays, and the view
  /// keeps showing its last picture. An invalid size means the view's own. Throws
  /// words::WorkError for more pixels than OpenGL can draw.
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
    std::unique_ptr<QLabel> Still; // over the view
  };

  /// Changes the picture's camera and draws, after the sample that is being drawn.
  void Change(const std::function<void(Picture&)>& change);

  /// Draws soon; several calls are combined.
  void Draw();

  /// Draws all samples at once, although the window is unresponsive meanwhile; otherwise slow
  /// samples are drawn one by one. Default off.
  void SetHurried(bool on);

Q_SIGNALS:
  void drawn();

  /// A thread begins to draw the first sample of a view.
  void drawing();

  /// A sample that IsDrawing() reported is complete. Emitted before GetPicture() returns to whoever
  /// has waited for the sample.
  void returned();

  /// Emitted if OpenGL is older than 3.2, before VTK starts, which would crash.
  void openGLTooOld();

  /// The mouse is over a pixel of the window, from the lower left; -1 after it has left.
  void pointed(int x, int y);

  /// Pixels as in `pointed`.
  void picked(int x, int y);

protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void initializeGL() override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void MakeOwnWindow();
  void LetLinesBeWide();
  void OnDrawn();
  void GoOn();
  bool IsFirstLent() const;
  void Lend();
  void TakeBack();
  void ShowSample();

  std::unique_ptr<Picture> Shown;
  unsigned long Beginning;
  vtkNew<vtkCallbackCommand> Holding; // painting, while a thread draws
  SampleThread Sample;
  bool Unpainted = false;                             // the window waits for the sample
  bool Unannounced = false;                           // a thread draws a sample, or has drawn one
  std::vector<std::function<void(Picture&)>> Changes; // after the sample
  bool Picking = false;
  QTimer Soon, Rest;
  QElapsedTimer Begun; // start of the frame
  QElapsedTimer SinceInput;
  bool Hurried = false;
  int SamplesLeft = 0;
};
}

#endif
