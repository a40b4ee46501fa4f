// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Converts the words of the G-buffer to layers as arrays, in double where precision needs it.
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
class vtkRelievoMeshLinks;
class vtkRelievoWordSource;
class vtkRenderer;
struct vtkRelievoGBufferLayout;
struct vtkRelievoLayer;
struct vtkRelievoFrameCamera;

class vtkRelievoLayerReader
{
public:
  // Reads the region x y w h of the source.
  vtkRelievoLayerReader(const vtkRelievoGBufferLayout& layout, vtkRelievoWordSource& source,
    const int region[4], const vtkRelievoFrameCamera& view);

  // Adds the channels of the layer to the layout.
  static void AddChannels(const std::string& layer, vtkRelievoGBufferLayout& layout);

  // Whether the layer depends on the position shown at a pixel.
  static bool NeedsPlaces(const std::string& layer);

  void SetNormalSpaceIsWorld(bool world) { this->WorldNormals = world; }
  void SetRefineDepth(bool refine) { this->Refines = refine; }
  void SetDraws(vtkRelievoDrawTable* draws, vtkRelievoMeshLinks* links, vtkRenderer* renderer)
  {
    this->Draws = draws;
    this->Links = links;
    this->Renderer = renderer;
  }

  // Adds the layer to the image's point data. Returns an error message, or an empty string.
  std::string Read(const std::string& layer, vtkImageData* image);

private:
  // One word of the layout, for every pixel.
  const std::uint32_t* GetWords(int word);
  vtkIdType GetNumberOfPixels() const;

  // Resolves the draw table, once.
  void ResolveDraws();

  // Position of a pixel in eye space, if its actor has its own shader code and the layout has
  // places; else nullptr.
  const glm::dvec3* GetPlace(vtkIdType pixel, glm::dvec3& eye);
  void PreparePlaces();

  // The layer depth, cached for the layers that depend on positions.
  vtkFloatArray* GetDepth();
  vtkSmartPointer<vtkFloatArray> ReadDepth();
  void RefineDepth(float* depths);
  template <typename Array>
  vtkSmartPointer<Array> MakeOfPoints(const vtkRelievoLayer& layer);
  vtkSmartPointer<vtkDataArray> ReadPoints(const vtkRelievoLayer& layer);
  vtkSmartPointer<vtkDataArray> ReadNormal(int firstWord);
  vtkSmartPointer<vtkDataArray> ReadAlbedo();
  vtkSmartPointer<vtkDataArray> ReadShadow(int light, std::string& error);
  vtkSmartPointer<vtkDataArray> ReadId(const std::string& layer);
  vtkSmartPointer<vtkDataArray> ReadNamedArray(const std::string& layer, std::string& error);

  const vtkRelievoGBufferLayout& Layout;
  vtkRelievoWordSource& Source;
  int Region[4];
  const vtkRelievoFrameCamera& View;
  bool WorldNormals = true;
  bool Refines = true;
  vtkRelievoDrawTable* Draws = nullptr;
  vtkRelievoMeshLinks* Links = nullptr;
  vtkRenderer* Renderer = nullptr;
  bool Resolved = false;
  std::vector<float> Places; // x and y of each pixel in eye space; empty: from pixel and depth
  const std::uint32_t* Ids = nullptr;
  vtkSmartPointer<vtkFloatArray> Depth;
  struct Freed
  {
    void operator()(std::uint32_t* words) const { std::free(words); }
  };
  std::vector<std::unique_ptr<std::uint32_t[], Freed>> Words; // by word; null: not read yet
};

#endif
