// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The program's window: the picture, panels around it, opening and saving.
 */
#ifndef MainWindow_h
#define MainWindow_h

#include "CameraPath.h"
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
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QShortcut;
class QStackedWidget;

namespace reading
{
class ProgressListener;
}

namespace viewer
{
class AxisMarker;
class ComparisonPanel;
class EmptyPage;
class LayerBanner;
class LayerLegend;
class LayersPanel;
class LightHandles;
class LightPanel;
class MessageBar;
class PanelSwitch;
class PathGroup;
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

  /// Shows these settings; files are read in the background. Throws words::UsageError, and changes
  /// nothing, if the command line refuses them.
  void Open(const scene::Settings& settings);

  /// Opens files, or a single session, instead of the displayed ones or `beside` them.
  void OpenFiles(const QStringList& paths, bool beside = false);

  /// Reads the files again; the camera stays.
  void Reload();

  /// Opens the file `step` steps after the last displayed file, by name in its folder, cyclically.
  void OpenNext(int step);

  ///@{
  /// Saves pictures with all samples of soft shadows, with a progress bar; if the user cancels,
  /// nothing is saved. Each throws words::WorkError or words::UsageError.
  void OpenSession(const QString& path);
  void SaveSession(const QString& path);
  void SavePicture(const PictureChoice& choice);
  void CopyPicture();
  void SaveFilm(const PictureChoice& choice);
  void SaveLayers(const LayersChoice& choice);
  ///@}

  /// Exports the scene as glTF, with the camera. Throws words::WorkError or words::UsageError.
  void ExportGltf(const QString& path);

  /// Draws the scene with the size of a baseline or picture, and with the camera that a baseline
  /// records, and shows how it differs from the file. Throws words::WorkError.
  void CompareWith(const QString& path);

  /// Saves the displayed comparison as a page for browsers. Throws words::WorkError.
  void SaveReport(const QString& path);

  /// The present settings with camera and size.
  scene::Settings GetViewSettings();

  /// The settings of a command that draws the present picture: GetViewSettings() without a colour
  /// map and a range if no values give colours.
  scene::Settings GetCopiedSettings();

  /// The views of the camera path; fewer than two make no film.
  std::size_t CountViews() const;

  /// Shows a message, with options replaced by the names of their controls, until the next one.
  /// Errors appear prominently until they are closed or fixed.
  void Say(const QString& said, bool isTrouble = false);

  /// The last error; empty after success.
  QString GetTrouble() const { return this->Trouble; }

  bool IsReading() const { return this->Reader->IsReading(); }

  /// Whether a reader still works, even for an unwanted result.
  bool IsBusy() const { return this->Reader->IsBusy(); }

  /// Restores the window's layout from the last run.
  void RestoreLayout();

Q_SIGNALS:
  /// All requested files have been read, or have failed.
  void ready();

  /// IsBusy() has changed.
  void busyChanged();

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  bool focusNextPrevChild(bool next) override;

private:
  void AddPanels();
  void AddStatus();
  void Connect();
  void ConnectComparison();
  void ConnectPath();
  void Open(const scene::Settings& settings, const QStringList& recent);
  void Follow();
  void ShowNothing();
  void CatchUp();
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
  bool Gather(const QString& ifStopped = "Stopped: nothing was saved.");
  vtkSmartPointer<vtkImageData> Draw();
  vtkSmartPointer<vtkImageData> DrawTransparent();
  void SaySaving();
  void SaySaved(const QString& path);
  void ShowLate();
  void TakeKeys();
  void SetViewSize(const std::string& words);
  void KeepLayout();
  bool HasEdits() const;
  bool LetGoOfEdits();

  Document* Edited;
  PictureView* Shown;
  Loader* Reader;
  PathGroup* Path;
  LightPanel* Light;
  LayersPanel* Layers;
  ReportPanel* Report;
  PanelSwitch* Panels;
  ComparisonPanel* Comparison;
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
  std::unique_ptr<reading::ProgressListener> Teller;
  QProgressBar* Bar;
  QPushButton* Cancel;
  QString Trouble;
  bool OfFile = false;  // whether the error is a file's: other edits do not clear it
  scene::Settings Good; // displayed
  scene::Settings Safe; // last opened or saved
  bool IsSafe = false;  // the settings being read become Safe
  std::vector<scene::CameraKey> SafeKeys; // of the camera path, last opened or saved
  std::optional<std::vector<scene::CameraKey>> AskedKeys; // of the session being read
  scene::Settings Asked;                                  // being read
  std::vector<std::string> BeingRead;                     // files of the reading in progress
  scene::Settings Meanwhile; // displayed settings with all changes since the reading began
  bool SetMeanwhile = false;
  bool PointsOnly = false; // only points are being read, and the scene stays
  std::string ReadingKey;  // of the displayed or requested files; empty: opened by the user
  scene::Settings Place;   // camera and size for the files being read
  std::map<std::vector<std::string>, scene::Settings> Cameras; // by displayed files
  scene::Settings Colors;                                      // by an array, of the previous file
  QString Dropped;                                             // by opening the file being read
  bool HasShown = false;                                       // any file
  bool KeepCamera = false;                                     // instead of Place
  QString ComparedWith;                                        // file of the displayed comparison
  scene::Settings Compared; // of the scene in the displayed comparison
  bool Behind = false;      // edits wait for a sample
  bool Saving = false;
  bool Filming = false;        // a film is saved, of pictures one after another
  std::optional<QString> Late; // result of a reading that ended while a picture was saved
  QStringList Opening;         // entries for the recent files after reading
  Probe Reading;
  int Samples = 0;          // in the complete picture
  int SamplesLeft = 0;      // still missing
  bool FirstIsSlow = false; // a thread drew, or draws, the picture's first sample
  QElapsedTimer Smoothed;
  QTimer Pause, Waiting, Quiet, Later;
  int Pointed[2] = { -1, -1 };
  scene::Settings Probed; // settings of the picture that the values belong to
};
}

#endif
