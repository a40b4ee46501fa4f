// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces of a surface of blocks against the whole, bit for bit: as a pipeline asks for them, cut by
// hand into unequal chunks with two layers of ghosts, labels on cells and on points; any number of
// threads; ghost cells of the output.
#include "BlockScenes.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoSmoothBlocks.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkImageAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoThreads.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTrivialProducer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace testSmoothBlocksPieces
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoSmoothBlocks;

constexpr int Size[] = { 23, 21, 37 };

vtkTypeInt64 LabelAt(int i, int j, int k)
{
  const vtkTypeInt64 any = AnyOf(9, 5)(i / 2, j / 2, k / 3);
  return any + AnyOf(10, 9)(i, j, k) / 8;
}

void Fill(vtkImageData* image, bool onPoints)
{
  int extent[6];
  image->GetExtent(extent);
  const int less = onPoints ? 0 : 1;
  vtkNew<vtkIntArray> labels;
  labels->SetName("labels");
  for (int k = extent[4]; k <= extent[5] - less; ++k)
  {
    for (int j = extent[2]; j <= extent[3] - less; ++j)
    {
      for (int i = extent[0]; i <= extent[1] - less; ++i)
      {
        labels->InsertNextValue(static_cast<int>(LabelAt(i, j, k)));
      }
    }
  }
  vtkDataSetAttributes* data = image->GetCellData();
  if (onPoints)
  {
    data = image->GetPointData();
  }
  data->SetScalars(labels);
}

// A source that makes only the requested part.
class LabelSource : public vtkImageAlgorithm
{
public:
  static LabelSource* New();
  vtkTypeMacro(LabelSource, vtkImageAlgorithm);
  bool OnPoints = false;

protected:
  LabelSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const int less = this->OnPoints ? 1 : 0;
    const int extent[] = { 0, Size[0] - less, 0, Size[1] - less, 0, Size[2] - less };
    const double origin[] = { 1. / 3., -7., 1e3 };
    const double spacing[] = { 0.1, 0.3, 0.7 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkDataObject::ORIGIN(), origin, 3);
    info->Set(vtkDataObject::SPACING(), spacing, 3);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkImageData* image = vtkImageData::GetData(info);
    image->SetExtent(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
    image->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
    image->SetSpacing(info->Get(vtkDataObject::SPACING()));
    Fill(image, this->OnPoints);
    return 1;
  }
};
vtkStandardNewMacro(LabelSource);

void SetUp(Filter* filter, int options)
{
  filter->SetNormals(options == 1 ? Filter::WITHIN_MATERIALS : Filter::ACROSS_MATERIALS);
  filter->SetSurface(options == 2 ? Filter::BETWEEN_LABELS : Filter::OUTSIDE);
  filter->SetTextureCoordinates(options == 1);
  filter->SetMaterialWeights(options == 1);
  for (int label = 1; label < 6; ++label)
  {
    filter->AddWeightedLabel(label);
  }
  filter->SetNoiseAmplitude(options == 1 ? 0.3 : 0.);
  filter->SetNoiseScale(5.3);
  if (options == 1)
  {
    filter->AddRigidLabel(2);
    filter->AddLevelLabel(3);
  }
}

// A polygon with all that its points have, and its labels: to be compared bit for bit.
using Polygon = std::vector<double>;

void AddPolygons(vtkPolyData* surface, std::vector<Polygon>& polygons, bool ghosts = false)
{
  vtkUnsignedCharArray* marks = surface->GetCellGhostArray();
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    if (marks && marks->GetValue(i) && !ghosts)
    {
      continue;
    }
    Polygon polygon;
    surface->GetPolys()->GetCellAtId(i, points);
    for (vtkIdType p = 0; p < points->GetNumberOfIds(); ++p)
    {
      double place[3];
      surface->GetPoint(points->GetId(p), place);
      polygon.insert(polygon.end(), place, place + 3);
      for (int a = 0; a < surface->GetPointData()->GetNumberOfArrays(); ++a)
      {
        vtkDataArray* array = surface->GetPointData()->GetArray(a);
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          polygon.push_back(array->GetComponent(points->GetId(p), c));
        }
      }
    }
    for (const char* name : { "material", "neighbor" })
    {
      vtkDataArray* array = surface->GetCellData()->GetArray(name);
      polygon.push_back(array ? array->GetComponent(i, 0) : -1.);
    }
    polygons.push_back(polygon);
  }
}

