// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads binary STL: all whole triangles to the end of the file, whatever number it says. Corners at
// one place are one point; triangles that have fewer than three places are left out. The points and
// their order are those of vtkSTLReader, which takes five times as long to find them.
#ifndef BinarySTL_h
#define BinarySTL_h

#include "vtkPolyDataAlgorithm.h"

#include <cstddef>
#include <string>

namespace scene
{
class BinarySTL : public vtkPolyDataAlgorithm
{
public:
  static BinarySTL* New();
  vtkTypeMacro(BinarySTL, vtkPolyDataAlgorithm);

  // What comes before the triangles, and the bytes of each.
  static constexpr std::size_t HeadSize = 84;
  static constexpr std::size_t TriangleSize = 50;
  static constexpr double MostTriangles = 7e8; // whose corners have numbers of 32 bits

  void SetFileName(const char* name) { this->FileName = name; }

protected:
  BinarySTL() { this->SetNumberOfInputPorts(0); }
  ~BinarySTL() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  std::string FileName;

  BinarySTL(const BinarySTL&) = delete;
  void operator=(const BinarySTL&) = delete;
};
}

#endif
