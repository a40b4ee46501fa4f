// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerTest.h"

#include "Application.h"
#include "Messages.h"
#include "Options.h"
#include "QtVersions.h"
#include "Scripts.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkElevationFilter.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoReaderProcess.h"
#include "vtkRelievoScene.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <QSurfaceFormat>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace viewerTest
{
namespace
{
void Write(vtkPolyData* data, const std::string& path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary(); // newer expats make Python's VTK refuse appended data
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  QVERIFY(writer->Write() == 1);
}
}

//------------------------------------------------------------------------------
Dialogs::Dialogs(Answer answer)
{
  QObject::connect(&this->Timer, &QTimer::timeout, &this->Timer, [this, answer] {
    if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget()))
    {
      ++this->Count;
      answer(dialog);
    }
  });
  this->Timer.start(10);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ViewerTest::ReadPNG(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
void ViewerTest::init()
{
  this->Folder = std::make_unique<QTemporaryDir>();
}

//------------------------------------------------------------------------------
void ViewerTest::cleanup()
{
  this->Window.reset();
  this->Folder.reset();
}

//------------------------------------------------------------------------------
void ViewerTest::cleanupTestCase()
{
  this->Command = nullptr; // while its display is there
  this->Python.closeWriteChannel();
  this->Python.waitForFinished();
}

//------------------------------------------------------------------------------
std::string ViewerTest::Path(const std::string& name) const
{
  return this->Folder->filePath(QString::fromStdString(name)).toStdString();
}

//------------------------------------------------------------------------------
std::string ViewerTest::WriteScene(const std::string& name) const
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 0.8, 0.0);
  ball->SetRadius(0.6);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(16);
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-1.5, 0.0, 1.5);
  ground->SetPoint1(1.5, 0.0, 1.5);
  ground->SetPoint2(-1.5, 0.0, -1.5);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(ball->GetOutputPort());
  both->AddInputConnection(ground->GetOutputPort());
  vtkNew<vtkElevationFilter> height;
  height->SetInputConnection(both->GetOutputPort());
  height->SetLowPoint(0.0, 0.0, 0.0);
  height->SetHighPoint(0.0, 1.0, 0.0);
  height->SetScalarRange(0.0, 1.0);
  height->Update();
  vtkPolyData* data = height->GetPolyDataOutput();
  data->GetPointData()->GetScalars()->SetName("height");
  vtkNew<vtkIntArray> part;
  part->SetName("part");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    part->InsertNextValue(static_cast<int>(cell) + 100);
  }
  data->GetCellData()->AddArray(part);
  Write(data, this->Path(name));
  return this->Path(name);
}

//------------------------------------------------------------------------------
std::string ViewerTest::WritePoints(const std::string& name, const char* array) const
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.9, 0.5, 0.6);
  points->InsertNextPoint(-0.8, 0.3, 0.4);
  vtkNew<vtkFloatArray> radius;
  radius->SetName(array);
  radius->InsertNextValue(1.2F);
  radius->InsertNextValue(0.9F);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(radius);
  Write(data, this->Path(name));
  return this->Path(name);
}

//------------------------------------------------------------------------------
std::string ViewerTest::WriteImage() const
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(32, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 16; ++y)
  {
    for (int x = 0; x < 32; ++x)
    {
      auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      texel[0] = static_cast<unsigned char>(128.0 + 60.0 * std::sin(0.6 * x));
      texel[1] = static_cast<unsigned char>(128.0 + 60.0 * std::cos(0.9 * y));
      texel[2] = 230;
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(this->Path("waves.png").c_str());
  writer->Write();
  return this->Path("waves.png");
}

//------------------------------------------------------------------------------
void ViewerTest::WriteText(const std::string& name, const std::string& text) const
{
  QFile file(QString::fromStdString(this->Path(name)));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(text));
}

//------------------------------------------------------------------------------
std::string ViewerTest::WriteOBJ(bool both) const
{
  this->WriteText("two.mtl",
    "newmtl shining\nKd 0.8 0.3 0.2\nKs 0.9 0.9 0.7\nNs 12\nillum 2\n"
    "newmtl glass\nKd 0.2 0.4 0.8\nd 0.5\n");
  this->WriteText("two.obj",
    "mtllib two.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0.5\nusemtl shining\nf 1 2 3\n" +
      std::string(both ? "usemtl glass\n" : "") + "f 2 4 3\n");
  return this->Path("two.obj");
}