void AddSeams(vtkPolyData* seams, std::vector<Polygon>& lines)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < seams->GetLines()->GetNumberOfCells(); ++i)
  {
    seams->GetLines()->GetCellAtId(i, points);
    Polygon line(6);
    seams->GetPoint(points->GetId(0), line.data());
    seams->GetPoint(points->GetId(1), line.data() + 3);
    line.push_back(seams->GetCellData()->GetArray("uses")->GetComponent(i, 0));
    lines.push_back(line);
  }
}

void CheckSame(std::vector<Polygon> found, std::vector<Polygon> expected, const std::string& what)
{
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  RELIEVO_CHECK_THAT(!expected.empty() && found == expected,
    what + ": " + std::to_string(found.size()) + " polygons differ from the whole's " +
      std::to_string(expected.size()));
}

// Updates the seams alone.
void UpdateSeams(Filter* filter, int piece, int count)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkNew<vtkInformationVector> asked;
  asked->SetNumberOfInformationObjects(2);
  vtkInformation* seams = asked->GetInformationObject(1);
  seams->Set(SDDP::UPDATE_PIECE_NUMBER(), piece);
  seams->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), count);
  seams->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  filter->Modified();
  SDDP::SafeDownCast(filter->GetExecutive())->Update(1, asked);
}

void TestPipeline(bool onPoints, int options)
{
  vtkNew<LabelSource> source;
  source->OnPoints = onPoints;
  vtkNew<Filter> filter;
  SetUp(filter, options);
  filter->SetInputConnection(source->GetOutputPort());
  filter->Update();
  std::vector<Polygon> whole;
  std::vector<Polygon> wholeSeams;
  AddPolygons(filter->GetOutput(), whole);
  AddSeams(filter->GetOutput(1), wholeSeams);
  const std::string name =
    std::string(onPoints ? "points" : "cells") + ", options " + std::to_string(options);
  for (const int count : { 2, 5 })
  {
    std::vector<Polygon> pieces;
    std::vector<Polygon> seams;
    std::vector<Polygon> withGhosts;
    for (int piece = 0; piece < count; ++piece)
    {
      filter->UpdatePiece(piece, count, 0);
      AddPolygons(filter->GetOutput(), pieces);
      AddSeams(filter->GetOutput(1), seams);
      filter->UpdatePiece(piece, count, 1);
      AddPolygons(filter->GetOutput(), withGhosts);
      std::vector<Polygon> all;
      AddPolygons(filter->GetOutput(), all, true);
      std::sort(all.begin(), all.end());
      std::vector<Polygon> sorted = whole;
      std::sort(sorted.begin(), sorted.end());
      RELIEVO_CHECK_THAT(std::includes(sorted.begin(), sorted.end(), all.begin(), all.end()),
        name + ": a ghost differs from the whole");
    }
    const std::string which = name + ", " + std::to_string(count) + " pieces";
    CheckSame(pieces, whole, which);
    CheckSame(seams, wholeSeams, which + ", seams");
    // And by updating the seams alone.
    seams.clear();
    for (int piece = 0; piece < count; ++piece)
    {
      UpdateSeams(filter, piece, count);
      AddSeams(filter->GetOutput(1), seams);
    }
    CheckSame(seams, wholeSeams, which + ", seams alone");
    CheckSame(withGhosts, whole, which + " with ghosts");
  }
}

