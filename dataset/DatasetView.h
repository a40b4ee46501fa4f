// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One view of a data set: its picture, its layers, and the masks of its objects.
 */
#ifndef DatasetView_h
#define DatasetView_h

#include "DatasetMask.h"
#include "DatasetObjects.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoWindowGuard.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkLight;
class vtkRelievoCameraModel;
class vtkRelievoLensCamera;
class vtkRenderer;

namespace scene
{
/// How much of an object there is, also beyond the picture: up to its size around it.
struct DatasetSilhouette
{
  std::size_t Count = 0;
  std::array<int, 4> Box{}; ///< in the picture's columns and rows; see DatasetMask::GetBox
};

struct DatasetView
{
  int Columns = 0, Rows = 0;
  std::vector<unsigned char> Picture;         ///< RGB, row by row from the top; empty: none
  std::vector<int> Objects;                   ///< of each pixel, from the top; -1: none
  std::vector<DatasetMask> Visible, Whole;    ///< of each object: what is seen of it, and all of it
  std::vector<DatasetSilhouette> Silhouettes; ///< of each object, if they are asked for
  /// What was asked for, and depth, actor and block, row 0 at the bottom.
  vtkSmartPointer<vtkImageData> Layers;
  /// A layer's values row by row from the top.
  std::vector<double> GetLayer(const std::string& name, int& components) const;
};

/// Draws views. The renderer, its camera, its lights and its window are as before when it is gone.
class DatasetPainter
{
public:
  /// `silhouettes`: whether views have them.
  DatasetPainter(vtkRenderer* renderer, const DatasetObjects& objects,
    const std::vector<std::string>& layers, bool silhouettes);
  ~DatasetPainter();
  DatasetPainter(const DatasetPainter&) = delete;
  void operator=(const DatasetPainter&) = delete;

  /// What the view before was seen by, which flow goes to, or nullptr; and the direction towards
  /// the sun, in place of that of the scene's first. Throws UsageError for layers that there are
  /// not, WorkError.
  DatasetView Draw(vtkRelievoCameraModel* camera, vtkRelievoCameraModel* before,
    const std::optional<std::array<double, 3>>& sun);

private:
  struct Lamp
  {
    vtkSmartPointer<vtkLight> Light;
    bool On;
  };

  void OpenWindow();
  void BeginView();
  void SetSun(const std::array<double, 3>& direction);
  void RestoreLights();
  void DrawInWindow(vtkRelievoLensCamera* camera, DatasetView& view);
  void FollowRays(vtkRelievoCameraModel* camera, vtkRelievoCameraModel* before, DatasetView& view);
  vtkSmartPointer<vtkImageData> DrawLayers(const std::vector<std::string>& layers);
  void TakePicture(DatasetView& view);
  void TakePicture(vtkRelievoCameraModel* camera, DatasetView& view);
  vtkSmartPointer<vtkImageData> TraceLayers(vtkRelievoCameraModel* camera,
    vtkRelievoCameraModel* before, const std::vector<std::string>& layers);
  void FindWhole(vtkRelievoCameraModel* camera, DatasetView& view);
  void LookBeyond(vtkRelievoLensCamera* camera, DatasetView& view);

  vtkRenderer* Renderer;
  const DatasetObjects& Objects;
  std::vector<std::string> Layers, Flow; // drawn, or traced for sensors; traced for all
  bool Silhouettes, HadLights;
  std::unique_ptr<vtkRelievoWindowGuard> Guard; // of a window that is open
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkRenderWindow> Window;
  bool IsOwnWindow = false;
  std::vector<Lamp> Lamps; // switched off for the sun
  vtkSmartPointer<vtkLight> Sun;
  std::array<double, 3> SunPosition{}, SunFocus{};
  vtkSmartPointer<vtkMatrix4x4> SunMatrix;
  bool IsOwnSun = false;
  vtkSmartPointer<vtkRelievoRayScene> Rays, Nothing;
};
}

#endif
