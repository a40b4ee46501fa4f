// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The velocity field of particles: the sum of a constant, the curl of noise, and an array of
// vectors.
#ifndef vtkRelievoParticleField_h
#define vtkRelievoParticleField_h

#include "vtkNew.h"

#include <glm/vec3.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkGenericCell;

class vtkRelievoParticleField
{
public:
  vtkRelievoParticleField();
  ~vtkRelievoParticleField();

  glm::dvec3 Velocity{ 0. };
  double NoiseSpeed = 0.; // rms
  double NoiseScale = 1.; // world units between corners of the noise's lattice
  unsigned int NoiseSeed = 0;
  double Near =
    0.; // typical upper bound of the distance between positions and the data that have the array

  // Sets an array of three-component vectors at the points or cells of the data. Returns the error,
  // or an empty text.
  std::string SetArray(vtkDataObject* data, const std::string& name);

  void ClearArray();

  // Whether the field is constant.
  bool IsUniform() const { return this->NoiseSpeed == 0. && this->Leaves.empty(); }

  // Reads the field; one for each thread.
  class Reader
  {
  public:
    explicit Reader(const vtkRelievoParticleField& field);
    ~Reader();

    // The velocity on a surface with this normal, 0 where the field is not finite. Noise is
    // tangential; the other terms need not be.
    glm::dvec3 OnSurface(const glm::dvec3& position, const glm::dvec3& normal);
    // The velocity in space.
    glm::dvec3 InSpace(const glm::dvec3& position);

  private:
    glm::dvec3 OfArray(const glm::dvec3& position);
    glm::dvec3 Gradient(const glm::dvec3& position, unsigned int which) const;
    glm::dvec3 Sum(const glm::dvec3& position, const glm::dvec3& noise);

    const vtkRelievoParticleField& Field;
    vtkNew<vtkGenericCell> Cell;
    std::vector<double> Weights;
  };

private:
  struct Leaf;
  std::vector<std::unique_ptr<Leaf>> Leaves;
};

#endif