//------------------------------------------------------------------------------
void ViewerTest::Open(const std::vector<std::string>& words, const QSize& size)
{
  this->Window = std::make_unique<viewer::MainWindow>();
  this->Window->resize(size);
  this->Window->show();
  QVERIFY(QTest::qWaitForWindowExposed(this->Window.get()));
  if (this->Window->findChild<QDockWidget*>("scene")->isHidden()) // the window is small
  {
    this->Window->findChild<QAction*>("panels")->trigger();
  }
  this->OpenAgain(words);
}

//------------------------------------------------------------------------------
void ViewerTest::OpenAgain(const std::vector<std::string>& words)
{
  QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
  this->Window->Open(viewer::Document::FromWords(words));
  QVERIFY(ready.wait(60000));
}

//------------------------------------------------------------------------------
void ViewerTest::WaitUntilRead()
{
  QTRY_VERIFY_WITH_TIMEOUT(!this->Window->IsReading(), 60000);
  QCoreApplication::processEvents(); // the bar of the work gives its room back to the view
}

//------------------------------------------------------------------------------
void ViewerTest::Change(const std::function<void(scene::Settings&)>& edit)
{
  this->Window->GetDocument()->Change(edit);
  this->WaitUntilRead();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ViewerTest::Grab()
{
  return this->Window->GetView()->GetPicture().Grab();
}

//------------------------------------------------------------------------------
void ViewerTest::SendMouse(QEvent::Type type, const QPoint& place, Qt::MouseButton pressed)
{
  viewer::PictureView* view = this->Window->GetView();
  const Qt::MouseButton changed = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
  QWidget* over = this->Held ? this->Held.data() : view->childAt(place);
  QWidget* target = over ? over : view;
  QMouseEvent event(
    type, target->mapFrom(view, place), view->mapToGlobal(place), changed, pressed, Qt::NoModifier);
  this->Held = pressed == Qt::NoButton ? nullptr : target;
  QApplication::sendEvent(target, &event);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ViewerTest::RenderCommand()
{
  const std::string png = this->Path("command.png");
  return this->RunCommand(this->Window->GetCopiedSettings(), { "--png", png }) ? ReadPNG(png)
                                                                               : nullptr;
}

//------------------------------------------------------------------------------
bool ViewerTest::RunCommand(const scene::Settings& settings, const std::vector<std::string>& more)
{
  vtkNew<vtkStringArray> words;
  for (const std::vector<std::string>& some : { more, settings.GetWords() })
  {
    for (const std::string& word : some)
    {
      words->InsertNextValue(word);
    }
  }
  if (QOpenGLContext* current = QOpenGLContext::currentContext())
  {
    current->doneCurrent(); // Qt does not see that VTK takes its place
  }
  if (!this->Command)
  {
    this->Command = vtkSmartPointer<vtkRenderWindow>::New();
    this->Command->SetOffScreenRendering(1);
    this->Command->SetMultiSamples(0);
  }
  const std::array<int, 2> size = settings.Parse().Size;
  this->Command->SetSize(size[0], size[1]);
  vtkSmartPointer<vtkRenderer> renderer;
  bool written = false;
  {
    // Another scene each time: the test is about a window with changed words.
    vtkNew<vtkRelievoScene> scene;
    scene->SetRenderWindow(this->Command);
    written = scene->SetWords(words) && scene->Write();
    renderer = scene->GetRenderer();
    if (!written)
    {
      qWarning() << scene->GetFailureText().c_str();
    }
  }
  if (renderer)
  {
    this->Command->RemoveRenderer(renderer);
  }
  static_cast<vtkOpenGLRenderWindow*>(this->Command.Get())->ReleaseCurrent();
  return written;
}

//------------------------------------------------------------------------------
void ViewerTest::Compare(const char* what)
{
  const vtkSmartPointer<vtkImageData> shown = this->Grab();
  const vtkSmartPointer<vtkImageData> command = this->RenderCommand();
  const int different = CountDifferent(shown, command);
  if (different > 0)
  {
    const QDir folder(qEnvironmentVariable("RELIEVO_TEST_OUTPUT", "."));
    vtkNew<vtkPNGWriter> writer;
    for (const auto& [name, image] : { std::pair("shown.png", shown), { "command.png", command } })
    {
      writer->SetFileName(folder.filePath(name).toStdString().c_str());
      writer->SetInputData(image);
      writer->Write();
    }
  }
  QVERIFY2(different == 0,
    qPrintable(QString("%1: %2 pixels differ, by up to %3; %4")
                 .arg(what)
                 .arg(different)
                 .arg(different > 0 ? MostDifferent(shown, command) : 0)
                 .arg(this->Window->GetTrouble())));
}

//------------------------------------------------------------------------------
QByteArray ViewerTest::AskPython(const char* task)
{
  // Loading VTK takes longer than most pictures: one process runs all programs.
  const char* all = R"(
import relievo._scene.scene
import sys

def say(scene, png):
    words = scene._scene.GetWords()
    print("\n".join(words.GetValue(i) for i in range(words.GetNumberOfValues())))

draw = relievo._scene.scene.Scene.render
for line in sys.stdin:
    task, path = line.strip().split(" ", 1)
    relievo._scene.scene.Scene.render = say if task == "say" else draw
    exec(open(path).read(), {"__name__": "__main__"})
    print("done", flush=True)
)";
  const std::string script =
    viewer::WritePython(this->Window->GetCopiedSettings(), this->Path("python.png"));
  this->WriteText("shown.py", script);
  if (this->Python.state() == QProcess::NotRunning)
  {
    this->Python.start(qEnvironmentVariable("PYTHON"), { "-c", all });
  }
  this->Python.write(QByteArray::fromStdString(task + (" " + this->Path("shown.py")) + "\n"));
  QByteArray said;
  while (!said.endsWith("done\n") && this->Python.waitForReadyRead(600000))
  {
    said += this->Python.readAllStandardOutput();
  }
  if (!said.endsWith("done\n"))
  {
    this->Python.waitForFinished(1000);
    qWarning() << script.c_str() << said << this->Python.readAllStandardError();
    return {};
  }
  return said;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ViewerTest::RunPython()
{
  return this->AskPython("draw").isEmpty() ? nullptr : ReadPNG(this->Path("python.png"));
}

//------------------------------------------------------------------------------
scene::Settings ViewerTest::RunPythonForWords()
{
  std::vector<std::string> words;
  for (const QByteArray& word : this->AskPython("say").split('\n'))
  {
    words.push_back(word.toStdString());
  }
  words.resize(words.size() < 2 ? 0 : words.size() - 2); // without "done" and its end
  return scene::Settings::FromWords(words);
}

//------------------------------------------------------------------------------
int ViewerTest::CountDifferent(vtkImageData* a, vtkImageData* b)
{
  auto* first = a ? vtkUnsignedCharArray::SafeDownCast(a->GetPointData()->GetScalars()) : nullptr;
  auto* second = b ? vtkUnsignedCharArray::SafeDownCast(b->GetPointData()->GetScalars()) : nullptr;
  if (!first || !second || first->GetNumberOfTuples() != second->GetNumberOfTuples() ||
    first->GetNumberOfComponents() != 3 || second->GetNumberOfComponents() != 3 ||
    a->GetDimensions()[0] != b->GetDimensions()[0])
  {
    return -1;
  }
  int different = 0;
  for (vtkIdType pixel = 0; pixel < first->GetNumberOfTuples(); ++pixel)
  {
    different += std::memcmp(first->GetPointer(3 * pixel), second->GetPointer(3 * pixel), 3) != 0;
  }
  return different;
}

//------------------------------------------------------------------------------
int ViewerTest::MostDifferent(vtkImageData* a, vtkImageData* b)
{
  const auto* first = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* second = static_cast<const unsigned char*>(b->GetScalarPointer());
  int most = 0;
  for (vtkIdType i = 0; i < 3 * a->GetNumberOfPoints(); ++i)
  {
    most = std::max(most, std::abs(first[i] - second[i]));
  }
  return most;
}

//------------------------------------------------------------------------------
int Run(QObject& tests, int argc, char* argv[])
{
  vtkRelievoReaderProcess::Start(); // as the program
  QSurfaceFormat::setDefaultFormat(viewer::PictureView::GetFormat());
  QCoreApplication::setOrganizationName("Relievo");
  QCoreApplication::setApplicationName("tests");
  QSettings::setPath(
    QSettings::NativeFormat, QSettings::UserScope, qEnvironmentVariable("RELIEVO_TEST_OUTPUT"));
  QSettings().clear(); // of the run before
  viewer::UseHighDpi();
  viewer::Application application(argc, argv);
  const reading::Messages::Scope scope;
  return QTest::qExec(&tests, argc, argv);
}
}
