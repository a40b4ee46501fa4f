// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The window's saving: sessions, pictures and layers, with all samples.
#include "MainWindow.h"

#include "Frame.h"
#include "LightPanel.h"
#include "Messages.h"
#include "MotionOptions.h"
#include "Outputs.h"
#include "PathGroup.h"
#include "PictureView.h"
#include "RecentFiles.h"
#include "SaveDialog.h"
#include "Scripts.h"
#include "SessionFile.h"
#include "StyledScene.h"
#include "TimeBar.h"
#include "Transparency.h"
#include "VideoFile.h"
#include "WriteOutputs.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QScopeGuard>
#include <QStatusBar>

#include <algorithm>

namespace viewer
{
namespace
{
constexpr int SavePatience = 500; // milliseconds until the user is told
constexpr int MostIdle = 10;

bool AreEqual(const std::vector<scene::CameraKey>& a, const std::vector<scene::CameraKey>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const scene::CameraKey& one, const scene::CameraKey& other) {
      return one.Time == other.Time && one.Place.Position == other.Place.Position &&
        one.Place.FocalPoint == other.Place.FocalPoint && one.Place.ViewUp == other.Place.ViewUp;
    });
}

// Writes a file completely or not at all, and over none of the scene's files.
template <typename Writer>
void Write(const QString& path, vtkImageData* image, const scene::StyledScene& scene)
{
  const std::string place = path.toStdString();
  reading::Outputs outputs;
  outputs.Add("Save", place, scene::GetInputs(scene.GetOptions()));
  vtkNew<Writer> writer;
  writer->SetInputData(image);
  writer->SetFileName(outputs.Temporary(place).c_str());
  writer->Write();
  reading::Messages::Check(
    place, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
  outputs.Commit();
}

// While one lives, frames make these layers, with the samples that they need.
class AskedLayers
{
public:
  AskedLayers(const Picture& picture, const std::vector<std::string>& layers)
    : Frame(picture.GetFrame())
  {
    for (const std::string& name : layers)
    {
      if (this->Frame &&
        name != vtkRelievoLayerCatalogue::GetPicture().Name && // which is drawn anyway
        !this->Frame->IsLayerRequested(name))
      {
        this->Frame->RequestLayer(name);
        this->Layers.push_back(name);
      }
    }
  }

  ~AskedLayers()
  {
    for (const std::string& name : this->Layers)
    {
      this->Frame->ReleaseLayer(name);
    }
  }

  AskedLayers(const AskedLayers&) = delete;
  void operator=(const AskedLayers&) = delete;

private:
  vtkRelievoPass* Frame;
  std::vector<std::string> Layers;
};
}

//------------------------------------------------------------------------------
// Draws all samples, a few per frame, with a progress bar, so that the user can cancel. Nothing
// else may change meanwhile: the saved picture must be the requested one.
bool MainWindow::Gather(const QString& ifStopped)
{
  vtkRelievoPass* frame = this->Shown->GetPicture().GetFrame();
  if (!frame || this->Saving)
  {
    return !this->Saving;
  }
  this->Time->Stop();
  this->Saving = true;
  this->Shown->SetHurried(true); // draws samples like the command
  QProgressDialog dialog("Gathering the samples of the picture", "Cancel", 0, 0, this);
  dialog.setWindowModality(Qt::ApplicationModal);
  dialog.setMinimumDuration(SavePatience);
  dialog.setAutoReset(false);
  this->Shown->renderWindow()->Render();
  dialog.setMaximum(100);
  int idle = 0; // frames without progress, as in a picture that never rests
  int done = 0;
  for (int left = frame->GetSamplesLeft(); left > 0 && idle < MostIdle && !dialog.wasCanceled();)
  {
    const int now = frame->GetSamplesLeft();
    idle = now < left ? 0 : idle + 1;
    done += std::max(0, left - now);
    left = now;
    // Stages may add samples; progress never goes back.
    dialog.setValue(std::max(dialog.value(), 100 * done / std::max(1, done + left)));
    QApplication::processEvents();
    this->Shown->renderWindow()->Render();
  }
  const bool good = !dialog.wasCanceled();
  this->Shown->SetHurried(false);
  this->Saving = false;
  if (!good)
  {
    this->Say(ifStopped);
  }
  this->Later.start(0);
  return good;
}

