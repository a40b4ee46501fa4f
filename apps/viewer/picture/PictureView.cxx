// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureView.h"

#include "Errors.h"
#include "QtVersions.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTextureObject.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>

namespace viewer
{
namespace
{
// Milliseconds
constexpr int BusyPause = 50;
constexpr int InputPause = 250; // after the user's last input, if a sample takes long
constexpr int Patience = 100;   // acceptable delay for opening a menu while samples accumulate

// Time for all samples together, relative to a single one: 13 on llvmpipe, less on GPUs.
constexpr int SamplesOfAll = 13;

// Events by which a user acts, or begins to.
bool IsInput(QEvent::Type type)
{
  switch (type)
  {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::ShortcutOverride:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
    case QEvent::NativeGesture:
    case QEvent::InputMethod:
    case QEvent::ContextMenu:
    case QEvent::FocusIn:
    case QEvent::WindowActivate:
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
      return true;
    default:
      return false;
  }
}

// The program handles keys, and the picture its clipping planes.
class MouseStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static MouseStyle* New();
  vtkTypeMacro(MouseStyle, vtkInteractorStyleTrackballCamera);
  void OnChar() override {}

protected:
  MouseStyle() { this->AutoAdjustCameraClippingRangeOff(); }
};
vtkStandardNewMacro(MouseStyle);
}

//------------------------------------------------------------------------------
QSurfaceFormat PictureView::GetFormat()
{
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setOption(QSurfaceFormat::DeprecatedFunctions); // wide lines need deprecated functions
  return format;
}

//------------------------------------------------------------------------------
PictureView::PictureView(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  this->setEnableHiDPI(false); // text sizes follow from the picture's height
  this->setRenderWindow(window);
  this->setAcceptDrops(false); // the program's window accepts them
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true);
  this->setMinimumSize(200, 150);
  window->GetInteractor()->SetInteractorStyle(vtkNew<MouseStyle>());
  this->Shown = std::make_unique<Picture>(window);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    static_cast<PictureView*>(self)->OnDrawn();
  });
  window->AddObserver(vtkCommand::EndEvent, command);
  vtkNew<vtkCallbackCommand> begin;
  begin->SetClientData(this);
  begin->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    auto* view = static_cast<PictureView*>(self);
    view->LetLinesBeWide();
    view->Begun.start();
  });
  this->Beginning = window->AddObserver(vtkCommand::StartEvent, begin);
  this->Soon.setSingleShot(true);
  QObject::connect(&this->Soon, &QTimer::timeout, this, [this] { this->renderWindow()->Render(); });
  qApp->installEventFilter(this);
  vtkNew<vtkCallbackCommand> check;
  check->SetClientData(this);
  check->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    static_cast<PictureView*>(self)->MakeWay();
  });
  this->Checking = window->AddObserver(vtkCommand::AbortCheckEvent, check);
  this->Rest.setSingleShot(true);
  QObject::connect(&this->Rest, &QTimer::timeout, this, &PictureView::GoOn);
  QObject::connect(this, &QOpenGLWidget::frameSwapped, this, [this] {
    if (this->Rest.isActive())
    {
      this->Rest.start(this->GetPause());
    }
  });
}

//------------------------------------------------------------------------------
PictureView::~PictureView()
{
  this->renderWindow()->RemoveObservers(vtkCommand::EndEvent);
  this->renderWindow()->RemoveObserver(this->Beginning);
  this->renderWindow()->RemoveObserver(this->Checking);
  this->makeCurrent();
  this->Shown.reset();
  this->doneCurrent();
}

//------------------------------------------------------------------------------
void PictureView::Draw()
{
  if (!this->Soon.isActive())
  {
    this->Soon.start(0);
  }
}

//------------------------------------------------------------------------------
// VTK's widget draws wide lines as quadrilaterals, because OpenGL may refuse them in Qt's contexts.
// The command line's window uses OpenGL's wide lines, whose ends cover other pixels.
void PictureView::LetLinesBeWide()
{
  vtkGenericOpenGLRenderWindow::SafeDownCast(this->renderWindow())
    ->SetForceMaximumHardwareLineWidth(
      this->format().testOption(QSurfaceFormat::DeprecatedFunctions) ? 0.0F : 1.0F);
}

//------------------------------------------------------------------------------
void PictureView::OnDrawn()
{
  vtkRelievoPass* frame = this->Shown ? this->Shown->GetFrame() : nullptr;
  const int left = frame ? frame->GetSamplesLeft() : 0;
  const bool whole = this->renderWindow()->GetAbortRender() == 0;
  if (left > 0 && left >= this->SamplesLeft && whole) // this was the first sample
  {
    this->renderWindow()->WaitForCompletion();
    frame->SetSamplesOneByOne(!this->Hurried && this->Begun.elapsed() * SamplesOfAll > Patience);
  }
  this->SamplesLeft = left;
  // A slow sample waits until this one is on the screen: it would give way to its events.
  const int pause = std::max(this->GetPause(), this->IsSlow() ? BusyPause : 0);
  left > 0 || !whole ? this->Rest.start(pause) : this->Rest.stop();
  Q_EMIT this->drawn();
}

