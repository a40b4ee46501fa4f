// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces of labels: distance to the shape that was cut into blocks, in both directions, error of
// normals, and time on one thread, in turn with peers; and triangles per second by threads.
#include "BenchSizes.h"
#include "RelievoBench.h"

#include "BlockShapes.h"
#include "FrameBench.h"
#include "Table.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkMath.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkRelievoSmoothBlocks.h>
#include <vtkSMPTools.h>
#include <vtkStaticCellLocator.h>
#include <vtkWindowedSincPolyDataFilter.h>
#include <vtksys/SystemTools.hxx>
#if __has_include(<vtkSurfaceNets3D.h>)
#include <vtkSurfaceNets3D.h>
#define RELIEVO_BENCH_NETS 1
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timed;
using relievoTest::Timing;

struct Way
{
  std::string Name;
  std::vector<vtkSmartPointer<vtkPolyDataAlgorithm>>
    Filters;                // the output of the last one is measured
  bool FaceNormals = false; // the triangles' own
};

vtkSmartPointer<vtkRelievoSmoothBlocks> Blocks(vtkImageData* labels, double strength)
{
  auto filter = vtkSmartPointer<vtkRelievoSmoothBlocks>::New();
  filter->SetInputData(labels);
  filter->SetStrength(strength);
  filter->SetCloseBorders(false); // like the peers
  filter->SetSeams(false);
  filter->SetNormals(
    strength > 0. ? vtkRelievoSmoothBlocks::ACROSS_MATERIALS : vtkRelievoSmoothBlocks::NO_NORMALS);
  return filter;
}

vtkSmartPointer<vtkDiscreteFlyingEdges3D> Edges(vtkImageData* labels)
{
  auto filter = vtkSmartPointer<vtkDiscreteFlyingEdges3D>::New();
  filter->SetInputData(labels);
  filter->SetValue(0, 1.);
  filter->SetComputeNormals(true);
  filter->SetComputeScalars(false);
  return filter;
}

std::vector<Way> Ways(vtkImageData* labels)
{
  std::vector<Way> ways;
  ways.push_back({ "cubes", { Blocks(labels, 0.) }, true });
  ways.push_back({ "smooth blocks", { Blocks(labels, 0.125) } });
  ways.push_back({ "smooth blocks, 0.25", { Blocks(labels, 0.25) } });
  ways.push_back({ "flying edges", { Edges(labels) } });
  vtkSmartPointer<vtkDiscreteFlyingEdges3D> edges = Edges(labels);
  edges->SetComputeNormals(false);
  auto sinc = vtkSmartPointer<vtkWindowedSincPolyDataFilter>::New();
  sinc->SetInputConnection(edges->GetOutputPort());
  sinc->SetNumberOfIterations(20);
  sinc->SetPassBand(0.1);
  sinc->SetNormalizeCoordinates(true);
  auto normals = vtkSmartPointer<vtkPolyDataNormals>::New();
  normals->SetInputConnection(sinc->GetOutputPort());
  normals->SetSplitting(false);
  normals->SetConsistency(false);
  ways.push_back({ "flying edges, sinc", { edges, sinc, normals } });
#ifdef RELIEVO_BENCH_NETS
  auto nets = vtkSmartPointer<vtkSurfaceNets3D>::New();
  nets->SetInputData(labels);
  nets->SetValue(0, 1.);
  nets->SetOutputMeshTypeToTriangles();
  auto netNormals = vtkSmartPointer<vtkPolyDataNormals>::New();
  netNormals->SetInputConnection(nets->GetOutputPort());
  netNormals->SetSplitting(false);
  netNormals->SetConsistency(false);
  ways.push_back({ "surface nets", { nets, netNormals } });
#endif
  return ways;
}

struct Errors
{
  double Hausdorff = 0.; // the larger of both directions
  double Distance = 0.;  // rms, from the surface to the shape
  double Normal = 0.;    // rms, degrees
};

