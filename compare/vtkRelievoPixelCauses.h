// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cause of each pixel that differs: the first that explains it, in the order of CauseWords.
#ifndef vtkRelievoPixelCauses_h
#define vtkRelievoPixelCauses_h

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"
#include "vtkRelievoComparisonLimits.h"
#include "vtkRelievoObjectChanges.h"
#include "vtkRelievoVolumeChanges.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace relievo::compare
{
class PixelCauses
{
public:
  // Codes of pixels without a finding.
  enum Codes
  {
    Alike = -1,
    WithinRounding = -2,
    WithinEdge = -3,
    Unexplained = -4,
    Pending = -5
  };

  PixelCauses(const Frame& before, const Frame& after, const Limits& limits,
    const ObjectChanges& objects, CauseList& list);

  // The index of each pixel's finding in the list, or a code.
  const std::vector<int>& Get() const { return this->Causes; }

  std::size_t Count(int code) const;

private:
  // A light in both frames; -1: absent from that frame.
  struct LightPair
  {
    int Before = -1, After = -1; // indices in Frame::Lights
    int Finding = -1;            // the difference between their records
  };

  // The values of corresponding layers of both frames.
  struct Values
  {
    const float *Before, *After;
    std::size_t Components;
  };

  // A translucent object, and its box in the picture: first and last x, first and last y, in
  // pixels.
  struct Cover
  {
    std::size_t Object;
    std::array<double, 4> Range;
  };

  void PairLights();
  void PairLayers();
  bool IsEqualInAll(std::size_t pixel) const;
  void CompareSettings();
  int JudgeLayers(std::size_t pixel);
  int JudgeGeometry(std::size_t pixel, int a, int b);
  int JudgeSurface(std::size_t pixel, int a, bool sameCell);
  int JudgeLights(std::size_t pixel);
  int JudgeStages(std::size_t pixel);
  int JudgeVolumes(std::size_t pixel);
  int JudgePicture(std::size_t pixel) const;
  int JudgeWithinLimits(std::size_t pixel);
  int CountLevels() const; // components of a pixel, with alpha if both have it; 0: no picture
  int Explain(std::size_t pixel, const std::vector<int>& causes);
  int GetNeighbourCause(std::size_t pixel, const std::vector<int>& causes) const;
  bool IsEdge(std::size_t pixel) const;
  bool IsBetweenNeighbours(std::size_t pixel, double widening) const;
  bool IsMixture(std::size_t pixel) const;
  bool IsThin(std::size_t pixel) const;
  bool IsDarkerInSamples(std::size_t pixel) const; // in one frame no component is brighter
  bool IsOfAmbient(std::size_t pixel) const;
  bool IsOfNormal(std::size_t pixel) const;
  bool IsTie(std::size_t pixel) const;
  std::optional<double> FindStep(const std::string& samples) const;
  bool DiffersInLayer(const Layer& a, const Layer& b, std::size_t pixel, double limit) const;
  double GetAngle(std::size_t pixel) const;
  bool IsMapped(int a) const;
  bool IsTexelRounded(std::size_t pixel, double angle) const;
  void ProjectTranslucent();
  std::array<double, 4> ProjectBox(const std::array<double, 6>& bounds) const;
  bool Covers(const Cover& cover, std::size_t pixel) const;
  int FindLight(const LightPair& pair, Cause cause);
  int NameActor(Cause cause, int object);

  // Visits the pixels up to `reach` columns and rows away, and the pixel itself.
  template <typename Visit>
  void ForNeighbours(std::size_t pixel, Visit visit, int reach = 1) const;

  // Whether each frame's value(frame, pixel) lies between the other frame's values around the
  // pixel.
  template <typename Value>
  bool IsBetween(std::size_t pixel, double limit, Value value) const;
  // One direction of it; `widening` extends the range by a part of its width at both ends.
  template <typename Value>
  bool IsBetween(const Frame& own, const Frame& other, std::size_t pixel, double limit, Value value,
    double widening = 0.0, int reach = 1) const;

  const Frame& A;
  const Frame& B;
  Limits Bounds;
  const ObjectChanges& Objects;
  CauseList& List;
  VolumeChanges VolumesChanged;
  const Frame* Smoother = nullptr; // the frame with more samples per pixel
  std::vector<LightPair> Lights;
  std::vector<Values> Layers;
  std::vector<Cover> Translucent[2];          // objects of A and of B
  std::vector<Cover> Volumes;                 // changed ones; Object is the finding
  bool HasOtherForms = false;                 // layers with different numbers of components
  int Overlay = -1, Tone = -1, Settings = -1; // findings of the records
  std::map<int, std::set<int>> Cells;         // cells of changed shapes, by finding
  // Tolerances at shadow borders, and of ambient occlusion; none: the scene has changed.
  std::optional<double> BorderStep, AmbientStep;
  bool IsDifferent = false; // some layer of the pixel differs within its limits
  double Loose = 0.0; // the angle of its normal, within the limit of texels but not of formats
  // The ambient occlusion of the pixel in both frames, if it differs by a sample.
  std::optional<std::array<double, 2>> Ambient;
  std::vector<int> Causes;
};
}

#endif
