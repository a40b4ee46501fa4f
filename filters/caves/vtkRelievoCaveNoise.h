// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCaveNoise.h
 * @brief The two noises of caves at a position.
 */
#ifndef vtkRelievoCaveNoise_h
#define vtkRelievoCaveNoise_h

#include "vtkRelievoCaveField.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoNoiseCell.h"

namespace relievo
{
namespace // as the formulas
{
// One of the two noises. They are offset by part of a cell: every noise is 0 at the corners of its
// lattice, so a common lattice would put air there.
class CaveNoise
{
public:
  CaveNoise(const CaveField& field, const CavePlace& place, int which)
    : Seed(field.Seeds[which])
  {
    const NoiseCell x = NoiseCell::Of(place[0] + which * 0.5);
    const NoiseCell y = NoiseCell::Of(place[1] + which * 0.25);
    const NoiseCell z = NoiseCell::Of(place[2] + which * 0.125);
    this->Simplex =
      f64::relievoSimplexAt(f64::ivec3(x.Cell, y.Cell, z.Cell), f64::vec3(x.Part, y.Part, z.Part));
  }

  double Value() const { return f64::relievoSimplexNoiseIn(this->Simplex, this->Seed); }

  f64::vec3 Gradient() const
  {
    return f64::relievoSimplexNoiseGradientIn(this->Simplex, this->Seed);
  }

private:
  unsigned int Seed;
  f64::relievoSimplex Simplex;
};
}
}

#endif
