// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where particles start: evenly spread over what is seen or the space inside, or at given places.
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

  // Particles begin to end of count. A particle's place does not depend on begin and end. Empty if
  // nothing is seen.
  vtkRelievoParticleState Spread(vtkIdType begin, vtkIdType end, vtkIdType count) const;

  // Those at the points of the data, brought to the nearest place that is seen, or inside. Points
  // that are not finite start where Spread has them.
  vtkRelievoParticleState AtPoints(vtkDataSet* points, vtkIdType begin, vtkIdType end) const;

  // A box around all that is seen: false if nothing is.
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
  std::vector<double> Shares;      // area of the parts up to each
  std::vector<double> Areas;       // of the surfaces' polygons up to each, if there are surfaces
  std::vector<std::size_t> Firsts; // of each surface among the polygons
  glm::dvec3 Low;
  glm::dvec3 High;
  std::unique_ptr<vtkRelievoParticleInterior> Space; // where particles are inside
};

#endif
