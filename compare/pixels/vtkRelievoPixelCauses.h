// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cause of each pixel that differs: the first that explains it, in the order of CauseWords.
#ifndef vtkRelievoPixelCauses_h
#define vtkRelievoPixelCauses_h

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"
#include "vtkRelievoComparisonLimits.h"
#include "vtkRelievoFramePair.h"
#include "vtkRelievoLightPairs.h"
#include "vtkRelievoNormalAngles.h"
#include "vtkRelievoObjectChanges.h"
#include "vtkRelievoPictureBoxes.h"
#include "vtkRelievoRecordChanges.h"
#include "vtkRelievoSampleMixtures.h"
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
  // The values of corresponding layers of both frames.
  struct Values
  {
    const float *Before, *After;
    std::size_t Components;
  };

  void PairLayers();
  bool IsEqualInAll(std::size_t pixel) const;
  int JudgeLayers(std::size_t pixel);
  int JudgeGeometry(std::size_t pixel, int a, int b);
  int JudgeSurface(std::size_t pixel, int a, bool sameCell);
  int JudgeLights(std::size_t pixel);
  int JudgeStages(std::size_t pixel);
  int JudgeVolumes(std::size_t pixel);
  int JudgePicture(std::size_t pixel) const;
  int JudgeWithinLimits(std::size_t pixel);
  int Explain(std::size_t pixel, const std::vector<int>& causes);
  int GetNeighbourCause(std::size_t pixel, const std::vector<int>& causes) const;
  bool IsOfAmbient(std::size_t pixel) const;
  bool IsTie(std::size_t pixel) const;
  std::optional<double> FindStep(const std::string& samples) const;
  bool DiffersInLayer(const Layer& a, const Layer& b, std::size_t pixel, double limit) const;
  int NameActor(Cause cause, int object);

  const Frame& A;
  const Frame& B;
  Limits Bounds;
  const ObjectChanges& Objects;
  CauseList& List;
  VolumeChanges VolumesChanged;
  FramePair Frames;
  LightPairs Lights;
  RecordChanges Records;
  PictureBoxes Boxes;
  NormalAngles Normals;
  SampleMixtures Mixtures;
  std::vector<Values> Layers;
  bool HasOtherForms = false;         // layers with different numbers of components
  std::map<int, std::set<int>> Cells; // cells of changed shapes, by finding
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
