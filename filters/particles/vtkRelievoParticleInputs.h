// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The inputs of particles, and keys of their content. An input that executes again with the same
// result keeps its key, so cached results stay valid.
#ifndef vtkRelievoParticleInputs_h
#define vtkRelievoParticleInputs_h

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkInformation;
class vtkInformationVector;

namespace vtkRelievoParticleInputs
{
enum Port
{
  SURFACE,
  IMAGES,
  POINTS,
  FIELD,
  PORTS
};

// The first data object of a port, or nullptr.
vtkDataObject* Get(vtkInformationVector** inputs, int port);

// Time stamps that change if any input executes or is modified.
std::vector<vtkMTimeType> GetStamps(vtkInformationVector** inputs);

// Requests the whole input at its first time step.
void RequestWhole(vtkInformation* input);

// The range [first, end) of the particles that an output is asked for.
std::pair<vtkIdType, vtkIdType> GetPiece(vtkInformation* output, vtkIdType count);

// A 64-bit hash of everything added, in order.
class Key
{
public:
  Key& Add(double value);
  Key& Add(const std::string& text);
  Key& Add(vtkDataArray* array); // or nullptr
  // Points and cells: vtkPolyData and vtkImageData by value, others by MTime.
  Key& AddShape(vtkDataSet* data);
  // The shapes of a data set or of a composite's leaves, and their arrays of this name.
  Key& AddData(vtkDataObject* data, const std::string& array);
  // Depth images of a port.
  Key& AddImages(vtkInformationVector* images);

  bool operator==(const Key& other) const { return this->Hash == other.Hash; }

private:
  void AddWord(std::uint64_t word);
  void AddBytes(const void* bytes, std::size_t count);

  std::uint64_t Hash = 0;
};
}

#endif
