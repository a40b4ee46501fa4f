// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureView.h"

#include "Display.h"
#include "Errors.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindowInteractor.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QThread>

#include <algorithm>
#include <utility>

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

// Whether an event concerns neither OpenGL nor the scene; menus, tool tips and the mouse's pointer
// send such events.
bool IsAside(const QEvent& event)
{
  switch (event.type())
  {
    case QEvent::MouseMove:
      return static_cast<const QMouseEvent&>(event).buttons() == Qt::NoButton;
    case QEvent::ChildAdded:
    case QEvent::ChildPolished:
    case QEvent::ChildRemoved:
    case QEvent::CursorChange:
    case QEvent::DynamicPropertyChange:
    case QEvent::Enter:
    case QEvent::FocusAboutToChange:
    case QEvent::FocusIn:
    case QEvent::FocusOut:
    case QEvent::HoverEnter:
    case QEvent::HoverLeave:
    case QEvent::HoverMove:
    case QEvent::InputMethodQuery:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::LayoutRequest:
    case QEvent::Leave:
    case QEvent::MetaCall:
    case QEvent::Paint: // see paintEvent
    case QEvent::PolishRequest:
    case QEvent::ShortcutOverride:
    case QEvent::StatusTip:
    case QEvent::Timer:
    case QEvent::ToolTip:
    case QEvent::UpdateLater:
    case QEvent::UpdateRequest:
    case QEvent::WindowActivate:
    case QEvent::WindowBlocked:
    case QEvent::WindowDeactivate:
    case QEvent::WindowUnblocked:
    case QEvent::ZOrderChange:
      return true;
    default:
      return false;
  }
}
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
  , Sample(this)
{
  this->MakeOwnWindow();
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
  QObject::connect(&this->Soon, &QTimer::timeout, this, [this] {
    this->TakeBack();
    this->Soon.stop(); // whoever waited for the sample may ask for this picture, too
    if (this->IsFirstLent())
    {
      this->Lend();
      Q_EMIT this->drawing();
    }
    else
    {
      this->renderWindow()->Render();
    }
  });
  QObject::connect(&this->Sample, &QThread::finished, this, &PictureView::ShowSample);
  this->Holding->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  window->AddObserver(vtkCommand::WindowFrameEvent, this->Holding, 1.0F); // before the widget's
  qApp->installEventFilter(this);
  this->Rest.setSingleShot(true);
  QObject::connect(&this->Rest, &QTimer::timeout, this, &PictureView::GoOn);
}

//------------------------------------------------------------------------------
PictureView::~PictureView()
{
  QObject::disconnect(this, &PictureView::returned, nullptr, nullptr);
  this->TakeBack();
  this->renderWindow()->RemoveObservers(vtkCommand::EndEvent);
  this->renderWindow()->RemoveObserver(this->Beginning);
  this->renderWindow()->RemoveObserver(this->Holding);
  this->makeCurrent();
  this->Shown.reset();
  this->doneCurrent();
}

//------------------------------------------------------------------------------
// Qt composes a window that contains OpenGL in OpenGL, which waits for the sample that a thread
// draws. With a window of its own for the picture, the panels are painted without OpenGL. Other
// platforms than X11 may not move such windows together.
void PictureView::MakeOwnWindow()
{
  if (SampleThread::IsPossible() && QGuiApplication::platformName() == "xcb")
  {
    QApplication::setAttribute(Qt::AA_DontCreateNativeWidgetSiblings);
    this->setAttribute(Qt::WA_DontCreateNativeAncestors);
    this->setAttribute(Qt::WA_NativeWindow);
  }
}

//------------------------------------------------------------------------------
void PictureView::Draw()
{
  this->Unannounced = false; // another picture follows
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
  if (QThread::currentThread() != this->thread())
  {
    return; // see ShowSample
  }
  this->Unannounced = false;
  vtkRelievoPass* frame = this->Shown ? this->Shown->GetFrame() : nullptr;
  const int left = frame ? frame->GetSamplesLeft() : 0;
  if (left > 0 && left >= this->SamplesLeft) // this was the first sample
  {
    this->renderWindow()->MakeCurrent(); // after a thread's sample it is not
    this->renderWindow()->WaitForCompletion();
    frame->SetSamplesOneByOne(!this->Hurried && this->Begun.elapsed() * SamplesOfAll > Patience);
  }
  this->SamplesLeft = left;
  left > 0 ? this->Rest.start(0) : this->Rest.stop();
  Q_EMIT this->drawn();
}

//------------------------------------------------------------------------------
void PictureView::SetHurried(bool on)
{
  this->Hurried = on;
  if (vtkRelievoPass* frame = this->GetPicture().GetFrame(); on && frame)
  {
    frame->SamplesOneByOneOff();
  }
}

//------------------------------------------------------------------------------
bool PictureView::event(QEvent* event)
{
  if (!IsAside(*event))
  {
    this->TakeBack();
  }
  return this->QVTKOpenGLNativeWidget::event(event);
}

//------------------------------------------------------------------------------
// Menus and tool tips are windows of their own.
bool PictureView::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::UpdateRequest:
      if (watched == this->window() && this->Sample.IsLent() &&
        !this->testAttribute(Qt::WA_NativeWindow))
      {
        this->Unpainted = true;
        return true;
      }
      break;
    case QEvent::KeyPress:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
    case QEvent::Wheel:
      this->SinceInput.start();
      break;
    default:
      break;
  }
  return this->QVTKOpenGLNativeWidget::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
