// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lattices of samples: as many places in each pixel as asked for, spread evenly, and a raster whose
// cells are these places of all pixels, each of one pixel.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkRelievoSampleLattice.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace testSampleLattice
{
namespace
{
// Cells of all pixels lie in the raster, none twice, and the projection has each where it is.
void CheckRaster(const vtkRelievoSampleLattice& lattice, const int part[4], const std::string& name)
{
  const glm::ivec2 pixels(part[2], part[3]);
  const glm::ivec2 size = lattice.GetSize(pixels);
  const glm::ivec2 viewport(40, 30);
  const glm::dmat4 toRaster = lattice.GetToRaster(viewport, part);
  std::set<std::pair<int, int>> known;
  std::vector<int> first;
  double off = 0.0;
  bool inside = true;
  bool numbered = true;
  for (int y = 0; y < pixels.y; ++y)
  {
    for (int x = 0; x < pixels.x; ++x)
    {
      std::vector<int> numbers;
      for (const glm::ivec2& cell : lattice.GetCells())
      {
        const glm::ivec2 own =
          lattice.GetOrigin(pixels) + x * lattice.GetRight() + y * lattice.GetUp() + cell;
        inside = inside && own == glm::clamp(own, glm::ivec2(0), size - 1);
        known.emplace(own.x, own.y);
        const glm::ivec2 steps = own * lattice.GetNumberStep();
        numbers.push_back((steps.x + steps.y) % lattice.GetNumberOfSamples());
        const glm::dvec2 place = glm::dvec2(part[0] + x, part[1] + y) + lattice.GetPlace(cell);
        const glm::dvec2 ndc = 2.0 * place / glm::dvec2(viewport) - 1.0;
        const glm::dvec4 drawn = toRaster * glm::dvec4(ndc, 0.25, 1.0);
        const glm::dvec2 there = 0.5 * (glm::dvec2(drawn) + 1.0) * glm::dvec2(size);
        off = std::max(off, glm::length(there - glm::dvec2(own) - 0.5));
      }
      // A number for each sample of a pixel, and the numbers of all pixels alike.
      first = first.empty() ? numbers : first;
      numbered = numbered && numbers == first &&
        std::set<int>(numbers.begin(), numbers.end()).size() == numbers.size();
    }
  }
  RELIEVO_CHECK(inside);
  RELIEVO_CHECK(numbered);
  RELIEVO_CHECK(known.size() == lattice.GetCells().size() * pixels.x * pixels.y);
  RELIEVO_CHECK_AT_MOST(off, 1e-9, name);
}
}

RELIEVO_TEST_CASE(testSampleLattice)
{
  relievoTest::Session session;
  for (const int samples : { 1, 2, 3, 5, 6, 7, 8, 16, 24, 31, 41, 64, 256 })
  {
    const vtkRelievoSampleLattice lattice(samples);
    const std::string name = std::to_string(samples) + " samples";
    const std::vector<glm::ivec2>& cells = lattice.GetCells();
    RELIEVO_CHECK(lattice.GetNumberOfSamples() == samples);
    std::vector<double> levels[2];
    glm::dvec2 mean(0.0);
    double least = 1.0;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const glm::dvec2 place = lattice.GetPlace(cells[i]);
      RELIEVO_CHECK(place == glm::clamp(place, glm::dvec2(0.0), glm::dvec2(1.0)));
      mean += place / static_cast<double>(samples);
      levels[0].push_back(place.x);
      levels[1].push_back(place.y);
      for (std::size_t j = 0; j < i; ++j)
      {
        // Pixels go on.
        const glm::dvec2 step = place - lattice.GetPlace(cells[j]);
        least = std::min(least, glm::length(step - glm::round(step)));
      }
      RELIEVO_CHECK(
        glm::length(place - 0.5) >= glm::length(lattice.GetPlace(cells[0]) - 0.5) - 1e-12);
    }
    RELIEVO_CHECK_AT_MOST(glm::length(mean - 0.5), 1e-9, name);
    double uneven = 0.0; // of the steps between places, in x or in y alone
    for (std::vector<double>& each : levels)
    {
      std::sort(each.begin(), each.end());
      for (std::size_t i = 1; i < each.size(); ++i)
      {
        uneven = std::max(uneven, std::abs(each[i] - each[i - 1] - 1.0 / samples));
      }
    }
    RELIEVO_CHECK_AT_MOST(uneven, 1e-9, name);
    // Points of a hexagonal lattice would be 1.07 / sqrt(samples) apart.
    RELIEVO_CHECK(samples < 7 || least > 0.7 / std::sqrt(samples));
    const int whole[4] = { 0, 0, 40, 30 };
    const int part[4] = { 11, 7, 13, 5 };
    CheckRaster(lattice, whole, name);
    CheckRaster(lattice, part, name);
  }
  return session.Result();
}
}