// Samples are the middles of triangles and their corners.
Errors Measure(const BlockShape& shape, vtkPolyData* surface, bool faceNormals)
{
  Errors errors;
  double squares = 0.;
  double angles = 0.;
  vtkIdType count = 0;
  vtkIdType normalCount = 0;
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  const auto addNormal = [&](const double place[3], const double normal[3]) {
    const glm::dvec3 out = shape.NormalAt({ place[0], place[1], place[2] });
    const double angle = vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(&out[0], normal));
    // The normals of some peers point inwards.
    const double off = std::min(angle, faceNormals ? angle : 180. - angle);
    angles += off * off;
    ++normalCount;
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    double corners[4][3];
    std::fill(corners[3], corners[3] + 3, 0.);
    for (int c = 0; c < 3; ++c)
    {
      surface->GetPoint(ids->GetId(c), corners[c]);
      for (int axis = 0; axis < 3; ++axis)
      {
        corners[3][axis] += corners[c][axis] / 3.;
      }
    }
    if (!shape.IsMeasured({ corners[3][0], corners[3][1], corners[3][2] }))
    {
      continue;
    }
    for (const double* place : corners)
    {
      const double distance = std::abs(shape.DistanceAt({ place[0], place[1], place[2] }));
      errors.Hausdorff = std::max(errors.Hausdorff, distance);
      squares += distance * distance;
      ++count;
    }
    double normal[3];
    if (faceNormals)
    {
      double sides[2][3];
      vtkMath::Subtract(corners[1], corners[0], sides[0]);
      vtkMath::Subtract(corners[2], corners[0], sides[1]);
      vtkMath::Cross(sides[0], sides[1], normal);
      addNormal(corners[3], normal);
      continue;
    }
    for (int c = 0; c < 3; ++c)
    {
      normals->GetTuple(ids->GetId(c), normal);
      addNormal(corners[c], normal);
    }
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  for (const glm::dvec3& place : shape.Samples(4000))
  {
    double closest[3];
    vtkIdType id = 0;
    int part = 0;
    double distance2 = 0.;
    locator->FindClosestPoint(&place[0], closest, cell, id, part, distance2);
    errors.Hausdorff = std::max(errors.Hausdorff, std::sqrt(distance2));
  }
  errors.Distance = std::sqrt(squares / static_cast<double>(count));
  errors.Normal = std::sqrt(angles / static_cast<double>(normalCount));
  return errors;
}

std::vector<Timed> Works(std::vector<Way>& ways)
{
  std::vector<Timed> works(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    Way& way = ways[i];
    works[i].Work = [&way]() {
      way.Filters.front()->Modified();
      way.Filters.back()->Update();
    };
  }
  return works;
}

// INRIA's images: 256 bytes of text, then the voxels.
vtkSmartPointer<vtkImageReader2> InriaReader(
  const std::array<int, 3>& size, const std::array<double, 3>& spacing, int type)
{
  auto reader = vtkSmartPointer<vtkImageReader2>::New();
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1);
  reader->SetDataSpacing(spacing[0], spacing[1], spacing[2]);
  reader->SetDataScalarType(type);
  reader->SetDataByteOrderToLittleEndian();
  reader->SetHeaderSize(256);
  return reader;
}

