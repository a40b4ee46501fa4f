// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Helpers for the tests of the viewer: its window, scenes, and the command line's pictures.
 */
#ifndef ViewerTest_h
#define ViewerTest_h

#include "MainWindow.h"
#include "PictureView.h"
#include "Settings.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <QDialog>
#include <QEvent>
#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QProcess>
#include <QSize>
#include <QString>
#include <QTemporaryDir>
#include <QTimer>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace viewerTest
{
/// While one lives, dialogs that wait for the user get an answer, and are counted.
class Dialogs
{
public:
  using Answer = std::function<void(QDialog*)>;

  explicit Dialogs(Answer answer = [](QDialog* dialog) { dialog->reject(); });
  int GetCount() const { return this->Count; }

private:
  QTimer Timer;
  int Count = 0;
};

class ViewerTest : public QObject
{
  Q_OBJECT

protected:
  /// A file in the test's folder.
  std::string Path(const std::string& name) const;

  /// A ball above a square ground, with a point array `height` and a cell array `part`.
  std::string WriteScene(const std::string& name = "scene.vtp") const;

  /// Points with radii for lamps, fog and markers.
  std::string WritePoints(
    const std::string& name = "points.vtp", const char* array = "radius") const;

  /// An image of waves: heights, colours of a sky, or slopes of a normal map.
  std::string WriteImage() const;

  /// Two triangles of OBJ, with a shining and a translucent material, or the shining one alone.
  std::string WriteOBJ(bool both = true) const;

  void WriteText(const std::string& name, const std::string& text) const;

  /// Opens a window with these words and waits until it shows them.
  void Open(const std::vector<std::string>& words, const QSize& size = QSize(800, 480));

  /// The same window opens these words as an unchanged scene.
  void OpenAgain(const std::vector<std::string>& words);

  /// The window changes its settings and has read the necessary files.
  void Change(const std::function<void(scene::Settings&)>& edit);
  void WaitUntilRead();

  /// The window's picture, and the picture by `relievo render` with the words that the window
  /// copies, in this process: starting another one's OpenGL and shaders takes much longer than a
  /// picture.
  vtkSmartPointer<vtkImageData> Grab();
  vtkSmartPointer<vtkImageData> RenderCommand();

  /// The command with other settings, and more words.
  bool RunCommand(const scene::Settings& settings, const std::vector<std::string>& more);

  /// The test fails unless both are the same.
  void Compare(const char* what);

  /**
   * Sends a mouse event to the view, or to a widget over it there, at a place of the view, with the
   * left button's state: QTest moves the display's pointer, whose events come late and without
   * buttons on a busy machine.
   */
  void SendMouse(QEvent::Type type, const QPoint& place, Qt::MouseButton pressed);

  /// The output of the Python program that the window copies.
  vtkSmartPointer<vtkImageData> RunPython();

  /// This program's words for the class shared with the command, without drawing.
  scene::Settings RunPythonForWords();

  static vtkSmartPointer<vtkImageData> ReadPNG(const std::string& path);

  /// Pixels that differ between the two; -1 if their sizes do.
  static int CountDifferent(vtkImageData* a, vtkImageData* b);

  /// By how many levels of 255 pictures of one size differ at most.
  static int MostDifferent(vtkImageData* a, vtkImageData* b);

  std::unique_ptr<viewer::MainWindow> Window;

private Q_SLOTS:
  void init();
  void cleanup();
  void cleanupTestCase();

private:
  // Python's whole output for the program that the window copies; empty if it fails.
  QByteArray AskPython(const char* task);

  vtkSmartPointer<vtkRenderWindow> Command; // off screen, of all pictures of the command
  QProcess Python;                          // runs programs one after another
  std::unique_ptr<QTemporaryDir> Folder;
  QPointer<QWidget> Held; // by the mouse's button
};

/// Runs the tests of an object as a program.
int Run(QObject& tests, int argc, char* argv[]);
}

#endif
