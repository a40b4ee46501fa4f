// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A frame to compare: the layers of its image as plain numbers, and its record (the field data:
// camera, lights, and of baselines objects, overlays, settings), read once.
#ifndef vtkRelievoComparedFrame_h
#define vtkRelievoComparedFrame_h

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

class vtkImageData;

namespace relievo::compare
{
// The format of records that is read and written; older ones lack entries.
constexpr int RecordVersion = 1;

// An actor, as the record has it. Without a record only the number of objects is known, by the
// largest id that is seen.
struct Object
{
  std::string Name; // empty: none was given
  bool Visible = true;
  bool Translucent = false; // in no layer
  std::array<double, 16> Matrix{};
  std::string Points, Cells; // numbers and sums of the mesh
  std::array<double, 3> Center{};
  std::array<double, 9> Spread{};                            // the covariance of the mesh's points
  std::array<double, 6> Bounds{ 1., -1., 1., -1., 1., -1. }; // in the world
  nlohmann::json Settings;                                   // of its property
};

struct Light
{
  std::string Name;
  std::string Layer; // of its shadows, which the frame may lack
  nlohmann::json Values;
};

struct Layer
{
  int Components = 0;
  std::vector<float> Values; // by pixels; components side by side
  bool IsBytes = false;      // 0 to 255
};

class Frame
{
public:
  // Empty, or what is wrong with the image, such as "has no layers".
  std::string Read(vtkImageData* image);

  std::array<int, 2> Size{};
  std::size_t Pixels = 0;
  Layer Picture;                        // no components: none
  bool IsLinear = false;                // the picture is of light, and not of levels
  std::vector<int> Actor, Block, Cell;  // empty: no such layer
  std::vector<float> Depth;             // along the view direction; empty: no such layer
  std::vector<double> Position;         // 3 each; empty: no such layer
  std::map<std::string, Layer> Surface; // other layers of surfaces: normal, albedo, arrays
  std::map<std::string, std::vector<float>> Shadow; // of lights, by the layer's name
  std::map<std::string, Layer> Stages;              // light, fog, ambient, marker, blend

  bool HasRecord = false;
  bool HasLights = false;
  std::vector<Object> Objects;
  std::vector<Light> Lights;
  std::vector<nlohmann::json> Overlays;
  std::map<std::string, std::string> Settings;
  std::vector<std::string> Versions;

  bool HasCamera = false;
  double Near = 0., Far = 0.;

  // Whether cameras see the same points in the same pixels. Clipping distances follow the scene's
  // bounds, and are not asked.
  bool SeesAs(const Frame& other) const;

  // Whether the picture has two or four components.
  bool HasAlpha() const
  {
    return this->Picture.Components > 0 && this->Picture.Components % 2 == 0;
  }

  // Red, green, blue or alpha (0 to 3) of the picture as displays show it: 0 to 255, and on beyond
  // that for light above 1. Grey is the same red, green and blue; alpha is for pictures that have
  // it. NaN stays NaN.
  float Level(std::size_t pixel, int c) const;

  // Whether there are positions, in a layer or by depth and camera.
  bool HasPositions() const { return !this->Position.empty() || this->UnprojectsDepth(); }
  std::array<double, 3> GetPosition(std::size_t pixel) const;

  // Where the picture shows a point, in pixels from the lower left corner; false: behind the eye.
  bool Project(const double point[3], double place[2]) const;

  // The world's length of a pixel at the depth of this one.
  double GetFootprint(std::size_t pixel) const;

  // Whether there are depths, in a layer or by position and camera.
  bool HasDepths() const
  {
    return !this->Depth.empty() || (!this->Position.empty() && this->HasCamera);
  }

  // Distance from the eye, or along the view, by which surfaces hide each other. NaN without
  // depths.
  double GetDepth(std::size_t pixel) const;

private:
  bool UnprojectsDepth() const { return !this->Depth.empty() && this->HasCamera; }
  std::array<double, 3> Unproject(double x, double y, double depth) const;
  std::string ReadRecord(vtkImageData* image);
  void ReadLights(vtkImageData* image);

  std::array<double, 16> WorldToCamera{}, CameraToWorld{}, WorldToNDC{}, CameraToNDC{};
};
}

#endif