// Draws the remaining samples, unless the user has a menu open, drags, or has just acted: input
// takes precedence.
void PictureView::GoOn()
{
  this->TakeBack();
  if (this->Soon.isActive() || !this->updatesEnabled())
  {
    return; // another picture follows, or one of another size is being drawn
  }
  vtkRelievoPass* frame = this->Shown->GetFrame();
  const bool slow = frame && frame->GetSamplesOneByOne();
  const bool busy = QApplication::activePopupWidget() ||
    QApplication::mouseButtons() != Qt::NoButton ||
    (slow && this->SinceInput.isValid() && this->SinceInput.elapsed() < InputPause);
  if (busy)
  {
    this->Rest.start(BusyPause);
  }
  else if (slow && SampleThread::IsPossible())
  {
    this->Lend();
  }
  else
  {
    this->renderWindow()->Render();
  }
}

//------------------------------------------------------------------------------
// Whether a thread draws a view's first sample, too: that of a volume takes as long as each later
// one.
bool PictureView::IsFirstLent() const
{
  return SampleThread::IsPossible() && this->isValid() && this->isVisible() &&
    this->updatesEnabled() && !this->Hurried && QApplication::mouseButtons() == Qt::NoButton &&
    this->Shown->HasVolume();
}

//------------------------------------------------------------------------------
void PictureView::Lend()
{
  this->Holding->AbortFlagOnExecuteOn();
  this->Unannounced = true;
  this->setUpdatesEnabled(false);
  this->Sample.Lend();
}

//------------------------------------------------------------------------------
// Waits for a sample that the thread draws. ShowSample follows.
void PictureView::TakeBack()
{
  if (this->Sample.IsLent())
  {
    this->Sample.TakeBack();
    this->setUpdatesEnabled(true);
    this->Holding->AbortFlagOnExecuteOff();
    // Otherwise VTK's widget would draw a resized picture again.
    this->renderWindow()->InvokeEvent(vtkCommand::WindowFrameEvent);
    if (this->Unpainted)
    {
      this->Unpainted = false;
      QCoreApplication::postEvent(this->window(), new QEvent(QEvent::UpdateRequest));
    }
    Q_EMIT this->returned();
    for (const auto& change : std::exchange(this->Changes, {}))
    {
      this->Change(change);
    }
  }
}

//------------------------------------------------------------------------------
void PictureView::Change(const std::function<void(Picture&)>& change)
{
  if (this->IsDrawing())
  {
    this->Changes.push_back(change);
    return;
  }
  change(*this->Shown);
  this->Draw();
}

//------------------------------------------------------------------------------
Picture& PictureView::GetPicture()
{
  this->TakeBack();
  return *this->Shown;
}

//------------------------------------------------------------------------------
// Another picture may have been drawn since.
void PictureView::ShowSample()
{
  this->TakeBack();
  if (this->Unannounced)
  {
    this->OnDrawn();
    this->update();
  }
  else if (!this->Sample.IsLent())
  {
    this->repaint(); // pictures that follow each other soon are all seen
  }
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
// Objects move as if the mouse dragged them in the arrow's direction.
void PictureView::keyPressEvent(QKeyEvent* event)
{
  constexpr double degrees = 5.0, share = 0.05, factor = 1.1;
  const int key = event->key();
  const int right = (key == Qt::Key_Right) - (key == Qt::Key_Left);
  const int up = (key == Qt::Key_Up) - (key == Qt::Key_Down);
  const int nearer = (key == Qt::Key_Plus || key == Qt::Key_Equal) - (key == Qt::Key_Minus);
  const bool isOther =
    event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  if (isOther || (right == 0 && up == 0 && nearer == 0))
  {
    this->QVTKOpenGLNativeWidget::keyPressEvent(event);
    return;
  }
  const bool moves = event->modifiers() & Qt::ShiftModifier;
  this->Change([right, up, nearer, moves](Picture& picture) {
    if (nearer != 0)
    {
      picture.Zoom(nearer > 0 ? factor : 1.0 / factor);
    }
    else if (moves)
    {
      picture.Move(-share * right, -share * up);
    }
    else
    {
      picture.Turn(-degrees * right, -degrees * up);
    }
  });
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
// While a thread draws, the window keeps the last picture.
void PictureView::paintEvent(QPaintEvent* event)
{
  if (!this->Sample.IsLent())
  {
    this->QVTKOpenGLNativeWidget::paintEvent(event);
  }
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
  view->TakeBack();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(view->renderWindow());
  this->Before = { window->GetSize()[0], window->GetSize()[1] };
  const int limit = scene::GetSizeLimit(window);
  if (size.isValid() && std::max(size.width(), size.height()) > limit)
  {
    throw words::WorkError(QString("%1x%2 pixels: OpenGL here draws at most %3 each way")
                             .arg(size.width())
                             .arg(size.height())
                             .arg(limit)
                             .toStdString());
  }
  if (size.isValid())
  {
    this->Still = std::make_unique<QLabel>(view->parentWidget());
    for (const Qt::WidgetAttribute own : { Qt::WA_DontCreateNativeAncestors, Qt::WA_NativeWindow })
    {
      this->Still->setAttribute(own, view->testAttribute(own)); // a native view would cover it
    }
    this->Still->setPixmap(view->grab());
    this->Still->setGeometry(view->geometry());
    this->Still->show();
    view->setUpdatesEnabled(false);
    window->SetSize(size.width(), size.height());
  }
}

//------------------------------------------------------------------------------
PictureView::OtherSize::~OtherSize()
{
  this->View->TakeBack();
  this->View->renderWindow()->SetSize(this->Before.width(), this->Before.height());
  this->View->setUpdatesEnabled(true);
  this->View->Draw();
}
}