//------------------------------------------------------------------------------
// Null if the user cancelled.
vtkSmartPointer<vtkImageData> MainWindow::Draw()
{
  return this->Gather() ? this->Shown->GetPicture().Grab() : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MainWindow::DrawTransparent()
{
  vtkSmartPointer<vtkImageData> over[2]; // over black and over white
  for (int i = 0; i < 2; ++i)
  {
    const scene::Backdrop backdrop(this->Shown->GetPicture().GetScene().GetScene(), i);
    over[i] = this->Draw();
    if (!over[i])
    {
      return nullptr;
    }
  }
  return scene::MakeTransparent(over[0], over[1]);
}

//------------------------------------------------------------------------------
// Shows files whose reading ended while a picture was saved.
void MainWindow::ShowLate()
{
  if (this->Late)
  {
    const QString trouble = *this->Late;
    this->Late.reset();
    this->OnRead(trouble);
  }
}

//------------------------------------------------------------------------------
// At once: the first picture of another size may take long, and nothing is painted meanwhile.
void MainWindow::SaySaving()
{
  this->Say(QString("Saving") + QChar(0x2026));
  this->statusBar()->repaint();
}

//------------------------------------------------------------------------------
void MainWindow::SaySaved(const QString& path)
{
  this->Mend();
  this->Say("Saved " + path);
}

//------------------------------------------------------------------------------
void MainWindow::SaveSession(const QString& path)
{
  viewer::SaveSession(path, { this->GetViewSettings(), this->Path->GetKeys() });
  this->Safe = this->Edited->Get();
  this->SafeKeys = this->Path->GetKeys();
  this->Recent->Add(QFileInfo(path).absoluteFilePath());
  this->SaySaved(path);
}

//------------------------------------------------------------------------------
// Whether there are unsaved settings or views of the camera path. Opening files is no edit: undo
// restores settings that it dropped.
bool MainWindow::HasEdits() const
{
  const auto getEdits = [](scene::Settings settings) {
    settings.Files.clear();
    settings.Remove("--time");
    return settings;
  };
  return !this->Shown->IsEmpty() &&
    (getEdits(this->Edited->Get()) != getEdits(this->Safe) ||
      !AreEqual(this->Path->GetKeys(), this->SafeKeys));
}

//------------------------------------------------------------------------------
// Whether the window may close: edits are saved or discarded.
bool MainWindow::LetGoOfEdits()
{
  if (!this->HasEdits())
  {
    return true;
  }
  const auto answer = QMessageBox::question(this, "Quit", "Save changes as a session?",
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save)
  {
    this->findChild<QAction*>("saveSession")->trigger();
  }
  return answer == QMessageBox::Save ? !this->HasEdits() : answer == QMessageBox::Discard;
}

//------------------------------------------------------------------------------
void MainWindow::SavePicture(const PictureChoice& choice)
{
  this->Shown->GetPicture().CheckShown("Save picture");
  this->SaySaving();
  const PictureView::OtherSize sized(this->Shown, choice.Size);
  if (const auto picture = choice.Transparent ? this->DrawTransparent() : this->Draw())
  {
    Write<vtkPNGWriter>(choice.Path, picture, this->Shown->GetPicture().GetScene());
    this->SaySaved(choice.Path);
  }
}

//------------------------------------------------------------------------------
void MainWindow::ConnectPath()
{
  QObject::connect(this->Path, &PathGroup::addWanted, this, [this] {
    if (!this->Shown->IsEmpty())
    {
      this->Path->Add(look::GetPlace(this->Shown->GetPicture().GetRenderer()->GetActiveCamera()));
    }
  });
  QObject::connect(this->Path, &PathGroup::viewWanted, this, [this](const look::CameraPlace& view) {
    this->Shown->Change([view](Picture& picture) { picture.Place(view); });
  });
  QObject::connect(
    this->Path, &PathGroup::refused, this, [this](const QString& why) { this->Say(why, true); });
  QObject::connect(this->Path, &PathGroup::copyWanted, this, [this] {
    try
    {
      if (!this->Shown->IsEmpty())
      {
        scene::CameraPath(this->Path->GetKeys(), "Camera path")
          .GetTimes(scene::MotionChoice().FramesPerSecond); // throws if no film can be drawn
        QApplication::clipboard()->setText(QString::fromStdString(
          WriteFilmCommand(this->GetCopiedSettings(), this->Path->GetKeys(), "film.mp4")));
        this->Say("Copied: the command that makes this film");
      }
    }
    catch (const std::exception& error)
    {
      this->Say(QString::fromStdString(error.what()), true);
    }
  });
  QObject::connect(this->Path, &PathGroup::filmWanted, this, [this] {
    try
    {
      const int* size = this->Shown->renderWindow()->GetSize();
      if (const auto choice = AskFilm(this, { size[0], size[1] }))
      {
        this->SaveFilm(*choice);
      }
    }
    catch (const std::exception& error)
    {
      this->Say(QString::fromStdString(error.what()), true);
    }
  });
}

//------------------------------------------------------------------------------
void MainWindow::SaveFilm(const PictureChoice& choice)
{
  this->Shown->GetPicture().CheckShown("Save film");
  if (!scene::VideoFile::HasProgram())
  {
    throw words::WorkError("Save film: the program ffmpeg is not installed");
  }
  const scene::CameraPath path(this->Path->GetKeys(), "Camera path");
  const double rate = scene::MotionChoice().FramesPerSecond;
  const std::vector<double> times = path.GetTimes(rate);
  const std::string place = choice.Path.toStdString();
  reading::Outputs outputs;
  outputs.Add("Save", place, scene::GetInputs(this->Shown->GetPicture().GetScene().GetOptions()));
  const look::CameraPlace before =
    look::GetPlace(this->Shown->GetPicture().GetRenderer()->GetActiveCamera());
  const PictureView::OtherSize sized(this->Shown, choice.Size);
  this->Filming = true;
  const auto back = qScopeGuard([&] {
    this->Shown->GetPicture().Place(before);
    this->Filming = false;
    this->Later.start(0);
  });
  scene::VideoFile film(
    outputs.Temporary(place), place, { choice.Size.width(), choice.Size.height() }, rate);
  QProgressDialog dialog("Drawing the film", "Cancel", 0, static_cast<int>(times.size()), this);
  dialog.setWindowModality(Qt::ApplicationModal);
  dialog.setMinimumDuration(0);
  int drawn = 0;
  for (const double time : times)
  {
    this->Shown->GetPicture().Place(path.Find(time));
    const auto frame = this->Draw();
    if (!frame || dialog.wasCanceled())
    {
      this->Say("Stopped: nothing was saved.");
      return;
    }
    film.Add(frame);
    dialog.setValue(++drawn); // handles events
  }
  film.Finish();
  outputs.Commit();
  this->SaySaved(choice.Path);
}

//------------------------------------------------------------------------------
void MainWindow::CopyPicture()
{
  this->Shown->GetPicture().CheckShown("Copy picture");
  if (const auto picture = this->Draw())
  {
    const int* size = picture->GetDimensions();
    const auto* pixels = static_cast<const unsigned char*>(picture->GetScalarPointer());
    const QImage image(pixels, size[0], size[1], 3 * size[0], QImage::Format_RGB888);
    QApplication::clipboard()->setImage(image.mirrored()); // a copy, from the top row
    this->Say("Copied: the picture");
  }
}

//------------------------------------------------------------------------------
void MainWindow::SaveLayers(const LayersChoice& choice)
{
  this->Shown->GetPicture().CheckShown("Save layers");
  this->SaySaving();
  const PictureView::OtherSize sized(this->Shown, choice.Size);
  const AskedLayers asked(this->Shown->GetPicture(), choice.Layers);
  if (!this->Gather())
  {
    return;
  }
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(this->Shown->GetPicture().GetRenderer());
  for (const std::string& layer : choice.Layers)
  {
    source->AddLayer(layer);
  }
  source->Update();
  reading::Messages::Check(choice.Path.toStdString(), source->GetErrorCode() != 0);
  Write<vtkRelievoEXRWriter>(
    choice.Path, source->GetOutput(), this->Shown->GetPicture().GetScene());
  this->SaySaved(choice.Path);
}

//------------------------------------------------------------------------------
void MainWindow::ExportGltf(const QString& path)
{
  Picture& picture = this->Shown->GetPicture();
  picture.CheckShown("Export glTF");
  scene::WriteGltf(picture.GetScene(), path.toStdString());
  QString saved = path;
  for (const std::string& note : reading::Messages::TakeNotes())
  {
    saved += "; " + QString::fromStdString(note);
  }
  this->SaySaved(saved);
  this->Shown->Draw();
}
}
