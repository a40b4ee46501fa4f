// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerColors.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRelievoColorRange.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoLayerCatalogue.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
struct Extremes
{
  double From = std::numeric_limits<double>::infinity();
  double To = -std::numeric_limits<double>::infinity();
};

Extremes GetFiniteExtremes(vtkDataArray* array, int component)
{
  Extremes extremes;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, component);
    if (std::isfinite(value))
    {
      extremes.From = std::min(extremes.From, value);
      extremes.To = std::max(extremes.To, value);
    }
  }
  if (relievo::IsOneValue(
        { extremes.From, extremes.To }, relievo::GetRounding(array->GetDataType())))
  {
    const std::array<double, 2> range = relievo::GetRangeOfOneValue(extremes.From);
    return { range[0], range[1] };
  }
  extremes.To = std::max(extremes.From, extremes.To); // no values: infinite
  return extremes;
}

float GetShare(double value, const Extremes& extremes)
{
  const double t = (value - extremes.From) / (extremes.To - extremes.From);
  return static_cast<float>(std::min(1.0, std::max(0.0, t)));
}

glm::vec3 GetMapped(float share, const std::vector<std::array<float, 3>>& map)
{
  const float place = share * static_cast<float>(map.size() - 1);
  const auto first = static_cast<std::size_t>(place);
  const std::array<float, 3>& low = map[first];
  const std::array<float, 3>& high = map[std::min(first + 1, map.size() - 1)];
  return glm::mix(glm::vec3(low[0], low[1], low[2]), glm::vec3(high[0], high[1], high[2]),
    place - static_cast<float>(first));
}
}

//------------------------------------------------------------------------------
std::vector<unsigned char> vtkRelievoLayerColors::Make(vtkImageData* image,
  const std::string& layer, bool visibility, const double range[2],
  const std::vector<std::array<float, 3>>& map, double shown[2], bool& same)
{
  vtkDataArray* array = image->GetPointData()->GetArray(layer.c_str());
  const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
  std::vector<unsigned char> colors(static_cast<std::size_t>(image->GetNumberOfPoints()) * 4, 0);
  const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::Find(layer);
  const bool ids = known.Kind == vtkRelievoLayer::ID;
  const bool light = known.Kind == vtkRelievoLayer::COLOR && known.Type == VTK_FLOAT;
  const bool black = known.Source == vtkRelievoLayer::FROM_PICTURE; // black is a colour, too
  const int components = array ? array->GetNumberOfComponents() : 1;
  Extremes extremes[3];
  for (int c = 0; c < std::min(3, components) && !ids && array; ++c)
  {
    extremes[c] = GetFiniteExtremes(array, c);
    if (visibility || known.Kind == vtkRelievoLayer::SHARE)
    {
      extremes[c] = Extremes{ 0.0, 1.0 };
    }
    else if (known.Kind == vtkRelievoLayer::VECTOR)
    {
      extremes[c] = Extremes{ -1.0, 1.0 };
    }
    else if (known.Kind == vtkRelievoLayer::COLOR)
    {
      extremes[c] = Extremes{ 0.0, known.Type == VTK_UNSIGNED_CHAR ? 255.0 : 1.0 };
    }
    if (range[0] < range[1])
    {
      extremes[c] = Extremes{ range[0], range[1] };
    }
  }
  vtkDataArray* depth = visibility ? image->GetPointData()->GetArray("depth") : nullptr;
  shown[0] = ids ? 0.0 : extremes[0].From;
  shown[1] = ids ? 0.0 : extremes[0].To;
  same = count > 0;
  for (int c = 0; c < components && same; ++c)
  {
    const double at = array->GetComponent(0, c);
    for (vtkIdType i = 1; i < count && same; ++i)
    {
      same = array->GetComponent(i, c) == at;
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double first = array->GetComponent(i, 0);
    glm::vec3 color(0.0f);
    bool there = false;
    if (ids)
    {
      there = first >= 0.0;
      color = relievo::f32::relievoHashColor(static_cast<glm::uint>(there ? first : 0.0));
    }
    else if (components < 3)
    {
      there = std::isfinite(first) && (!depth || std::isfinite(depth->GetComponent(i, 0)));
      const float share = GetShare(there ? first : extremes[0].From, extremes[0]);
      color = visibility || known.Kind == vtkRelievoLayer::SHARE ? glm::vec3(share)
                                                                 : GetMapped(share, map);
    }
    else
    {
      bool zero = true;
      there = true;
      for (int c = 0; c < 3; ++c)
      {
        const double value = array->GetComponent(i, c);
        there = there && std::isfinite(value);
        zero = zero && value == 0.0;
        color[c] = GetShare(value, extremes[c]);
      }
      color = light ? relievo::f32::relievoSrgbColorFromLinear(color) : color;
      there = there && (black || !zero);
    }
    if (there)
    {
      for (int c = 0; c < 3; ++c)
      {
        colors[4 * i + c] = static_cast<unsigned char>(std::lround(255.0f * color[c]));
      }
      colors[4 * i + 3] = 255;
    }
  }
  return colors;
}
