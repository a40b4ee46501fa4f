// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Application.h"
#include "Errors.h"
#include "MainWindow.h"
#include "Messages.h"
#include "Outputs.h"
#include "PictureView.h"
#include "QtVersions.h"
#include "Settings.h"
#include "StandardError.h"
#include "Version.h"

#include "vtkRenderWindow.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QSurfaceFormat>
#include <QtGlobal>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace
{
const char* const Help =
  "relievo-viewer shows what `relievo render` draws, in a window.\n"
  "\n"
  "  relievo-viewer [FILE...] [OPTION...]\n"
  "  relievo-viewer SESSION.json\n"
  "  relievo-viewer --help | --version\n"
  "\n"
  "Files and options are those of `relievo render`; see relievo render --help. Outputs are\n"
  "not written: save them from the window. --once ends the program when its first picture is on\n"
  "the screen, and prints the picture's size; or with status 1 if there can be none.\n";

bool Has(const std::vector<std::string>& words, const char* word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Prints the text; returns the exit status.
int Print(const char* text)
{
  std::fputs(text, stdout);
  if (reading::FlushStandardOutput())
  {
    return 0;
  }
  std::fputs("relievo-viewer: the standard output cannot be written; is the disk full?\n",
    reading::StandardError());
  return 1;
}

// The time for closing the window does not count.
void End(int status)
{
  std::_Exit(status);
}

//------------------------------------------------------------------------------
// Without a display or OpenGL, Qt prints lines about its plugins, and aborts or shows an empty
// window.
void EndWithoutOpenGL()
{
  std::fputs("relievo-viewer: nothing can be drawn: this display has no OpenGL 3.2\n",
    reading::StandardError());
  End(1);
}

QtMessageHandler QtsOwn = nullptr; // while an application exists

void OnMessage(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
  static QString reason;
  reason = reason.isEmpty() ? text.simplified() : reason;
  if (text.startsWith("QOpenGLWidget: Failed to create context"))
  {
    EndWithoutOpenGL();
  }
  if (QtsOwn)
  {
    QtsOwn(type, context, text);
  }
  else if (type == QtFatalMsg)
  {
    std::fprintf(reading::StandardError(),
      "relievo-viewer: no window can be opened: %s; start it on a machine with a screen, "
      "or under xvfb-run, or use relievo render\n",
      reason.toUtf8().constData());
    End(1);
  }
}

//------------------------------------------------------------------------------
// Called after the first picture, or if there is none.
void EndAfterPicture(viewer::MainWindow& window, const std::string& session)
{
  if (window.GetTrouble().isEmpty() && window.GetDocument()->Get().Files.empty())
  {
    std::fprintf(reading::StandardError(),
      "relievo-viewer: --once: %s: its \"words\" name no FILE; there is nothing to draw\n",
      session.c_str());
    End(1);
  }
  viewer::PictureView* view = window.GetView();
  const auto drawn = std::make_shared<bool>(false);
  QObject::connect(
    view, &viewer::PictureView::drawn, qApp, [view, drawn] { *drawn = !view->IsEmpty(); });
  // Called when the picture is on the screen.
  QObject::connect(view, &QOpenGLWidget::frameSwapped, qApp, [view, drawn] {
    if (*drawn)
    {
      const int* size = view->renderWindow()->GetSize();
      End(Print((std::to_string(size[0]) + "x" + std::to_string(size[1]) + "\n").c_str()));
    }
  });
  const auto endInTrouble = [&window, view] {
    if (view->IsEmpty() && !window.GetTrouble().isEmpty())
    {
      std::fprintf(
        reading::StandardError(), "relievo-viewer: %s\n", window.GetTrouble().toUtf8().constData());
      End(1);
    }
  };
  QObject::connect(&window, &viewer::MainWindow::ready, qApp, endInTrouble);
  endInTrouble();
}
}

int main(int argc, char* argv[])
{
  reading::BeProgram();
  std::vector<std::string> words(argv + 1, argv + argc);
  if (Has(words, "--help") || Has(words, "-h"))
  {
    return Print(Help);
  }
  if (Has(words, "--version"))
  {
    return Print(scene::DescribeVersions().c_str());
  }
  const auto timed = std::remove(words.begin(), words.end(), "--once");
  const bool once = timed != words.end();
  words.erase(timed, words.end());
  const bool isSession =
    words.size() == 1 && QFileInfo(QString::fromStdString(words[0])).suffix().toLower() == "json";
  const reading::Messages::Scope scope; // collects notes on the words too
  scene::Settings settings;
  try
  {
    settings = isSession ? settings : viewer::Document::FromWords(words);
    if (once && !isSession && settings.Files.empty())
    {
      throw words::UsageError("--once: no FILE given; there is nothing to draw");
    }
    settings.MakePathsAbsolute(QDir::currentPath().toStdString());
  }
  catch (const words::UsageError& error)
  {
    std::fprintf(reading::StandardError(), "relievo-viewer: %s\n", error.what());
    return 2;
  }

  QSurfaceFormat::setDefaultFormat(viewer::PictureView::GetFormat());
  viewer::UseHighDpi();
  QCoreApplication::setOrganizationName("Relievo");
  QCoreApplication::setApplicationName("relievo-viewer");
  int ours = 1; // hides our options from Qt, which has some of its own
  const QtMessageHandler before = qInstallMessageHandler(OnMessage);
  viewer::Application application(ours, argv);
  QtsOwn = before;
  reading::Outputs::RemoveAtEnd();
  viewer::MainWindow window;
  window.RestoreLayout();
  QObject::connect(window.GetView(), &viewer::PictureView::openGLTooOld, qApp, EndWithoutOpenGL);
  if (isSession)
  {
    window.OpenFiles({ QString::fromStdString(words[0]) });
  }
  else if (!words.empty())
  {
    window.Open(settings);
  }
  window.show(); // appears while files are being read
  if (once)
  {
    EndAfterPicture(window, words.front());
  }
  const int status = QApplication::exec();
  if (window.IsBusy())
  {
    QSettings().sync();
    End(status); // skips destructors, which may take long
  }
  return status;
}
