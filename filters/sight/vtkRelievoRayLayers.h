// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoRayLayers
 * @brief Layers of any camera model, by a ray for each pixel: exact, without a window or OpenGL.
 *
 * What vtkRelievoLayerSource draws for a vtkCamera this asks a vtkRelievoRayScene for: lenses that
 * bend, panoramas, moving lines, lidars. One ray at each pixel's centre, in double.
 *
 * Output: vtkImageData of the camera's columns and rows, row 0 at the bottom, a point array for
 * each layer, of the type and with the background that vtkRelievoLayerCatalogue says: depth, range,
 * normal, geometric_normal, position, actor, block, cell, ambient, and arrays by name (point arrays
 * interpolated, cell arrays as they are; `point:NAME`, `cell:NAME` where both have it; the
 * background is NaN). `depth` is z in camera space, or the range of sensors that look all around.
 * `actor` is the number of the prop in the scene. `ambient` is the share of the sky that the
 * surface sees on the side of its triangle that is met, as vtkRelievoAmbientStage has it; for rays
 * all surfaces are opaque.
 *
 * `flow`, `motion` and `flow_valid`, if there is another state (SetOther), are those of
 * vtkRelievoFlow, from this state to the other one; arrays of these names are `point:flow` or
 * `cell:flow` then.
 *
 * Field data: the calibration (vtkRelievoCameraModel::AddTo).
 *
 * Errors: no scene or camera, a layer that rays do not have or no data has; another state whose
 * camera has no places for points.
 */
#ifndef vtkRelievoRayLayers_h
#define vtkRelievoRayLayers_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for what is given

#include <string> // for names
#include <vector> // for names

class vtkDoubleArray;
class vtkImageData;
class vtkRelievoCameraModel;
class vtkRelievoRayScene;
class vtkTable;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoRayLayers : public vtkImageAlgorithm
{
public:
  static vtkRelievoRayLayers* New();
  vtkTypeMacro(vtkRelievoRayLayers, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** What is seen, and what sees it. */
  void SetScene(vtkRelievoRayScene* scene);
  vtkRelievoRayScene* GetScene();
  void SetCamera(vtkRelievoCameraModel* camera);
  vtkRelievoCameraModel* GetCamera();
  ///@}

  ///@{
  /** The scene at another moment, and what sees it then; default: none. */
  void SetOther(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera);
  vtkRelievoRayScene* GetOtherScene();
  vtkRelievoCameraModel* GetOtherCamera();
  ///@}

  ///@{
  /** The layers, by name, in the order of the output's arrays. */
  void AddLayer(const char* name);
  void RemoveAllLayers();
  ///@}

  ///@{
  /**
   * Of the layer `ambient`: rays into the sky for each pixel, 1 to 65536 (64); world units beyond
   * which nothing hides it (0: no limit); whether parts of the sky count by the cosine to the
   * normal (default) or evenly; and a number that chooses other rays (0).
   */
  vtkSetClampMacro(AmbientSamples, int, 1, 65536);
  vtkGetMacro(AmbientSamples, int);
  vtkSetClampMacro(AmbientRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AmbientRadius, double);
  vtkSetMacro(AmbientByCosine, bool);
  vtkGetMacro(AmbientByCosine, bool);
  vtkBooleanMacro(AmbientByCosine, bool);
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  /** The names of the layers that rays have, arrays apart, with commas between them. */
  static std::string GetLayerNames();

  /** Whether rays have a layer of this name; of one that no catalogue lists, data may. */
  static bool HasLayer(const char* name);

  /** Whether a layer of this name needs another state: flow, motion, flow_valid. */
  static bool IsFlow(const char* name);

  /** Always newer than before, because the scene may change without notice. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRelievoRayLayers();
  ~vtkRelievoRayLayers() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRelievoRayLayers(const vtkRelievoRayLayers&) = delete;
  void operator=(const vtkRelievoRayLayers&) = delete;

  struct SkyRays;
  bool FindFlow(vtkImageData* flow, double share);
  void FollowFlow(vtkObject* flow, unsigned long event, void* data);
  bool FindAmbient(SkyRays& sky, vtkTable* hits, vtkIdType firstPixel, std::vector<double>& share);

  vtkSmartPointer<vtkRelievoRayScene> Scene;
  vtkSmartPointer<vtkRelievoCameraModel> Camera;
  vtkSmartPointer<vtkRelievoRayScene> OtherScene;
  vtkSmartPointer<vtkRelievoCameraModel> OtherCamera;
  std::vector<std::string> Layers;
  int AmbientSamples = 64;
  double AmbientRadius = 0.0;
  bool AmbientByCosine = true;
  int Seed = 0;
  double FlowShare = 0.0; // of the progress, while flow is found
  std::string FlowError;
};

#endif
