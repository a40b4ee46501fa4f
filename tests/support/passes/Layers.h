// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Layers.h
 * @brief The layers of a renderer by pixel, made by either of the two methods.
 */
#ifndef relievoTestLayers_h
#define relievoTestLayers_h

#include <vtkImageData.h> // for the smart pointers to it
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkRelievoLayersStage;
class vtkRenderer;

namespace relievoTest
{
/** How layers are made. */
enum class Way
{
  /** In a separate geometry pass, without the picture (vtkRelievoLayerSource). */
  Own,
  /** While the picture is drawn, in the delegate's geometry pass. */
  Shared
};

/** Both methods, to loop over, and their names. */
const Way BothWays[] = { Way::Own, Way::Shared };
std::string ToString(Way way);

/** The layers of one frame. */
class Layers
{
public:
  /**
   * Makes the layers of a renderer in a window. Fails the test if a layer is missing, or if the
   * frame used the other method. `set`, if given, is called with the G-buffer stage before.
   * Afterwards the renderer is unchanged.
   */
  Layers(vtkRenderer* renderer, const std::vector<std::string>& names, Way way = Way::Own,
    const std::function<void(vtkRelievoLayersStage*)>& set = nullptr);

  /** Reads an image that already contains layers. */
  explicit Layers(vtkImageData* image);

  int Width = 0;
  int Height = 0;

  /**
   * A component of a layer at a pixel; row 0 is at the bottom. NaN, with a failure, without the
   * layer.
   */
  double Value(const std::string& name, int x, int y, int component = 0) const;
  glm::dvec3 Vector(const std::string& name, int x, int y) const;
  int Id(const std::string& name, int x, int y) const;

  /** Number of pixels whose id is this one. */
  long long CountId(const std::string& name, int id) const;

  /** Number of pixels with a finite depth (of the layer "depth"). */
  long long Covered() const;

  vtkSmartPointer<vtkImageData> Image;
};

/** Number of pixels at which a layer of the two differs in any component; NaN equals NaN. */
long long CountDifferent(const Layers& a, const Layers& b, const std::string& name);

/** Largest difference of a component of a layer; 1e300 if only one is finite, or on failure. */
double LargestDifference(const Layers& a, const Layers& b, const std::string& name);

/** Whether two pictures are equal in every byte; prints where they differ. */
bool SamePicture(vtkImageData* a, vtkImageData* b, const std::string& what);
}

#endif