//------------------------------------------------------------------------------
void PictureView::SetHurried(bool on)
{
  this->Hurried = on;
  if (on && this->Shown->GetFrame())
  {
    this->Shown->GetFrame()->SamplesOneByOneOff();
  }
}

//------------------------------------------------------------------------------
bool PictureView::eventFilter(QObject* watched, QEvent* event)
{
  if (IsInput(event->type()))
  {
    this->SinceInput.start();
    this->GaveWay = false;
    if (this->Rest.isActive() && this->IsSlow())
    {
      this->Rest.start(InputPause);
    }
  }
  return this->QVTKOpenGLNativeWidget::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
// Aborts a sample while an event waits for it. If that was no input, the next sample is drawn to
// its end, so that a steady flow of other events does not keep the picture from being completed.
void PictureView::MakeWay()
{
  if (this->Yields && HasPendingEvents())
  {
    this->renderWindow()->SetAbortRender(1);
    this->GaveWay = true;
  }
}

//------------------------------------------------------------------------------
// Whether a sample takes long.
bool PictureView::IsSlow() const
{
  vtkRelievoPass* frame = this->Shown ? this->Shown->GetFrame() : nullptr;
  return frame && frame->GetSamplesOneByOne();
}

//------------------------------------------------------------------------------
// Milliseconds until the next sample.
int PictureView::GetPause() const
{
  return this->IsSlow() && this->SinceInput.isValid()
    ? static_cast<int>(std::max<qint64>(0, InputPause - this->SinceInput.elapsed()))
    : 0;
}

//------------------------------------------------------------------------------
// Draws the remaining samples, unless the user has a menu open or drags: input takes precedence.
void PictureView::GoOn()
{
  if (QApplication::activePopupWidget() || QApplication::mouseButtons() != Qt::NoButton)
  {
    this->Rest.start(BusyPause);
    return;
  }
  this->Yields = this->IsSlow() && !this->GaveWay;
  this->GaveWay = false;
  this->renderWindow()->Render();
  this->Yields = false;
}

//------------------------------------------------------------------------------
void PictureView::initializeGL()
{
  if (this->format().version() < qMakePair(3, 2))
  {
    Q_EMIT this->openGLTooOld();
  }
  this->QVTKOpenGLNativeWidget::initializeGL();
}

//------------------------------------------------------------------------------
QPoint PictureView::GetPixel(const QPoint& place) const
{
  const double ratio = this->effectiveDevicePixelRatio();
  const int* size = this->renderWindow()->GetSize();
  return { static_cast<int>(ratio * place.x()), size[1] - 1 - static_cast<int>(ratio * place.y()) };
}

//------------------------------------------------------------------------------
void PictureView::PickNext(bool on)
{
  this->Picking = on;
  on ? this->setCursor(Qt::CrossCursor) : this->unsetCursor();
}

//------------------------------------------------------------------------------
void PictureView::mousePressEvent(QMouseEvent* event)
{
  if (!this->Picking || event->button() != Qt::LeftButton)
  {
    this->QVTKOpenGLNativeWidget::mousePressEvent(event);
    return;
  }
  this->PickNext(false);
  const QPoint pixel = this->GetPixel(event->pos());
  Q_EMIT this->picked(pixel.x(), pixel.y());
}

//------------------------------------------------------------------------------
void PictureView::mouseMoveEvent(QMouseEvent* event)
{
  this->QVTKOpenGLNativeWidget::mouseMoveEvent(event);
  const QPoint pixel = this->GetPixel(event->pos());
  Q_EMIT this->pointed(pixel.x(), pixel.y());
}

//------------------------------------------------------------------------------
void PictureView::leaveEvent(QEvent* event)
{
  this->QVTKOpenGLNativeWidget::leaveEvent(event);
  Q_EMIT this->pointed(-1, -1);
}

//------------------------------------------------------------------------------
void PictureView::resizeEvent(QResizeEvent* event)
{
  this->QVTKOpenGLNativeWidget::resizeEvent(event);
  const auto getAspect = [](const QSize& size) {
    return static_cast<double>(size.width()) / size.height();
  };
  if (!event->oldSize().isEmpty() && !event->size().isEmpty())
  {
    this->Shown->KeepInView(getAspect(event->oldSize()), getAspect(event->size()));
  }
  this->Draw();
}

//------------------------------------------------------------------------------
PictureView::OtherSize::OtherSize(PictureView* view, const QSize& size)
  : View(view)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(view->renderWindow());
  this->Before = { window->GetSize()[0], window->GetSize()[1] };
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (size.isValid() && std::max(size.width(), size.height()) > limit)
  {
    throw scene::WorkError(QString("%1x%2 pixels: OpenGL here draws at most %3 each way")
                             .arg(size.width())
                             .arg(size.height())
                             .arg(limit)
                             .toStdString());
  }
  if (size.isValid())
  {
    view->setUpdatesEnabled(false);
    window->SetSize(size.width(), size.height());
  }
}

//------------------------------------------------------------------------------
PictureView::OtherSize::~OtherSize()
{
  this->View->renderWindow()->SetSize(this->Before.width(), this->Before.height());
  this->View->setUpdatesEnabled(true);
  this->View->Draw();
}
}
