// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The program's window: the picture, panels around it, files in and out.
 */
#ifndef MainWindow_h
#define MainWindow_h

#include "Document.h"
#include "Loader.h"
#include "Probe.h"
#include "SaveDialog.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;
class QShortcut;
class QStackedWidget;

namespace viewer
{
class AxisMarker;
class EmptyPage;
class LayerBanner;
class LayerLegend;
class LayersPanel;
class LightHandles;
class LightPanel;
class MessageBar;
class WorkTeller;
class RecentFiles;
class ReportPanel;
class PictureView;
class TimeBar;

class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  Document* GetDocument() { return this->Edited; }
  PictureView* GetView() { return this->Shown; }
  AxisMarker* GetAxes() { return this->Axes; }
  LightHandles* GetLightHandles() { return this->Handles; }

  /// Shows these settings; files are read in the background. Throws scene::UsageError, and changes
  /// nothing, for those that the command line refuses.
  void Open(const scene::Settings& settings);

  /// Files, of which a session is opened alone, instead of those shown or `beside` them.
  void OpenFiles(const QStringList& paths, bool beside = false);

  /// The files are read again; the camera stays.
  void Reload();

  /// The file that many steps on in the folder of the last file shown, by name and around.
  void OpenNext(int step);

  ///@{
  /// Pictures with every sample of soft shadows: the user sees how far it is, and may end it, which
  /// saves nothing. Each throws scene::WorkError or scene::UsageError.
  void OpenSession(const QString& path);
  void SaveSession(const QString& path);
  void SavePicture(const PictureChoice& choice);
  void SaveLayers(const LayersChoice& choice);
  ///@}

  /// What is shown with its camera and size.
  scene::Settings GetViewSettings();

  /// A line that stays until the next, options by the names of their controls. What went wrong is
  /// shown where it cannot be overlooked, until it is closed or mended.
  void Say(const QString& said, bool isTrouble = false);

  /// What went wrong last; empty if all went well since.
  QString GetTrouble() const { return this->Trouble; }

  bool IsReading() const { return this->Reader->IsReading(); }

  /// Whether a reader still works, be it on what nobody waits for.
  bool IsBusy() const { return this->Reader->IsBusy(); }

  /// The window as it was when the program ended.
  void RestoreLayout();

Q_SIGNALS:
  /// All that was asked for has been read, or has failed.
  void ready();

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  void AddPanels();
  void AddStatus();
  void Connect();
  void Open(const scene::Settings& settings, const QStringList& recent);
  void Follow();
  void ShowNothing();
  void Update();
  void ChangeShown(const scene::Settings& settings);
  void Read();
  void Begin();
  void ShowReading();
  void OnProgress(const QString& what, int percent);
  void StopReading();
  void GiveUp();
  void OnRead(const QString& trouble);
  QString ShowRead();
  void EndReading();
  void Remember();
  void KeepView();
  bool KeepColors(const scene::Settings& colors, const Facts& facts);
  void TellDropped();
  void OnDrawn();
  void ShowSmoothing();
  void LookFrom(int end);
  void PointAt(int x, int y);
  void WaitForPlace(const QString& hint);
  void PlaceLight(int x, int y);
  void ShowProbe();
  void DropValues();
  void TellMessages();
  void SayOfFile(const QString& why);
  void Mend();
  bool Gather();
  vtkSmartPointer<vtkImageData> Draw();
  vtkSmartPointer<vtkImageData> DrawTransparent();
  void SaySaved(const QString& path);
  void ShowLate();
  void SetViewSize(const std::string& words);
  void KeepLayout();
  bool HasEdits() const;
  bool LetGoOfEdits();

  Document* Edited;
  PictureView* Shown;
  Loader* Reader;
  LightPanel* Light;
  LayersPanel* Layers;
  ReportPanel* Report;
  TimeBar* Time;
  RecentFiles* Recent;
  QStackedWidget* Pages;
  EmptyPage* Empty;
  AxisMarker* Axes;
  LayerBanner* Banner;
  LayerLegend* Legend;
  LightHandles* Handles;
  MessageBar *Message, *Hint;
  QShortcut* StopPlacing;
  QLabel *Words, *Values, *Smoothing;
  std::unique_ptr<WorkTeller> Teller;
  QProgressBar* Bar;
  QPushButton* Cancel;
  QString Trouble;
  bool OfFile = false;                // is what is shown as wrong: another edit does not mend it
  scene::Settings Good;               // what is shown
  scene::Settings Safe;               // the settings opened or saved last
  bool IsSafe = false;                // the settings being read become Safe
  scene::Settings Asked;              // what is being read
  std::vector<std::string> BeingRead; // files that the last reading was begun for
  scene::Settings Meanwhile; // what is shown, with all that was set since the reading began
  bool SetMeanwhile = false;
  bool PointsOnly = false; // is being read, and the scene stays
  std::string ReadingKey;  // of what is shown, or being read; empty: what the user opens now
  scene::Settings Place;   // camera and size of what is being read
  std::map<std::vector<std::string>, scene::Settings> Cameras; // of files that were shown
  scene::Settings Colors;  // by an array, of the file before the one that is being read
  QString Dropped;         // by opening what is being read
  bool HasShown = false;   // a file
  bool KeepCamera = false; // instead
  bool Saving = false;
  std::optional<QString> Late; // what a reading came to while a picture was saved
  QStringList Opening;         // what the list of recent files gets when it has been read
  Probe Reading;
  int Samples = 0;     // that the picture is to have
  int SamplesLeft = 0; // of them
  QElapsedTimer Smoothed;
  QTimer Pause, Waiting, Quiet, Later;
  int Pointed[2] = { -1, -1 };
  scene::Settings Probed; // what the picture shows that the values are of
};
}

#endif
