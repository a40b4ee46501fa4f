// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the words of the G-buffer to the layers as arrays, in double where it counts.
#ifndef vtkRelievoLayerReader_h
#define vtkRelievoLayerReader_h

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFloatArray;
class vtkImageData;
class vtkRelievoDrawTable;
class vtkRelievoGBufferTarget;
class vtkRelievoMeshLinks;
class vtkRenderer;
struct vtkRelievoGBufferLayout;
struct vtkRelievoLayer;
struct vtkRelievoFrameCamera;

class vtkRelievoLayerReader
{
public:
  // The region x y w h of the target's textures is read.
  vtkRelievoLayerReader(const vtkRelievoGBufferLayout& layout, vtkRelievoGBufferTarget& target,
    const int region[4], const vtkRelievoFrameCamera& view);

  // Marks in the layout what the layer is made of.
  static void AddChannels(const std::string& layer, vtkRelievoGBufferLayout& layout);

  // Whether the layer is made of the place that a pixel shows.
  static bool NeedsPlaces(const std::string& layer);

  void SetNormalSpaceIsWorld(bool world) { this->WorldNormals = world; }
  void SetRefineDepth(bool refine) { this->Refines = refine; }
  void SetDraws(vtkRelievoDrawTable* draws, vtkRelievoMeshLinks* links, vtkRenderer* renderer)
  {
    this->Draws = draws;
    this->Links = links;
    this->Renderer = renderer;
  }

  // Adds the layer to the image's point data. Returns what is wrong, in words.
  std::string Read(const std::string& layer, vtkImageData* image);

private:
  // A word of the layout, of every pixel.
  const std::uint32_t* GetWords(int word);
  vtkIdType GetNumberOfPixels() const;

  // Looks up what the words mean, once.
  void ResolveDraws();

  // Where a pixel is in eye space, if its actor has shader code of its own and the layout has
  // places; else null.
  const glm::dvec3* GetPlace(vtkIdType pixel, glm::dvec3& eye);
  void PreparePlaces();

  // The layer depth, made once: the layers of points are made of it.
  vtkFloatArray* GetDepth();
  vtkSmartPointer<vtkFloatArray> ReadDepth();
  void RefineDepth(float* depths);
  template <typename Array>
  vtkSmartPointer<Array> MakeOfPoints(const vtkRelievoLayer& layer);
  vtkSmartPointer<vtkDataArray> ReadPoints(const vtkRelievoLayer& layer);
  vtkSmartPointer<vtkDataArray> ReadNormal(int firstWord);
  vtkSmartPointer<vtkDataArray> ReadAlbedo();
  vtkSmartPointer<vtkDataArray> ReadShadow(int light, std::string& wrong);
  vtkSmartPointer<vtkDataArray> ReadId(const std::string& layer);
  vtkSmartPointer<vtkDataArray> ReadNamedArray(const std::string& layer, std::string& wrong);

  const vtkRelievoGBufferLayout& Layout;
  vtkRelievoGBufferTarget& Target;
  int Region[4];
  const vtkRelievoFrameCamera& View;
  bool WorldNormals = true;
  bool Refines = true;
  vtkRelievoDrawTable* Draws = nullptr;
  vtkRelievoMeshLinks* Links = nullptr;
  vtkRenderer* Renderer = nullptr;
  bool Resolved = false;
  std::vector<float> Places; // x and y of each pixel in eye space; empty: as pixel and depth say
  const std::uint32_t* Ids = nullptr;
  vtkSmartPointer<vtkFloatArray> Depth;
  struct Freed
  {
    void operator()(std::uint32_t* words) const { std::free(words); }
  };
  std::vector<std::unique_ptr<std::uint32_t[], Freed>> Words; // by word; null: not read yet
};

#endif
