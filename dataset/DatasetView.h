// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One view of a data set: its picture, its layers, and the masks of its objects.
 */
#ifndef DatasetView_h
#define DatasetView_h

#include "DatasetMask.h"
#include "DatasetNames.h"
#include "DatasetObjects.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoWindowGuard.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkLight;
class vtkRelievoCameraModel;
class vtkRelievoLensCamera;
class vtkRenderer;

namespace dataset
{
/// The size of an object's silhouette, which may extend beyond the picture by up to its size.
struct DatasetSilhouette
{
  std::size_t Count = 0;
  std::array<int, 4> Box{}; ///< in columns and rows of the picture; see DatasetMask::GetBox
};

struct DatasetView
{
  int Columns = 0, Rows = 0;
  std::vector<unsigned char> Picture;         ///< RGB, row by row from the top; empty: none
  std::vector<int> Objects;                   ///< object of each pixel, from the top; -1: none
  std::vector<DatasetMask> Visible, Whole;    ///< of each object: visible mask and full mask
  std::vector<DatasetSilhouette> Silhouettes; ///< of each object, if requested
  /// The requested layers, and depth, actor and block; row 0 is the bottom one.
  vtkSmartPointer<vtkImageData> Layers;
  /// A layer's values row by row from the top.
  std::vector<double> GetLayer(const std::string& name, int& components) const;
};

/// Draws views. Its destructor restores the renderer, its camera, its lights and its window.
class DatasetPainter
{
public:
  /// `silhouettes`: whether to compute silhouettes.
  DatasetPainter(vtkRenderer* renderer, const DatasetObjects& objects,
    const std::vector<std::string>& layers, bool silhouettes);
  ~DatasetPainter();
  DatasetPainter(const DatasetPainter&) = delete;
  void operator=(const DatasetPainter&) = delete;

  /// Draws a view. `before`: the previous view's camera, the target of flow, or nullptr. `sun`: the
  /// direction towards the sun, in place of the scene's first. Throws UsageError for unknown
  /// layers, and WorkError.
  DatasetView Draw(vtkRelievoCameraModel* camera, vtkRelievoCameraModel* before,
    const std::optional<std::array<double, 3>>& sun);

  /// Gives the lights back as they were before suns of their own.
  void RestoreLights();

private:
  struct Lamp
  {
    vtkSmartPointer<vtkLight> Light;
    bool On;
  };

  void OpenWindow();
  void BeginView();
  void SetSun(const std::array<double, 3>& direction);
  void DrawInWindow(vtkRelievoLensCamera* camera, DatasetView& view);
  void FollowRays(vtkRelievoCameraModel* camera, vtkRelievoCameraModel* before, DatasetView& view);
  vtkSmartPointer<vtkImageData> DrawLayers(const std::vector<std::string>& layers);
  void TakePicture(DatasetView& view);
  void TakePicture(vtkRelievoCameraModel* camera, DatasetView& view);
  vtkSmartPointer<vtkImageData> TraceLayers(vtkRelievoCameraModel* camera,
    vtkRelievoCameraModel* before, const std::vector<std::string>& layers);
  void FindWhole(vtkRelievoCameraModel* camera, DatasetView& view);
  void DrawAlone(vtkRelievoLensCamera* camera, const std::vector<int>& objects,
    const std::function<void(std::size_t, std::size_t)>& call);
  void LookBeyond(vtkRelievoLensCamera* camera, DatasetView& view);

  vtkRenderer* Renderer;
  const DatasetObjects& Objects;
  std::vector<std::string> Layers, Flow; // drawn (traced for sensors); always traced
  bool Silhouettes, HadLights;
  std::unique_ptr<vtkRelievoWindowGuard> Guard; // of an open window
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkRenderWindow> Window;
  bool IsOwnWindow = false;
  std::vector<Lamp> Lamps; // switched off while the sun is the only light
  vtkSmartPointer<vtkLight> Sun;
  std::array<double, 3> SunPosition{}, SunFocus{};
  vtkSmartPointer<vtkMatrix4x4> SunMatrix;
  bool IsOwnSun = false;
  vtkSmartPointer<vtkRelievoRayScene> Rays, Nothing;
};
}

#endif
