// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How soon a menu, or the tab of a panel, responds while the viewer gathers samples:
//   viewerMenus COUNT menu|tab WORD...
// The words are those of relievo-viewer. A thread presses a key at a random moment of the
// gathering; measured is the time until the menu or the panel of the tab is painted. Prints the
// milliseconds, sorted, and the share within 100 ms.
#include "Application.h"
#include "MainWindow.h"
#include "Messages.h"
#include "PictureView.h"
#include "Settings.h"

#include "vtkRelievoPass.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace
{
constexpr int Least = 300, Most = 2300; // milliseconds from the start of a sample's drawing

class Press : public QObject
{
public:
  Press(viewer::MainWindow& window, int count, bool tab)
    : Window(window)
    , Count(count)
    , Tab(tab)
    , Menu(window.menuBar()->actions().front()->menu())
    , Docks{ window.findChild<QDockWidget*>("look"), window.findChild<QDockWidget*>("light") }
  {
    this->Menu->installEventFilter(this);
    for (QDockWidget* dock : this->Docks)
    {
      dock->installEventFilter(this);
    }
    QObject::connect(window.GetView(), &viewer::PictureView::drawn, this, [this] {
      vtkRelievoPass* frame = this->Window.GetView()->GetPicture().GetFrame();
      if (!frame)
      {
        return;
      }
      ++this->Samples;
      const int left = frame->GetSamplesLeft();
      if (!this->Pressing && left > this->Left) // the first sample of another view
      {
        this->PressLater();
      }
      else if (!this->Pressing && left == 0)
      {
        this->Turn();
      }
      this->Left = left;
    });
  }

  ~Press() override
  {
    if (this->Thread.joinable())
    {
      this->Thread.join();
    }
  }

protected:
  bool event(QEvent* event) override
  {
    if (event->type() != QEvent::User)
    {
      return QObject::event(event);
    }
    this->Pressed = true;
    if (this->Tab)
    {
      std::swap(this->Docks[0], this->Docks[1]);
      this->Docks[0]->raise();
    }
    else
    {
      this->Window.menuBar()->setActiveAction(this->Window.menuBar()->actions().front());
    }
    return true;
  }

  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() == QEvent::Paint && this->Pressed &&
      (watched == this->Menu || watched == this->Docks[0]))
    {
      QTimer::singleShot(0, this, [this] { this->Painted(); });
    }
    return QObject::eventFilter(watched, event);
  }

private:
  void PressLater()
  {
    this->Pressing = true;
    const int pause = std::uniform_int_distribution<int>(Least, Most)(this->Random);
    if (this->Thread.joinable())
    {
      this->Thread.join();
    }
    this->Thread = std::thread([this, pause] {
      std::this_thread::sleep_for(std::chrono::milliseconds(pause));
      this->Waited.start();
      QCoreApplication::postEvent(this, new QEvent(QEvent::User), Qt::HighEventPriority);
    });
  }

  void Painted()
  {
    if (!this->Pressed)
    {
      return;
    }
    this->Pressing = this->Pressed = false;
    this->Taken.push_back(1e-6 * static_cast<double>(this->Waited.nsecsElapsed()));
    this->Menu->close();
    this->Window.menuBar()->setActiveAction(nullptr);
    if (static_cast<int>(this->Taken.size()) < this->Count)
    {
      QTimer::singleShot(0, this, [this] { this->Turn(); });
      return;
    }
    std::sort(this->Taken.begin(), this->Taken.end());
    for (const double each : this->Taken)
    {
      std::printf("%.0f ", each);
    }
    const auto soon = std::count_if(
      this->Taken.begin(), this->Taken.end(), [](double each) { return each <= 100.0; });
    std::printf("\nmedian %.0f ms, longest %.0f ms, within 100 ms: %td of %zu; samples drawn: %d\n",
      this->Taken[this->Taken.size() / 2], this->Taken.back(), soon, this->Taken.size(),
      this->Samples);
    QApplication::quit();
  }

  // The samples are gathered anew.
  void Turn()
  {
    this->Side = -this->Side;
    viewer::PictureView* view = this->Window.GetView();
    view->GetPicture().LookAlong({ this->Side, -0.4, -0.8 }, { 0.0, 1.0, 0.0 });
    view->Draw();
  }

  viewer::MainWindow& Window;
  int Count;
  bool Tab;
  QMenu* Menu;
  QDockWidget* Docks[2]; // the first is in front after the press
  bool Pressing = false; // or about to press
  bool Pressed = false;  // and not painted yet
  double Side = 0.6;
  int Left = 0; // of the last drawing
  int Samples = 0;
  std::mt19937 Random{ 1 };
  std::thread Thread;
  QElapsedTimer Waited;
  std::vector<double> Taken;
};
}

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::fputs("usage: viewerMenus COUNT menu|tab WORD...\n", stderr);
    return 2;
  }
  QSurfaceFormat::setDefaultFormat(viewer::PictureView::GetFormat());
  const QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  int ours = 1;
  viewer::Application application(ours, argv);
  const reading::Messages::Scope scope;
  viewer::MainWindow window;
  window.show();
  Press press(window, std::max(1, std::atoi(argv[1])), argv[2] == std::string("tab"));
  window.Open(viewer::Document::FromWords({ argv + 3, argv + argc }));
  return QApplication::exec();
}
