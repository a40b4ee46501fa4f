// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures, layers and sessions that are saved.
#include "MainWindow.h"

#include "LightPanel.h"
#include "Messages.h"
#include "Outputs.h"
#include "PictureView.h"
#include "RecentFiles.h"
#include "SessionFile.h"
#include "SunGroup.h"
#include "TimeBar.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoPass.h"

#include <QApplication>
#include <QFileInfo>
#include <QProgressDialog>

#include <algorithm>

namespace viewer
{
namespace
{
constexpr int Patience = 500; // milliseconds until the user is told
constexpr int MostIdle = 10;

// Whole or not at all.
template <typename Writer>
void Write(const QString& path, vtkImageData* image)
{
  const std::string place = path.toStdString();
  cli::Outputs outputs;
  outputs.Add("Save", place, {});
  vtkNew<Writer> writer;
  writer->SetInputData(image);
  writer->SetFileName(outputs.Temporary(place).c_str());
  writer->Write();
  cli::Messages::Check(place, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
  outputs.Commit();
}
}

//------------------------------------------------------------------------------
Settings MainWindow::GetViewSettings()
{
  return this->Shown->GetPicture().GetView(this->Good);
}

//------------------------------------------------------------------------------
// Every sample of soft shadows, a few a frame, so that the user sees how far it is and may end it.
// Nothing else is done meanwhile: no other picture may be saved than the one that was asked for.
bool MainWindow::Gather()
{
  vtkRelievoPass* frame = this->Shown->GetPicture().GetFrame();
  if (!frame || this->Saving)
  {
    return !this->Saving;
  }
  this->Time->Stop();
  this->Saving = true;
  QProgressDialog dialog("Gathering soft shadows", "Cancel", 0, 0, this);
  dialog.setWindowModality(Qt::ApplicationModal);
  dialog.setMinimumDuration(Patience);
  dialog.setAutoReset(false);
  this->Shown->renderWindow()->Render();
  const int all = frame->GetSamplesLeft();
  dialog.setMaximum(all);
  int idle = 0; // frames that brought nothing, as where something moves by itself
  for (int left = all; left > 0 && idle < MostIdle && !dialog.wasCanceled();)
  {
    idle = frame->GetSamplesLeft() < left ? 0 : idle + 1;
    left = frame->GetSamplesLeft();
    dialog.setValue(std::max(0, all - left));
    QApplication::processEvents();
    this->Shown->renderWindow()->Render();
  }
  const bool good = !dialog.wasCanceled();
  this->Saving = false;
  if (!good)
  {
    this->Say("Stopped: nothing was saved.");
  }
  this->Later.start(0);
  return good;
}

//------------------------------------------------------------------------------
// What has been read while a picture was saved.
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
void MainWindow::SaveSession(const QString& path)
{
  const SunGroup* sun = this->Light->GetSun();
  viewer::SaveSession(path, { this->GetViewSettings(), sun->GetTime(), sun->IsByTime() });
  this->Recent->Add(QFileInfo(path).absoluteFilePath());
  this->Say("Saved " + path);
}

//------------------------------------------------------------------------------
void MainWindow::SavePicture(const QString& path)
{
  this->Shown->GetPicture().CheckShown("Save picture");
  if (!this->Gather())
  {
    return;
  }
  Write<vtkPNGWriter>(path, this->Shown->GetPicture().Grab());
  this->Say("Saved " + path);
}

//------------------------------------------------------------------------------
void MainWindow::SaveLayers(const QString& path, const std::vector<std::string>& layers)
{
  this->Shown->GetPicture().CheckShown("Save layers");
  if (!this->Gather())
  {
    return;
  }
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(this->Shown->GetPicture().GetRenderer());
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer);
  }
  source->Update();
  cli::Messages::Check(path.toStdString(), source->GetErrorCode() != 0);
  Write<vtkRelievoEXRWriter>(path, source->GetOutput());
  this->Say("Saved " + path);
}
}
