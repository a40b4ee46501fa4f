// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoRayLayers
 * @brief Layers of any camera model, from one ray per pixel: exact, without a window or OpenGL.
 *
 * vtkRelievoLayerSource renders layers of a vtkCamera; this class traces rays in a
 * vtkRelievoRayScene instead, for distorting lenses, panoramas, line scanners and lidars. One ray
 * goes through each pixel's centre, in double.
 *
 * Output: vtkImageData of the camera's columns and rows, row 0 at the bottom, with a point array
 * for each layer, of the type and background in vtkRelievoLayerCatalogue: depth, range, normal,
 * geometric_normal, position, actor, block, cell, ambient, and arrays by name (point arrays
 * interpolated, cell arrays as they are; `point:NAME`, `cell:NAME` if both exist; the background is
 * NaN). `depth` is z in camera space, or the range for sensors that look all around. `actor` is the
 * number of the prop in the scene. `ambient` is the share of the sky that the surface sees on the
 * side of the triangle that was hit, as in vtkRelievoAmbientStage; rays treat all surfaces as
 * opaque.
 *
 * `flow`, `motion` and `flow_valid`, if there is another state (SetOther), are those of
 * vtkRelievoFlow, from this state to the other one; arrays of these names are then `point:flow` or
 * `cell:flow`.
 *
 * Field data: the calibration (vtkRelievoCameraModel::AddTo).
 *
 * Errors: no scene or camera; a layer that neither rays nor data have; another state whose camera
 * cannot project points.
 */
#ifndef vtkRelievoRayLayers_h
#define vtkRelievoRayLayers_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for the scenes and cameras

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
  /** The scene and the camera. */
  void SetScene(vtkRelievoRayScene* scene);
  vtkRelievoRayScene* GetScene();
  void SetCamera(vtkRelievoCameraModel* camera);
  vtkRelievoCameraModel* GetCamera();
  ///@}

  ///@{
  /** The scene at another moment, and the camera that sees it then; default: none. */
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
   * Settings of the layer `ambient`: rays into the sky for each pixel, 1 to 65536 (64); world units
   * beyond which nothing occludes (0: no limit); whether parts of the sky are weighted by the
   * cosine to the normal (default) or evenly; and the seed of the rays (0).
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

  /** The names of the layers that rays have, except arrays, separated by commas. */
  static std::string GetLayerNames();

  /**
   * Whether rays may have a layer of this name; names outside all catalogues may be data arrays.
   */
  static bool HasLayer(const char* name);

  /** Whether this layer needs another state: flow, motion, flow_valid. */
  static bool IsFlow(const char* name);

  /** Always newer than before, because the scene can change without notice. */
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
  double FlowShare = 0.0; // of the progress, while flow is computed
  std::string FlowError;
};

#endif
