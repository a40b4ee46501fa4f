// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFacts.h"

#include "Picture.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
constexpr int HistogramParts = 64;

std::vector<double> CountValues(vtkDataArray* array, const std::array<double, 2>& range)
{
  std::vector<double> counts(HistogramParts, 0.0);
  for (const auto each : vtk::DataArrayValueRange<1>(array))
  {
    const double value = static_cast<double>(each);
    if (std::isfinite(value))
    {
      const double place = HistogramParts * (value - range[0]) / (range[1] - range[0]);
      counts[static_cast<std::size_t>(std::clamp(place, 0.0, HistogramParts - 1.0))] += 1.0;
    }
  }
  return counts;
}
}

//------------------------------------------------------------------------------
std::optional<VolumeFacts> GetVolumeFacts(const Picture& picture)
{
  if (picture.IsEmpty())
  {
    return std::nullopt;
  }
  auto* volume = vtkVolume::SafeDownCast(picture.GetRenderer()->GetVolumes()->GetItemAsObject(0));
  auto* image =
    volume ? vtkImageData::SafeDownCast(volume->GetMapper()->GetInputDataObject(0, 0)) : nullptr;
  vtkDataArray* array = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!array)
  {
    return std::nullopt;
  }
  VolumeFacts facts;
  array->GetFiniteRange(facts.Range.data());
  if (!(facts.Range[0] < facts.Range[1]))
  {
    return std::nullopt;
  }
  static vtkDataArray* counted = nullptr;
  static vtkMTimeType when = 0;
  static std::vector<double> counts;
  if (array != counted || array->GetMTime() != when)
  {
    counts = CountValues(array, facts.Range);
    counted = array;
    when = array->GetMTime();
  }
  facts.Histogram = counts;
  vtkPiecewiseFunction* opacity = volume->GetProperty()->GetScalarOpacity();
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    opacity->GetNodeValue(i, node);
    if (node[0] >= facts.Range[0] && node[0] <= facts.Range[1])
    {
      facts.Opacity.push_back({ node[0], node[1] });
    }
  }
  const auto add = [&](double value, bool front) {
    const bool has = !facts.Opacity.empty() &&
      (front ? facts.Opacity.front()[0] : facts.Opacity.back()[0]) == value;
    if (!has)
    {
      facts.Opacity.insert(
        front ? facts.Opacity.begin() : facts.Opacity.end(), { value, opacity->GetValue(value) });
    }
  };
  add(facts.Range[0], true);
  add(facts.Range[1], false);
  return facts;
}
}
