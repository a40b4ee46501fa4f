// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faces of a cube around an eye, in camera space: the axes to the right, downwards and outwards of
// each face.
#ifndef vtkRelievoCubeFaces_h
#define vtkRelievoCubeFaces_h

namespace relievo
{
constexpr int CubeFaces = 6;

constexpr double CubeAxes[CubeFaces][3][3] = {
  { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },   // front
  { { 0, 0, -1 }, { 0, 1, 0 }, { 1, 0, 0 } },  // right
  { { -1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 } }, // back
  { { 0, 0, 1 }, { 0, 1, 0 }, { -1, 0, 0 } },  // left
  { { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } },  // up
  { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } },  // down
};
}

#endif
