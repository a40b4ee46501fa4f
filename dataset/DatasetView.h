// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Views of a data set: their pictures, layers, and the masks of their objects.
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

/// What a view is drawn from: its camera, the camera of the view before it, to which flow leads, or
/// nullptr, and the direction towards the sun, in place of the scene's first.
struct DatasetShot
{
  vtkRelievoCameraModel* Camera = nullptr;
  vtkRelievoCameraModel* Before = nullptr;
  std::optional<std::array<double, 3>> Sun;
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

  /// How many views with this one's camera and size are best drawn in one call. The views are the
  /// same however many are drawn together.
  std::size_t GetNumberTogether(vtkRelievoCameraModel* camera) const;

  /// Draws views: one, or several pinholes of one size. Throws UsageError for unknown layers, and
  /// WorkError.
  std::vector<DatasetView> Draw(const std::vector<DatasetShot>& shots);

  /// Gives the lights back as they were before suns of their own.
  void RestoreLights();

private:
  struct Lamp
  {
    vtkSmartPointer<vtkLight> Light;
    bool On;
  };

  /// A pinhole in the window.
  struct Shown
  {
    vtkRelievoLensCamera* Lens = nullptr;
    vtkSmartPointer<vtkCamera> Camera;
    vtkSmartPointer<vtkImageData> Layers; ///< of all objects, if they have been drawn
  };
  using Take = std::function<void(std::size_t, vtkImageData*)>;

  void OpenWindow();
  void BeginView();
  void SetSun(const std::optional<std::array<double, 3>>& direction);
  void DrawInWindow(const std::vector<DatasetShot>& shots, std::vector<DatasetView>& views);
  void FollowRays(vtkRelievoCameraModel* camera, vtkRelievoCameraModel* before, DatasetView& view);
  void DrawLayers(
    const std::vector<std::string>& layers, const std::vector<Shown>& cameras, const Take& take);
  void TakePicture(DatasetView& view);
  void TakePicture(vtkRelievoCameraModel* camera, DatasetView& view);
  vtkSmartPointer<vtkImageData> TraceLayers(vtkRelievoCameraModel* camera,
    vtkRelievoCameraModel* before, const std::vector<std::string>& layers);
  void FindWhole(vtkRelievoCameraModel* camera, DatasetView& view);
  void DrawAlone(const std::vector<Shown>& cameras, const std::vector<std::vector<int>>& objects,
    const std::function<void(std::size_t, std::size_t, std::size_t)>& call);
  void LookBeyond(const std::vector<Shown>& cameras, std::vector<DatasetView>& views);

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
