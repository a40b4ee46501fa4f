// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Starting positions: evenly spread over the visible surface or the space inside, or given.
#ifndef vtkRelievoParticleStart_h
#define vtkRelievoParticleStart_h

#include "vtkRelievoParticleInterior.h"
#include "vtkRelievoParticleMaps.h"
#include "vtkRelievoParticleState.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkDataSet;

class vtkRelievoParticleStart
{
public:
  vtkRelievoParticleStart(const vtkRelievoParticleMaps& maps, bool inside, unsigned int seed);

  // Particles begin to end of count. A particle's position does not depend on begin and end. Empty
  // if nothing is visible.
  vtkRelievoParticleState Spread(vtkIdType begin, vtkIdType end, vtkIdType count) const;

  // Starts at the points of the data, each moved to the nearest visible position, or inside.
  // Non-finite points start as in Spread.
  vtkRelievoParticleState AtPoints(vtkDataSet* points, vtkIdType begin, vtkIdType end) const;

  // A box around everything visible; false if nothing is.
  bool GetBox(glm::dvec3& low, glm::dvec3& high) const;

private:
  struct Part
  {
    int View;
    std::size_t Texel;
  };
  void SpreadOne(vtkIdType i, vtkIdType count, glm::dvec3& position, int& view) const;
  void MeasurePolygons();
  bool SpreadOnPolygons(vtkIdType i, double share, glm::dvec3& position, int& view) const;

  const vtkRelievoParticleMaps& Maps;
  bool Inside;
  unsigned int Seed;
  std::vector<Part> Parts;         // texels that no other view sees better
  std::vector<double> Shares;      // running sum of the parts' areas
  std::vector<double> Areas;       // running sum of the polygons' areas, if there are surfaces
  std::vector<std::size_t> Firsts; // number of each surface's first polygon
  glm::dvec3 Low;
  glm::dvec3 High;
  std::unique_ptr<vtkRelievoParticleInterior> Space; // for particles inside
};

#endif
