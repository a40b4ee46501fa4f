// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The picture of a scene in a render window, kept as `relievo render` would draw it: only what
 * changed is set anew.
 */
#ifndef Picture_h
#define Picture_h

#include "DressedScene.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoPass;

namespace scene
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

  /// Is told of work that takes long, such as reading an environment, while Show and Update do it.
  void SetListener(scene::ProgressListener* listener) { this->Listener = listener; }

  /// Shows another scene. The camera stays if `keepCamera`, else it is fitted or as the settings
  /// say. Throws what Update throws; what was shown then still is.
  void Show(const scene::Scene& scene, const scene::FramePoints& points,
    const scene::Settings& settings, bool keepCamera);

  /// Other points in the same scene. Throws what Update throws; the points are then as before.
  void ShowPoints(const scene::FramePoints& points, const scene::Settings& settings);

  /// Nothing is shown.
  void Clear();

  bool IsEmpty() const { return !this->GetRenderer(); }

  /// Throws scene::WorkError if it is empty.
  void CheckShown(const std::string& what) const;

  /// The settings of the scene that is shown, or of what is given to it. Throws scene::UsageError
  /// or scene::WorkError; the picture is then as it was before.
  void Update(const scene::Settings& settings);

  /// Whether an update to these settings reads no file.
  bool IsDressedAlike(const scene::Settings& settings) const;

  /// Fits the camera to the scene.
  void ResetCamera();

  /// The view's width over its height has become another: the camera steps back as far as is needed
  /// to see the same part of the scene, and forth again, until something else moves it.
  void KeepInView(double before, double now);

  /// Looks along a direction at what is shown.
  void LookAlong(const std::array<double, 3>& direction, const std::array<double, 3>& up);

  /// What is in the middle keeps its size.
  void SetParallel(bool on);
  bool IsParallel() const;

  /// With the camera and the window's size, as words of the command line, where there is a picture.
  scene::Settings GetView(const scene::Settings& settings) const;

  /// Renders, every sample of every light gathered, and returns the window's pixels.
  vtkSmartPointer<vtkImageData> Grab();

  vtkRenderer* GetRenderer() const { return this->Now.Scene.GetRenderer(); }
  vtkRelievoPass* GetFrame() const { return this->Now.Scene.GetFrame(); }
  const scene::DressedScene& GetScene() const { return this->Now.Scene; }

private:
  void FitClipping();
  void Dress(const scene::Settings& settings, bool keepCamera);

  // All that belongs to one scene.
  struct Contents
  {
    scene::DressedScene Scene;
    scene::Settings Shown;
  };
  void Remove(const Contents& contents);

  // The camera's place, and half the height of a parallel view.
  struct Stand
  {
    scene::CameraPlace Place;
    double Scale = 0.0;
    double Angle = 0.0;
    double Aspect = 0.0; // of the view
  };
  Stand GetStand(double aspect) const;

  vtkRenderWindow* Window;
  scene::ProgressListener* Listener = nullptr;
  unsigned long Observer;
  Contents Now;
  Stand Chosen, Kept; // the view before its shape changed first, and the resulting view
};
}

#endif
