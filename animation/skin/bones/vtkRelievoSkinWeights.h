// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** The bones that move a point, decided equally for all skinning code. */
#ifndef vtkRelievoSkinWeights_h
#define vtkRelievoSkinWeights_h

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"

#include <limits>
#include <string>

class vtkPolyData;

namespace relievo
{
/// The point arrays `joints` and `weights` of a mesh.
class SkinWeights
{
public:
  /// Returns "", or what is missing.
  std::string Read(vtkPolyData* mesh);

  const int* GetJoints(vtkIdType point) const { return this->First + this->Count * point; }
  const float* GetWeights(vtkIdType point) const { return this->FirstWeight + this->Count * point; }
  int GetCount() const { return this->Count; } ///< per point, including those without influence

private:
  vtkSmartPointer<vtkIntArray> Joints;
  vtkSmartPointer<vtkFloatArray> Weights;
  const int* First = nullptr;
  const float* FirstWeight = nullptr;
  int Count = 0;
};

/// Whether this weight counts, in a mesh with `bones` bones.
inline bool IsInfluence(int joint, float weight, std::size_t bones)
{
  return weight > 0.f && weight <= std::numeric_limits<float>::max() &&
    static_cast<std::size_t>(joint) < bones;
}
}

#endif
