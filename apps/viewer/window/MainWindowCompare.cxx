// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The window's comparisons of the scene with a baseline or a picture.
#include "MainWindow.h"

#include "Baseline.h"
#include "ComparisonPanel.h"
#include "Errors.h"
#include "LightPanel.h"
#include "LightsGroup.h"
#include "Messages.h"
#include "Outputs.h"
#include "PictureView.h"
#include "Progress.h"
#include "SaveDialog.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoBaseline.h"
#include "vtkRelievoComparisonReport.h"
#include "vtkRelievoFrameComparison.h"
#include "vtkRelievoLayerCatalogue.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QScopeGuard>

#include <exception>
#include <fstream>
#include <functional>
#include <optional>

namespace viewer
{
//------------------------------------------------------------------------------
void MainWindow::ConnectComparison()
{
  const auto attempt = [this](const std::function<void()>& work) {
    try
    {
      work();
    }
    catch (const std::exception& error)
    {
      this->Say(QString::fromStdString(error.what()), true);
    }
  };
  QObject::connect(this->Comparison, &ComparisonPanel::againWanted, this,
    [this, attempt] { attempt([this] { this->CompareWith(this->ComparedWith); }); });
  QObject::connect(this->Comparison, &ComparisonPanel::reportWanted, this, [this, attempt] {
    const QString path = AskPlace(this, "Save report", ".html");
    if (!path.isEmpty())
    {
      attempt([this, path] { this->SaveReport(path); });
    }
  });
  QObject::connect(this->Comparison, &ComparisonPanel::lightChosen, this->Light->GetLights(),
    &LightsGroup::SelectNamed);
  QObject::connect(this->Edited, &Document::changed, this->Comparison,
    [this] { this->Comparison->SetOutdated(this->Edited->Get() != this->Compared); });
}

//------------------------------------------------------------------------------
void MainWindow::CompareWith(const QString& path)
{
  Picture& picture = this->Shown->GetPicture();
  picture.CheckShown("Compare with");
  const std::string place = path.toStdString();
  const auto comparison = vtkSmartPointer<vtkRelievoFrameComparison>::New();
  reading::Messages::Check(place, !comparison->ReadBaseline(place.c_str()));
  const int* size = comparison->GetBaseline()->GetDimensions();
  const std::optional<scene::Settings> recorded =
    scene::GetRecorded(comparison->GetBaseline(), place);
  {
    const PictureView::OtherSize sized(this->Shown, { size[0], size[1] });
    std::optional<Picture::OtherCamera> camera;
    if (recorded)
    {
      camera.emplace(&picture, recorded->Parse().View);
    }
    if (!this->Gather("Stopped: nothing was compared."))
    {
      return;
    }
    const auto end = qScopeGuard([this] { this->Begin(); }); // hides the progress bar
    reading::Progress progress(this->Teller.get());
    progress.Begin("comparing with " + QFileInfo(path).fileName().toStdString());
    // A baseline has one sample per pixel; a file of a picture alone has those of the settings.
    vtkImageData* baseline = comparison->GetBaseline();
    const std::string& color = vtkRelievoLayerCatalogue::GetPicture().Name;
    const bool isPicture = baseline->GetPointData()->GetNumberOfArrays() == 1 &&
      (!path.endsWith(".exr", Qt::CaseInsensitive) ||
        baseline->GetPointData()->HasArray(color.c_str()));
    comparison->SetFrame(
      isPicture ? picture.Grab() : picture.Capture(vtkRelievoBaseline::IsPortable(baseline)));
    reading::Messages::Check(place, !comparison->Compare());
  }
  this->ComparedWith = path;
  this->Compared = this->Good;
  this->Comparison->Show(comparison,
    QString("With %1: %2 pixels, %3.")
      .arg(QFileInfo(path).fileName(),
        QString("%1 %2 %3").arg(size[0]).arg(QChar(0xd7)).arg(size[1]),
        recorded ? "drawn with the size and the camera of the baseline"
                 : "drawn with its size and the camera of the view"));
  auto* dock = this->findChild<QDockWidget*>("comparison");
  dock->show();
  dock->raise();
  this->Mend();
  this->Say("Compared with " + path);
}

//------------------------------------------------------------------------------
void MainWindow::SaveReport(const QString& path)
{
  vtkRelievoFrameComparison* comparison = this->Comparison->GetComparison();
  if (!comparison)
  {
    throw words::WorkError("Save report: nothing is compared; compare with a file first");
  }
  vtkNew<vtkRelievoComparisonReport> report;
  report->Add(
    (QFileInfo(this->ComparedWith).fileName() + ", " + this->windowTitle()).toUtf8(), comparison);
  const std::string place = path.toStdString();
  reading::Outputs outputs;
  outputs.Add("Save report", place, { this->ComparedWith.toStdString() });
  std::ofstream file(outputs.Temporary(place), std::ios::binary);
  file << report->GetHTML();
  file.close();
  reading::Messages::Check(place, !file, "cannot be written; is the disk full?");
  outputs.Commit();
  this->SaySaved(path);
}
}
