// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The picture of a scene in a render window, kept as `relievo render` would draw it: only what
 * changed is set anew.
 */
#ifndef Picture_h
#define Picture_h

#include "BareScene.h"
#include "Frame.h"
#include "Options.h"
#include "Settings.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoPass;

namespace viewer
{
///@{
/// What of the settings a reader needs: when this changes, files are read again. The scene's part
/// is all but the points of lamps, fog and markers.
std::string GetReadingKey(const Settings& settings);
std::string GetSceneKey(const Settings& settings);
///@}

class Picture
{
public:
  explicit Picture(vtkRenderWindow* window);
  ~Picture();
  Picture(const Picture&) = delete;
  void operator=(const Picture&) = delete;

  /// Shows another scene. The camera stays if `keepCamera`, else it is fitted or as the settings
  /// say. Throws what Update throws; what was shown then still is.
  void Show(const cli::Scene& scene, const cli::FramePoints& points, const Settings& settings,
    bool keepCamera);

  /// Other points in the same scene. Throws what Update throws; the points are then as before.
  void ShowPoints(const cli::FramePoints& points, const Settings& settings);

  /// Nothing is shown.
  void Clear();

  bool IsEmpty() const { return !this->Now.Renderer; }

  /// Throws cli::WorkError if it is empty.
  void CheckShown(const std::string& what) const;

  /// The settings of the scene that is shown, or of what is given to it. Throws cli::UsageError or
  /// cli::WorkError; the picture is then as it was before.
  void Update(const Settings& settings);

  /// Whether an update to these settings reads no file.
  bool IsDressedAlike(const Settings& settings) const;

  /// Fits the camera to the scene.
  void ResetCamera();

  /// Looks along a direction at what is shown.
  void LookAlong(const std::array<double, 3>& direction, const std::array<double, 3>& up);

  /// What is in the middle keeps its size.
  void SetParallel(bool on);
  bool IsParallel() const;

  /// With the camera and the window's size, as words of the command line, where there is a picture.
  Settings GetView(const Settings& settings) const;

  /// Renders, every sample of every light gathered, and returns the window's pixels.
  vtkSmartPointer<vtkImageData> Grab();

  vtkRenderer* GetRenderer() { return this->Now.Renderer; }
  vtkRelievoPass* GetFrame();
  const BareScene& GetBare() const { return this->Now.Bare; }
  const cli::FramePoints& GetPoints() const { return this->Now.Points; }

private:
  void Apply(const Settings& settings, bool keepCamera);
  void SetFrame(const cli::RenderOptions& options);
  void FitClipping();

  // All that belongs to one scene.
  struct Contents
  {
    BareScene Bare;
    cli::FramePoints Points;
    vtkSmartPointer<vtkRenderer> Renderer;
    Settings Shown;
    cli::RenderOptions Options;
    std::string Dress = "\n", Surface = "\n"; // the words it was made of; at first like no words
    double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
    std::array<int, 2> BarSize{}; // of the window that the scalar bar was made for
  };
  void Remove(const Contents& contents);
  bool IsBarFitted() const;

  vtkRenderWindow* Window;
  unsigned long Observer;
  Contents Now;
};
}

#endif
