// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLayerSource
 * @brief A renderer's layers as image data: depth, normals, positions, ids, arrays.
 *
 * Every Update() draws the layers anew and leaves the window's picture alone, unless the layer
 * `color` is asked for, which renders the window.
 *
 * Output: vtkImageData of the viewport's size in pixels, row 0 at the bottom, one point array per
 * layer: depth, range float, world units, +infinity where nothing is; normal, geometric_normal 3
 * float, unit, zero where nothing is; position 3 double, world; albedo 4 unsigned char; color 4
 * float, scene-linear, premultiplied; actor, block, cell int, -1 where nothing is; arrays float or
 * double, NaN where nothing is. actor is the place in vtkRenderer::GetActors(), block the flat
 * index in a composite dataset (0 in others), cell the cell of the drawn vtkPolyData, or the input
 * point of a glyph.
 *
 * Field data: worldToCamera and worldToNDC (16 double, rows first, as vtkMatrix4x4), near, far,
 * relievo:origin (3 double: the camera's focal point, rounded to float), lights (one JSON string
 * each).
 *
 * Errors: no renderer or window, a layer that does not exist, a size above the OpenGL limit.
 */
#ifndef vtkRelievoLayerSource_h
#define vtkRelievoLayerSource_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkSmartPointer.h"        // for the renderer

#include <string> // for names
#include <vector> // for names

class vtkImageData;
class vtkRelievoPass;
class vtkRenderer;

class VTKRELIEVOPASSES_EXPORT vtkRelievoLayerSource : public vtkImageAlgorithm
{
public:
  static vtkRelievoLayerSource* New();
  vtkTypeMacro(vtkRelievoLayerSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The renderer whose layers are made; it must be in a render window. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** The layers, by name, in the order of the output's arrays. */
  void AddLayer(const std::string& name);
  void RemoveAllLayers();
  int GetNumberOfLayers() { return static_cast<int>(this->Layers.size()); }
  std::string GetLayer(int i);
  ///@}

  /** The scene changes without telling: always renders anew. */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * What the layers have besides the G-buffer, of a picture that has been drawn already: the layer
   * `color`, from the window's pixels, and the field data. For layers that are read elsewhere
   * (vtkRelievoPass::ReadLayers).
   */
  static void AddColor(vtkRenderer* renderer, vtkImageData* image);
  static void AddCamera(
    vtkRenderer* renderer, vtkImageData* image, vtkRelievoPass* frame = nullptr);
  ///@}

protected:
  vtkRelievoLayerSource();
  ~vtkRelievoLayerSource() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRelievoLayerSource(const vtkRelievoLayerSource&) = delete;
  void operator=(const vtkRelievoLayerSource&) = delete;

  bool Draw(vtkRelievoPass* pass, bool color);

  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<std::string> Layers;
};

#endif
