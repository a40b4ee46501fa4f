// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A frame to compare, read once: the layers of its image as plain numbers, and its record, which is
// the field data (camera and lights; in baselines also objects, overlays and settings).
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
// The newest format of records, which is also written; older formats lack entries.
constexpr int RecordVersion = 3;

// An actor, as recorded. Without a record only the number of objects is known, from the largest
// visible id.
struct Object
{
  std::string Name; // empty: none was given
  bool Visible = true;
  bool Translucent = false; // translucent objects appear in no layer
  std::array<double, 16> Matrix{};
  std::string Points, Cells; // counts and check sums of the mesh
  std::string Glyphs;        // check sum of the shapes at its points; empty: unknown, or none
  std::array<double, 3> Center{};
  std::array<double, 9> Spread{};                            // the covariance of the mesh's points
  std::array<double, 6> Bounds{ 1., -1., 1., -1., 1., -1. }; // in world coordinates
  nlohmann::json Settings;                                   // the values of its vtkProperty
  nlohmann::json Color;                                      // null: coloured by an array, unknown
  nlohmann::json Clipping; // origin and normal of each plane; null: unknown
  nlohmann::json Blocks;   // those with attributes of their own; null: unknown
  bool HasNormalMap = false;
  std::string NormalMap; // its check sum; empty: unknown
};

struct Volume
{
  std::array<double, 6> Bounds{ 1., -1., 1., -1., 1., -1. }; // in world coordinates
  nlohmann::json Values = nlohmann::json::object();          // place, data, properties
};

struct Light
{
  std::string Name;
  std::string Layer; // the name of its shadow layer, which the frame may lack
  nlohmann::json Values;
};

struct Layer
{
  int Components = 0;
  std::vector<float> Values; // pixel by pixel, components interleaved
  bool IsBytes = false;      // values are 0 to 255
};

// The names of entries with different values. An entry that one of them lacks is not compared:
// older formats have fewer.
std::vector<std::string> ListChanges(const nlohmann::json& from, const nlohmann::json& to);

class Frame
{
public:
  // Returns an error message such as "has no layers", or an empty string.
  std::string Read(vtkImageData* image);

  std::array<int, 2> Size{};
  std::size_t Pixels = 0;
  Layer Picture;                        // no components: none
  bool IsLinear = false;                // the picture has linear light instead of display levels
  std::vector<int> Actor, Block, Cell;  // empty: no such layer
  std::vector<float> Depth;             // along the view direction; empty: no such layer
  std::vector<double> Position;         // 3 each; empty: no such layer
  std::map<std::string, Layer> Surface; // other layers of surfaces: normal, albedo, arrays
  std::map<std::string, std::vector<float>> Shadow; // shadows of lights, by the layer's name
  std::map<std::string, Layer> Stages;              // light, fog, ambient, marker, blend
  std::vector<int> VolumeId;                        // empty: no such layer, as of the following
  std::vector<float> VolumeDepth, VolumeOpacity;

  bool HasRecord = false;
  bool IsPortable = false; // the layers of surfaces are from rays
  bool HasVolumes = false; // whether the record lists volumes
  bool HasLights = false;
  std::vector<Object> Objects;
  std::vector<Light> Lights;
  std::vector<Volume> Volumes;
  std::vector<nlohmann::json> Overlays;
  std::map<std::string, std::string> Settings;
  std::vector<std::string> Versions;

  // The setting with the number of samples per pixel, and that number; -1: unknown.
  static constexpr const char* SamplesSetting = "multisamples";
  int GetSamples() const;

  bool HasCamera = false;
  double Near = 0., Far = 0.;

  // Whether both cameras show the same points in the same pixels. Ignores clipping distances, which
  // follow the scene's bounds.
  bool SeesAs(const Frame& other) const;

  // Whether the picture has two or four components.
  bool HasAlpha() const
  {
    return this->Picture.Components > 0 && this->Picture.Components % 2 == 0;
  }

  // Red, green, blue or alpha (0 to 3) of the picture in display levels: 0 to 255, and more for
  // light above 1. Grey has equal red, green and blue; alpha only if the picture has it. NaN stays
  // NaN.
  float Level(std::size_t pixel, int c) const;

  // Whether positions are known, from a layer or from depth and camera.
  bool HasPositions() const { return !this->Position.empty() || this->UnprojectsDepth(); }
  std::array<double, 3> GetPosition(std::size_t pixel) const;

  // Projects a point to pixels from the lower left corner of the picture. False: the point is
  // behind the camera.
  bool Project(const double point[3], double place[2]) const;

  // The size of a pixel in world units, at this pixel's depth, or at a given depth.
  double GetFootprint(std::size_t pixel) const
  {
    return this->GetFootprintAt(this->GetDepth(pixel));
  }
  double GetFootprintAt(double depth) const;

  // Whether depths are known, from a layer or from positions and camera.
  bool HasDepths() const
  {
    return !this->Depth.empty() || (!this->Position.empty() && this->HasCamera);
  }

  // The distance from the camera, or along the view direction: nearer surfaces hide farther ones.
  // NaN without depths.
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