// Labels of a brain atlas, a liver or a skull; null if the file is missing.
vtkSmartPointer<vtkImageData> RealLabels(const std::string& name)
{
  const char* folder = std::getenv("RELIEVO_DATA");
  const std::string path = std::string(folder ? folder : "build/data") + "/" + name;
  if (!vtksys::SystemTools::FileExists(path))
  {
    std::cerr << "relievo: bench: blocks: no " << path << "; tools/unpack-data --bench makes it\n";
    return nullptr;
  }
  vtkSmartPointer<vtkImageReader2> reader;
  if (name == "liver.inr")
  {
    reader = InriaReader({ 438, 353, 165 }, { 0.617, 0.617, 1.333 }, VTK_UNSIGNED_CHAR);
  }
  else if (name == "skull_2.9.inr")
  {
    // Densities: the file's name gives the threshold of bone.
    reader = InriaReader({ 64, 64, 64 }, { 3.94305, 3.94305, 3.65079 }, VTK_FLOAT);
    reader->SetFileName(path.c_str());
    reader->Update();
    auto bone = vtkSmartPointer<vtkImageData>::New();
    bone->CopyStructure(reader->GetOutput());
    bone->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    const auto* density = static_cast<float*>(reader->GetOutput()->GetScalarPointer());
    auto* label = static_cast<unsigned char*>(bone->GetScalarPointer());
    for (vtkIdType i = 0; i < bone->GetNumberOfPoints(); ++i)
    {
      label[i] = density[i] >= 2.9f ? 1 : 0;
    }
    return bone;
  }
  else
  {
    reader = vtkSmartPointer<vtkNIFTIImageReader>::New();
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

// Time and size of all surfaces between labels; the original shape is unknown.
void MeasureReal(const std::string& name, int rounds, Table& table)
{
  const vtkSmartPointer<vtkImageData> labels = RealLabels(name);
  if (!labels)
  {
    return;
  }
  vtkDataArray* array = labels->GetPointData()->GetScalars();
  std::set<int> found;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    found.insert(static_cast<int>(array->GetComponent(i, 0)));
  }
  found.erase(0);
  std::vector<Way> ways;
  vtkSmartPointer<vtkRelievoSmoothBlocks> outside = Blocks(labels, 0.125);
  ways.push_back({ "smooth blocks, outside", { outside } });
  vtkSmartPointer<vtkRelievoSmoothBlocks> blocks = Blocks(labels, 0.125);
  blocks->SetSurface(vtkRelievoSmoothBlocks::BETWEEN_LABELS);
  ways.push_back({ "smooth blocks", { blocks } });
  vtkSmartPointer<vtkDiscreteFlyingEdges3D> edges = Edges(labels);
  int value = 0;
  for (const int label : found)
  {
    edges->SetValue(value++, label);
  }
  ways.push_back({ "flying edges", { edges } });
#ifdef RELIEVO_BENCH_NETS
  auto nets = vtkSmartPointer<vtkSurfaceNets3D>::New();
  nets->SetInputData(labels);
  nets->SetOutputMeshTypeToTriangles();
  value = 0;
  for (const int label : found)
  {
    nets->SetValue(value++, label);
  }
  ways.push_back({ "surface nets", { nets } });
#endif
  const std::vector<Timing> times = TimeInTurn(Works(ways), rounds, 1);
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    const auto triangles =
      static_cast<double>(ways[i].Filters.back()->GetOutput()->GetNumberOfPolys());
    const double seconds = times[i].Median();
    table.AddRow({ name, std::to_string(found.size()), std::to_string(array->GetNumberOfTuples()),
      ways[i].Name, Number(triangles, 8), Number(1e3 * seconds),
      Number(1e-6 * triangles / seconds, 3), Number(LoadAverage(), 2) });
    std::cout << name << ", " << ways[i].Name << ": " << Number(1e3 * seconds) << " ms, "
              << Number(1e-6 * triangles / seconds, 3) << " M triangles/s" << std::endl;
  }
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchBlocks(const std::string& outDir, const BlockSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  vtkSMPTools::Initialize(1);
  Table table({ "shape", "blocks", "method", "triangles", "milliseconds", "ms per million blocks",
    "million triangles per second", "hausdorff blocks", "rms distance blocks", "rms normal degrees",
    "load" });
  for (const int size : sizes.Sizes)
  {
    for (const BlockShape& shape : BlockShapes(size))
    {
      const vtkSmartPointer<vtkImageData> labels = shape.Labels();
      std::vector<Way> ways = Ways(labels);
      const std::vector<Timing> times = TimeInTurn(Works(ways), sizes.Rounds, 1);
      for (std::size_t i = 0; i < ways.size(); ++i)
      {
        vtkPolyData* surface = ways[i].Filters.back()->GetOutput();
        const Errors errors = Measure(shape, surface, ways[i].FaceNormals);
        const double seconds = times[i].Median();
        const auto triangles = static_cast<double>(surface->GetNumberOfPolys());
        table.AddRow({ shape.Name, std::to_string(size), ways[i].Name,
          std::to_string(surface->GetNumberOfPolys()), Number(1e3 * seconds),
          Number(1e9 * seconds / std::pow(size, 3.)), Number(1e-6 * triangles / seconds, 3),
          Number(errors.Hausdorff), Number(errors.Distance), Number(errors.Normal),
          Number(LoadAverage(), 2) });
        std::cout << shape.Name << ' ' << size << ", " << ways[i].Name << ": "
                  << Number(1e3 * seconds) << " ms, " << Number(1e-6 * triangles / seconds, 3)
                  << " M triangles/s, Hausdorff " << Number(errors.Hausdorff) << ", rms "
                  << Number(errors.Distance) << ", normals " << Number(errors.Normal) << " degrees"
                  << std::endl;
      }
    }
  }
  Table real({ "data", "labels", "blocks", "method", "triangles", "milliseconds",
    "million triangles per second", "load" });
  for (const std::string& name : sizes.Data)
  {
    MeasureReal(name, std::max(sizes.Rounds / 2, 3), real);
  }
  vtkSMPTools::Initialize(0);
  const bool written = BenchBlockThreads(outDir, sizes) && table.WriteCsv(outDir + "/blocks.csv") &&
    real.WriteCsv(outDir + "/blocks-labels.csv");
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchBlocks(const std::string& outDir)
{
  return relievoBench::BenchBlocks(outDir, {});
}
