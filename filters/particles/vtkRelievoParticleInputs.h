// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The inputs of particles, and keys of what they hold. What executes again and makes the same does
// not change a key, so what was computed from it stays.
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

// The first data of a port, or nullptr.
vtkDataObject* Get(vtkInformationVector** inputs, int port);

// These differ if anything was executed or modified.
std::vector<vtkMTimeType> GetStamps(vtkInformationVector** inputs);

// Asks for all of an input, at its first time.
void RequestWhole(vtkInformation* input);

// The first and the one after the last of so many particles that an output is asked for.
std::pair<vtkIdType, vtkIdType> GetPiece(vtkInformation* output, vtkIdType count);

// A hash of 64 bits over all that was added, in order.
class Key
{
public:
  Key& Add(double value);
  Key& Add(const std::string& text);
  Key& Add(vtkDataArray* array); // or nullptr
  // Points and cells: those of vtkPolyData and vtkImageData by value, others by their MTime.
  Key& AddShape(vtkDataSet* data);
  // The shapes of a data set or the leaves of a composite, and the arrays of this name.
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
