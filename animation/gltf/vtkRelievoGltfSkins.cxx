// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfParts.h"

#include <cmath>

namespace relievo
{
//------------------------------------------------------------------------------
GltfSkin ReadGltfSkin(GltfDocument& document, const GltfNodes& nodes, std::size_t skin)
{
  const GltfValue value = document.Get("skins").At(skin);
  const GltfValue joints = value.Get("joints");
  const GltfValue inverse = value.Get("inverseBindMatrices");
  if (joints.GetSize() == 0)
  {
    joints.FailExpecting("the numbers of nodes");
  }
  const GltfNumbers* matrices = nullptr;
  if (inverse.IsThere())
  {
    matrices = &document.GetNumbers(inverse, { { "MAT4" }, { gltf::Float } });
    if (matrices->Count < joints.GetSize())
    {
      inverse.Fail("has " + std::to_string(matrices->Count) + " matrices, and the skin has " +
        std::to_string(joints.GetSize()) + " joints");
    }
  }
  GltfSkin result;
  for (std::size_t i = 0; i < joints.GetSize(); ++i)
  {
    const int node = joints.At(i).GetIndex("nodes", nodes.Numbers.size());
    glm::dmat4 offset(1.);
    for (int j = 0; matrices && j < 16; ++j)
    {
      const double number = matrices->At(i)[j];
      if (!std::isfinite(number))
      {
        inverse.Fail(
          "has a matrix with a number that is not finite, of joint " + std::to_string(i));
      }
      offset[j / 4][j % 4] = number;
    }
    result.Nodes.push_back(nodes.Get(static_cast<std::size_t>(node)));
    result.Offsets.push_back(offset);
  }
  return result;
}
}
