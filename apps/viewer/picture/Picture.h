// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The picture of a scene in a render window, equal to that of `relievo render`, with incremental
 * updates.
 */
#ifndef Picture_h
#define Picture_h

#include "CameraOptions.h"
#include "StyledScene.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoPass;

namespace reading
{
class ProgressListener;
}

namespace viewer
{
class Picture
{
public:
  explicit Picture(vtkRenderWindow* window);
  ~Picture();
  Picture(const Picture&) = delete;
  void operator=(const Picture&) = delete;

  /// Receives the progress of long work, such as reading an environment, during Show and Update.
  void SetListener(reading::ProgressListener* listener) { this->Listener = listener; }

  /// Shows another scene. The camera stays if `keepCamera`, otherwise it is fitted or set by the
  /// settings. Throws like Update; the previous scene then stays.
  void Show(const scene::Scene& scene, const scene::FramePoints& points,
    const scene::Settings& settings, bool keepCamera);

  /// Replaces the points in the scene. Throws like Update; the previous points then stay.
  void ShowPoints(const scene::FramePoints& points, const scene::Settings& settings);

  /// Removes the scene.
  void Clear();

  bool IsEmpty() const { return !this->GetRenderer(); }

  bool HasVolume() const;

  /// Throws words::WorkError if the picture is empty.
  void CheckShown(const std::string& what) const;

  /// Changes the settings of the displayed or given scene. Throws words::UsageError or
  /// words::WorkError; the picture then stays unchanged.
  void Update(const scene::Settings& settings);

  /// Whether an update to these settings would read no file.
  bool HasSurfaceOf(const scene::Settings& settings) const;

  /// Fits the camera to the scene.
  void ResetCamera();

  /// Call after a change of the view's aspect ratio: the camera moves back as far as needed to show
  /// the same part of the scene, and forward again, until something else moves it.
  void KeepInView(double before, double now);

  /// Looks at the scene along a direction.
  void LookAlong(const std::array<double, 3>& direction, const std::array<double, 3>& up);

  /// Places the camera.
  void Place(const look::CameraPlace& view);

  ///@{
  /// Steps of the camera: degrees to the right and upwards about the focal point; shares of the
  /// view's height; a factor of the size.
  void Turn(double right, double up);
  void Move(double right, double up);
  void Zoom(double factor);
  ///@}

  /// Objects at the centre keep their size.
  void SetParallel(bool on);
  bool IsParallel() const;

  /// The settings with the camera and the window's size, as command-line words, if there is a
  /// picture.
  scene::Settings GetView(const scene::Settings& settings) const;

  /// Renders with all light samples, and returns the window's pixels.
  vtkSmartPointer<vtkImageData> Grab();

  /// Renders with all light samples, and returns the frame as a baseline, portable or not. Throws
  /// words::WorkError.
  vtkSmartPointer<vtkImageData> Capture(bool portable);

  /// While one lives, the picture has another camera.
  class OtherCamera
  {
  public:
    OtherCamera(Picture* picture, const look::CameraChoice& choice);
    ~OtherCamera();
    OtherCamera(const OtherCamera&) = delete;
    void operator=(const OtherCamera&) = delete;

  private:
    Picture* Shown;
    vtkSmartPointer<vtkCamera> Camera, Before;
  };

  vtkRenderer* GetRenderer() const { return this->Now.Scene.GetRenderer(); }
  vtkRelievoPass* GetFrame() const { return this->Now.Scene.GetFrame(); }
  const scene::StyledScene& GetScene() const { return this->Now.Scene; }

private:
  void FitClipping();
  void ApplyStyle(const scene::Settings& settings, bool keepCamera);

  // State of one scene.
  struct Contents
  {
    scene::StyledScene Scene;
    scene::Settings Shown;
  };
  void Remove(const Contents& contents);

  // The camera's pose, and half the height of a parallel view.
  struct Stand
  {
    look::CameraPlace Place;
    double Scale = 0.0;
    double Angle = 0.0;
    double Aspect = 0.0; // of the view
  };
  Stand GetStand(double aspect) const;

  vtkRenderWindow* Window;
  reading::ProgressListener* Listener = nullptr;
  unsigned long Observer;
  Contents Now;
  std::optional<look::CameraChoice> Other; // of OtherCamera
  Stand Chosen, Fitted; // the view before its first change of shape, and the resulting view
};
}

#endif
