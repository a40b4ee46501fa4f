// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lists of clusters against distances: every lamp that reaches a point is in the list of the
// point's cell, in the lamps' order, and how many more are; which lamps cast shadows.
#include "Check.h"
#include "LampScenes.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkRelievoLampClusters.h>
#include <vtkRelievoLampList.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

namespace testLampClusters
{
namespace
{
using namespace relievoTest;

const glm::dvec3 White(1.0);

vtkRelievoFrameCamera MakeView(int width, int height, bool parallel, double near, double far)
{
  vtkRelievoFrameCamera view;
  view.Viewport[2] = width;
  view.Viewport[3] = height;
  view.Near = near;
  view.Far = far;
  view.Parallel = parallel;
  const double aspect = static_cast<double>(width) / height;
  view.WorldToView =
    glm::lookAt(glm::dvec3(2.5, 3.0, 6.0), glm::dvec3(0.0, 0.5, 0.0), glm::dvec3(0.0, 1.0, 0.0));
  view.ViewToNDC = parallel ? glm::ortho(-3.0 * aspect, 3.0 * aspect, -3.0, 3.0, near, far)
                            : glm::perspective(0.7, aspect, near, far);
  return view;
}

void TestLamps(
  const vtkRelievoFrameCamera& view, const std::vector<Lamp>& given, const std::string& what)
{
  const int count = static_cast<int>(given.size());
  vtkNew<vtkRelievoLamps> lamps;
  lamps->SetInputData(ToPolyData(given));
  RELIEVO_CHECK(lamps->GetNumberOfPoints() == count);
  vtkRelievoLampList list;
  list.Take(view, { lamps.Get() });
  RELIEVO_CHECK(list.GetNumberGiven() == count);
  vtkRelievoLampClusters clusters;
  clusters.Build(view, list);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  long long lost = 0;
  long long listed = 0;
  long long needed = 0;
  bool ordered = true;
  const glm::dmat4 back = glm::inverse(view.ViewToNDC);
  for (int i = 0; i < 4000; ++i)
  {
    const int x = static_cast<int>(share(random) * view.Viewport[2]);
    const int y = static_cast<int>(share(random) * view.Viewport[3]);
    // Where the lamps are: at the distance of the scene.
    const auto depth =
      static_cast<float>(std::clamp(4.0 + 6.0 * share(random), view.Near, view.Far));
    const glm::dvec4 clip = view.ViewToNDC * glm::dvec4(0.0, 0.0, -depth, 1.0);
    const glm::dvec4 point = back *
      glm::dvec4((2.0 * (x + 0.5) / view.Viewport[2] - 1.0) * clip.w,
        (2.0 * (y + 0.5) / view.Viewport[3] - 1.0) * clip.w, clip.z, clip.w);
    const float place = view.Parallel ? depth : std::log2(depth);
    const int slice = std::clamp(
      static_cast<int>(std::floor(place * clusters.GetSliceScale() + clusters.GetSliceOffset())), 0,
      clusters.GetSlices() - 1);
    const std::size_t cell =
      (static_cast<std::size_t>(slice) * clusters.GetRows() + y / clusters.GetTile()) *
        clusters.GetColumns() +
      x / clusters.GetTile();
    const auto from = clusters.GetLists().begin() + static_cast<int>(clusters.GetCells()[cell]);
    const auto to = clusters.GetLists().begin() + static_cast<int>(clusters.GetCells()[cell + 1]);
    ordered = ordered && std::is_sorted(from, to);
    listed += to - from;
    for (std::size_t k = 0; k < list.GetLamps().size(); ++k)
    {
      const double r = list.GetTexels()[8 * k + 3];
      if (glm::length(glm::dvec3(point) / point.w - list.GetLamps()[k].Sphere.Center) < r)
      {
        ++needed;
        lost += std::binary_search(from, to, static_cast<float>(k)) ? 0 : 1;
      }
    }
  }
  std::cout << what << ": " << clusters.GetColumns() << " x " << clusters.GetRows() << " x "
            << clusters.GetSlices() << " cells, " << clusters.GetLists().size() << " entries, "
            << static_cast<double>(listed) / 4000 << " listed, "
            << static_cast<double>(needed) / 4000 << " needed a point\n";
  // Floats in the lists are whole numbers up to 2^24.
  RELIEVO_CHECK(clusters.GetLists().size() <= 1 << 24);
  RELIEVO_CHECK(lost == 0);
  RELIEVO_CHECK(ordered);
  RELIEVO_CHECK(needed > 0);
}

void TestView(const vtkRelievoFrameCamera& view, int count, double radius, const std::string& what)
{
  TestLamps(view, RandomLamps(count, radius, true), what);
}

// Which lamps cast: by the array, and by size; and that no strength jumps while lamps move.
void TestChoice()
{
  const vtkRelievoFrameCamera view = MakeView(400, 300, false, 0.1, 100.0);
  const auto choose = [&view](const std::vector<Lamp>& lamps, const std::vector<double>& casts,
                        int largest) {
    vtkSmartPointer<vtkPolyData> data = ToPolyData(lamps);
    vtkNew<vtkDoubleArray> array;
    array->SetName("casts");
    for (const double each : casts)
    {
      array->InsertNextValue(each);
    }
    if (!casts.empty())
    {
      data->GetPointData()->AddArray(array);
    }
    vtkNew<vtkRelievoLamps> set;
    set->SetInputData(data);
    set->Share(nullptr);
    vtkRelievoLampList list;
    list.Take(view, { set });
    std::vector<double> strengths;
    const vtkRelievoLampList casting = list.TakeCasting(largest, strengths);
    RELIEVO_CHECK(list.GetLamps().size() + casting.GetLamps().size() == lamps.size());
    RELIEVO_CHECK(list.GetTexels().size() == 8 * list.GetLamps().size());
    RELIEVO_CHECK(casting.GetTexels().size() == 8 * casting.GetLamps().size());
    std::vector<double> all(lamps.size(), 0.0); // by lamp
    for (std::size_t i = 0; i < strengths.size(); ++i)
    {
      const auto place = casting.GetLamps()[i].Row - set->GetSharedRows().data();
      all[static_cast<std::size_t>(place) / set->GetRowWidth()] = strengths[i];
      RELIEVO_CHECK(
        casting.GetTexels()[8 * i + 3] == static_cast<float>(casting.GetLamps()[i].Row[3]));
    }
    return all;
  };
  std::vector<Lamp> lamps;
  for (int i = 0; i < 12; ++i)
  {
    lamps.push_back({ glm::dvec3(0.3 * i - 1.5, 0.0, 0.0), 0.3 + 0.1 * i, 1.0, White });
  }
  const std::vector<double> three = choose(lamps, {}, 3);
  RELIEVO_CHECK(std::count(three.begin(), three.end(), 1.0) == 3);
  RELIEVO_CHECK(three[11] == 1.0 && three[10] == 1.0 && three[9] == 1.0);
  RELIEVO_CHECK(choose(lamps, {}, 0) == std::vector<double>(12, 0.0));
  std::vector<double> casts(12, -1.0);
  casts[0] = 1.0;
  casts[11] = 0.0;
  const std::vector<double> named = choose(lamps, casts, 2);
  RELIEVO_CHECK(named[0] == 1.0 && named[11] == 0.0 && named[10] == 1.0 && named[9] == 1.0);
  RELIEVO_CHECK(std::count(named.begin(), named.end(), 0.0) == 9);
  const std::vector<double> all = choose(lamps, std::vector<double>(12, 1.0), 0);
  RELIEVO_CHECK(std::count(all.begin(), all.end(), 0.0) == 4);

  // Two lamps, of which one may cast: each grows while the other shrinks.
  std::vector<double> before;
  double jump = 0.0;
  double most[2] = { 0.0, 0.0 };
  constexpr int Steps = 400;
  for (int i = 0; i <= Steps; ++i)
  {
    const double t = static_cast<double>(i) / Steps;
    const std::vector<double> now =
      choose({ { glm::dvec3(-1.0, 0.0, 5.0 * t - 2.5), 1.0, 1.0, White },
               { glm::dvec3(1.0, 0.0, 2.5 - 5.0 * t), 1.0, 1.0, White } },
        {}, 1);
    for (std::size_t k = 0; k < now.size(); ++k)
    {
      jump = before.empty() ? 0.0 : std::max(jump, std::abs(now[k] - before[k]));
      most[k] = std::max(most[k], now[k]);
    }
    RELIEVO_CHECK(now[0] == 0.0 || now[1] == 0.0);
    before = now;
  }
  RELIEVO_CHECK_AT_MOST(jump, 0.15, "largest change of a shadow's strength in a step");
  RELIEVO_CHECK(most[0] == 1.0 && most[1] == 1.0);
}
}

RELIEVO_TEST_CASE(testLampClusters)
{
  relievoTest::Session session;
  const vtkRelievoFrameCamera usual = MakeView(600, 600, false, 2.0, 14.0);
  TestView(usual, 1, 9.0, "one lamp");
  TestView(usual, 1000, 0.3, "1000 lamps");
  TestView(usual, 1000, 3.0, "1000 large lamps");
  TestView(usual, 10000, 0.1, "10000 lamps");
  TestView(usual, 100000, 0.05, "100000 lamps");
  // Cells that suit the many small ones would list the few large ones 100 million times.
  std::vector<Lamp> mixed = RandomLamps(20000, 0.03, true);
  for (const Lamp& lamp : RandomLamps(100, 6.0, true))
  {
    mixed.push_back(lamp);
  }
  TestLamps(usual, mixed, "20000 small lamps and 100 large ones");
  TestView(MakeView(600, 600, true, 2.0, 14.0), 1000, 0.3, "parallel");
  TestView(MakeView(600, 600, true, -5.0, 14.0), 1000, 0.3, "parallel, from behind the eye");
  TestView(MakeView(1, 3, false, 2.0, 14.0), 1000, 0.3, "1 x 3 pixels");
  TestView(MakeView(333, 77, false, 1e-4, 1e3), 1000, 0.3, "far / near of 1e7");
  TestChoice();
  return session.Result();
}
}
