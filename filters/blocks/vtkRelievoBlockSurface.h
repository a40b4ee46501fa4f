// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockSurface.h
 * @brief The surface of labelled blocks with moved vertices, as quads that share them.
 *
 * Slices of blocks are made in slabs on all threads: once to count, once to write. Each vertex and
 * each face, and the order of every sum, follow from the blocks around it alone. So the result does
 * not depend on threads, and no part of the surface depends on the rest.
 */
#ifndef vtkRelievoBlockSurface_h
#define vtkRelievoBlockSurface_h

#include "vtkRelievoBlockFaces.h"
#include "vtkRelievoBlockRule.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <set>

class vtkDataArray;
class vtkFloatArray;

namespace relievo
{
struct BlockNoise
{
  double Amplitude = 0.; // blocks
  double Scale = 16.;    // blocks of a cell of the noise
  unsigned int Seed = 0;
  bool Solid = false; // three dimensions; otherwise constant along the axis that points up
};

struct BlockSettings
{
  FaceChoice Faces;
  double Strength = 0.125;
  std::set<vtkTypeInt64> Rigid;
  std::set<vtkTypeInt64> Level;
  int Up = 2;
  BlockNoise Noise;
  bool Normals = true;
  bool Seams = true;
  bool DoublePoints = false;
  bool KeepOffsets = false;
  // Vertex 0 has these block coordinates (whole, or half for labels on points). A vertex lies at
  // Origin + Axes * coordinates, with one column per axis.
  std::array<double, 3> First = {};
  std::array<double, 3> Origin = {};
  double Axes[3][3] = {}; // [row][column]
  // Called from the caller's thread with the fraction done; false stops.
  std::function<bool(double)> GoOn;
  // Called with the numbers of vertices, faces and seams before they are made; false stops.
  std::function<bool(vtkIdType, vtkIdType, vtkIdType)> HasRoom;
};

/** An edge that is not used exactly twice; corners are vertices of the surface. */
struct BlockSeam
{
  vtkIdType Points[2];
  int Uses;
  std::array<int, 3> Vertex; // the lower one
};

struct BlockFace
{
  vtkTypeUInt32 Points[4]; // counterclockwise from outside; cut from the first to the third
  vtkIdType Owner;         // index of its block in the array of labels
  unsigned char Axis;
  bool Low;            // the owner is the lower of the two blocks
  unsigned char First; // which corner comes first: 0 is the lowest along both axes
};

/**
 * An array with uninitialised values: each thread first writes its own pages, so they lie near it.
 */
template <typename T>
class Unset
{
public:
  void Allocate(vtkIdType size)
  {
    this->Values.reset(new T[size]);
    this->Size = size;
  }
  vtkIdType GetSize() const { return this->Size; }
  T& operator[](vtkIdType i) { return this->Values[i]; }
  const T& operator[](vtkIdType i) const { return this->Values[i]; }

private:
  std::unique_ptr<T[]> Values;
  vtkIdType Size = 0;
};

struct BlockSurface
{
  vtkSmartPointer<vtkDataArray> Points;
  vtkSmartPointer<vtkFloatArray> Normals; // 0 where the faces' normals cancel out
  Unset<BlockRule::Offset> Offsets;       // movements in blocks; with KeepOffsets
  Unset<BlockFace> Faces;
  std::vector<BlockSeam> Seams;
  vtkIdType NullNormals = 0; // vertices where the faces' normals cancel out
};

/** Whether a sum of area vectors, in blocks, is zero but for rounding. */
inline bool IsNull(const std::array<double, 3>& area)
{
  return area[0] * area[0] + area[1] * area[1] + area[2] * area[2] < 1e-18;
}

/** The area vector, in blocks, of a face with moved corners, in the order of BlockFace. */
std::array<double, 3> AreaOf(int axis, const BlockRule::Offset* const corners[4]);

enum class Made
{
  Done,
  Stopped, // by GoOn or HasRoom
  TooLarge // 2^32 vertices or more
};

Made MakeBlockSurface(
  const BlockLabels& labels, const BlockSettings& settings, BlockSurface& surface);
}

#endif