// Chunks of 8 blocks and a rest, each an image of its own with two layers of ghosts.
void TestChunks(int options)
{
  vtkNew<LabelSource> source;
  vtkNew<Filter> filter;
  SetUp(filter, options);
  filter->SetInputConnection(source->GetOutputPort());
  filter->Update();
  std::vector<Polygon> whole;
  AddPolygons(filter->GetOutput(), whole);
  std::vector<Polygon> found;
  const int whole6[] = { 0, Size[0], 0, Size[1], 0, Size[2] };
  for (int z = 0; z < Size[2]; z += 8)
  {
    for (int y = 0; y < Size[1]; y += 17)
    {
      for (int x = 0; x < Size[0]; x += 8)
      {
        const int own[] = { x, std::min(x + 8, Size[0]), y, std::min(y + 17, Size[1]), z,
          std::min(z + 8, Size[2]) };
        int extent[6];
        for (int side = 0; side < 6; ++side)
        {
          extent[side] = side & 1 ? std::min(own[side] + 2, whole6[side])
                                  : std::max(own[side] - 2, whole6[side]);
        }
        vtkNew<vtkImageData> image;
        image->SetExtent(extent);
        image->SetOrigin(1. / 3., -7., 1e3);
        image->SetSpacing(0.1, 0.3, 0.7);
        Fill(image, false);
        image->AllocateCellGhostArray();
        vtkIdType cell = 0;
        for (int k = extent[4]; k < extent[5]; ++k)
        {
          for (int j = extent[2]; j < extent[3]; ++j)
          {
            for (int i = extent[0]; i < extent[1]; ++i)
            {
              const bool mine =
                i >= own[0] && i < own[1] && j >= own[2] && j < own[3] && k >= own[4] && k < own[5];
              image->GetCellGhostArray()->SetValue(cell++,
                static_cast<unsigned char>(mine ? 0 : int(vtkDataSetAttributes::DUPLICATECELL)));
            }
          }
        }
        vtkNew<vtkTrivialProducer> producer;
        producer->SetOutput(image);
        producer->SetWholeExtent(0, Size[0], 0, Size[1], 0, Size[2]);
        vtkNew<Filter> chunk;
        SetUp(chunk, options);
        chunk->SetInputConnection(producer->GetOutputPort());
        chunk->Update();
        AddPolygons(chunk->GetOutput(), found);
      }
    }
  }
  CheckSame(found, whole, "chunks, options " + std::to_string(options));
}

// An input without ghost cells: one warning, whatever number of pieces.
void TestNoGhosts()
{
  vtkNew<vtkImageData> image;
  image->SetExtent(0, Size[0], 0, Size[1], 0, 20);
  Fill(image, false);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  producer->SetWholeExtent(0, Size[0], 0, Size[1], 0, Size[2]);
  vtkNew<Filter> filter;
  filter->SetInputConnection(producer->GetOutputPort());
  ExpectMessage expect("does not give 2 layers of ghost cells");
  filter->Update();
  RELIEVO_CHECK(expect.Count() == 0);
  filter->UpdatePiece(0, 2, 0);
  RELIEVO_CHECK(expect.Count() == 1 && filter->GetOutput()->GetNumberOfPolys() > 0);
  filter->Modified();
  filter->UpdatePiece(1, 3, 0);
  RELIEVO_CHECK(expect.Count() == 1);
}

// The number of threads changes neither the polygons nor their order.
void TestThreads()
{
  std::vector<Polygon> first;
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
#if VTK_SMP_ENABLE_STDTHREAD
    int used = 0;
    vtkRelievoWithThreads([&used]() { used = vtkSMPTools::GetEstimatedNumberOfThreads(); });
    // VTK's own threads are no more than there are cores; TBB's may be.
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    RELIEVO_CHECK_THAT(
      used == threads || used == std::min(threads, cores), std::to_string(used) + " threads run");
#endif
    vtkNew<LabelSource> source;
    vtkNew<Filter> filter;
    SetUp(filter, 1);
    filter->SetInputConnection(source->GetOutputPort());
    filter->Update();
    std::vector<Polygon> polygons;
    AddPolygons(filter->GetOutput(), polygons);
    if (threads == 1)
    {
      first = polygons;
    }
    RELIEVO_CHECK_THAT(
      polygons == first, std::to_string(threads) + " threads make another surface");
  }
  vtkSMPTools::Initialize(0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSmoothBlocksPieces)
{
  relievoTest::Session session;
  for (const int options : { 0, 1, 2 })
  {
    TestPipeline(false, options);
    TestChunks(options);
  }
  TestPipeline(true, 1);
  TestNoGhosts();
  TestThreads();
  return session.Result();
}
}
