// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Input of smooth blocks: all integer types, blanked blocks; and refused input, with a message.
#include "BlockScenes.h"
#include "Check.h"
#include "Refusal.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoCaves.h"
#include "vtkRelievoSmoothBlocks.h"
#include "vtkRelievoVTKVersions.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace testSmoothBlocksInput
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoSmoothBlocks;

void TestTypes()
{
  const LabelOf label = AnyOf(8, 3);
  vtkNew<Filter> filter;
  filter->SetSurface(Filter::BETWEEN_LABELS);
  const vtkIdType expected = Run(filter, MakeBlocks({ 5, 6, 7 }, label))->GetNumberOfPolys();
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE })
  {
    vtkPolyData* surface = Run(filter, MakeBlocks({ 5, 6, 7 }, label, type));
    RELIEVO_CHECK(surface->GetNumberOfPolys() == expected);
    // Mappers take unsigned bytes for colours.
    const int kept = type == VTK_UNSIGNED_CHAR ? VTK_SHORT : type;
    RELIEVO_CHECK(surface->GetCellData()->GetArray("material")->GetDataType() == kept);
  }
  // Labels that differ only beyond 2^31, and by less than a double tells apart.
  const vtkTypeInt64 base = vtkTypeInt64(1) << 60;
  vtkNew<Filter> large;
  large->SetSurface(Filter::BETWEEN_LABELS);
  large->SetAirLabel(base);
  vtkPolyData* surface = Run(large,
    MakeBlocks(
      { 3, 1, 1 }, [base](int i, int, int) { return i == 1 ? base + 1 : base; }, VTK_LONG_LONG));
  RELIEVO_CHECK(surface->GetNumberOfPolys() == 12);
  // The outside of the blocks does not depend on the label of air; an unsigned type lacks -1.
  vtkNew<Filter> none;
  none->SetAirLabel(-1);
  RELIEVO_CHECK(
    Run(none, MakeBlocks({ 2, 2, 2 }, AnyOf(1, 2), VTK_UNSIGNED_CHAR))->GetNumberOfPolys() == 48);
  // The neighbor of an outer face is air, also where the labels' type has no such value.
  none->SetSurface(Filter::BETWEEN_LABELS);
  vtkDataArray* neighbors = Run(none, MakeBlocks({ 2, 2, 2 }, AnyOf(1, 2), VTK_UNSIGNED_CHAR))
                              ->GetCellData()
                              ->GetArray("neighbor");
  RELIEVO_CHECK(neighbors->GetRange()[0] == -1. && neighbors->GetRange()[1] <= 1.);
}

void TestBlanking()
{
  vtkSmartPointer<vtkImageData> image =
    MakeBlocks({ 3, 3, 3 }, [](int, int, int) { return vtkTypeInt64(2); });
  image->AllocateCellGhostArray();
  for (vtkIdType i = 0; i < 27; ++i)
  {
    image->GetCellGhostArray()->SetValue(
      i, static_cast<unsigned char>(i == 13 ? int(vtkDataSetAttributes::HIDDENCELL) : 0));
  }
  vtkNew<Filter> filter;
  RELIEVO_CHECK(Run(filter, image)->GetNumberOfPolys() == 2 * (54 + 6));
  filter->CloseBordersOff();
  RELIEVO_CHECK(Run(filter, image)->GetNumberOfPolys() == 2 * 6);
  // A cell that a finer level replaces is not there either.
  image->GetCellGhostArray()->SetValue(13, vtkDataSetAttributes::REFINEDCELL);
  RELIEVO_CHECK(Run(filter, image)->GetNumberOfPolys() == 2 * 6);
  // Cells with a hidden point are those that the image itself calls hidden; two points hide the 12
  // cells around them.
  vtkSmartPointer<vtkImageData> large =
    MakeBlocks({ 5, 4, 6 }, [](int, int, int) { return vtkTypeInt64(2); });
  const auto hide = [](vtkImageData* of, vtkIdType point) {
    of->AllocatePointGhostArray();
    of->GetPointGhostArray()->SetValue(point, vtkDataSetAttributes::HIDDENPOINT);
  };
  hide(large, 2 + 6 * (2 + 5 * 3));
  hide(large, 3 + 6 * (2 + 5 * 3));
  vtkIdType hidden = 0;
  for (vtkIdType i = 0; i < large->GetNumberOfCells(); ++i)
  {
    hidden += !large->IsCellVisible(i);
  }
  RELIEVO_CHECK(hidden == 12);
  RELIEVO_CHECK(Run(filter, large)->GetNumberOfPolys() == 2 * 2 * (3 * 2 + 2 * 2 + 3 * 2));
  // Labels on points: the block around a hidden point.
  vtkSmartPointer<vtkImageData> onPoints = MakeBlocks(
    { 5, 4, 6 }, [](int, int, int) { return vtkTypeInt64(2); }, VTK_INT, true);
  hide(onPoints, 2 + 5 * (2 + 4 * 3));
  RELIEVO_CHECK(Run(filter, onPoints)->GetNumberOfPolys() == 2 * 6);
}

// A surface that needs more than the available memory is refused with the required bytes; with
// exactly that many it is made, and the result is not larger.
void TestMemory()
{
  vtkSmartPointer<vtkImageData> image = MakeBlocks({ 30, 31, 32 }, AnyOf(7, 3));
  for (const bool rich : { false, true })
  {
    vtkNew<Filter> filter;
    filter->SetInputData(image);
    filter->SetTextureCoordinates(rich);
    filter->SetMaterialWeights(rich);
    filter->SetSurface(rich ? Filter::BETWEEN_LABELS : Filter::OUTSIDE);
    filter->SetMemoryLimit(1e5);
    ExpectMessage expect("MemoryLimit is 100000 bytes");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1 && filter->GetErrorCode() == vtkErrorCode::UserError);
    RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
    const std::string before = "it would take ";
    const std::string said = expect.Messages().empty() ? before : expect.Messages().front();
    const double bytes = std::atof(said.c_str() + said.find(before) + before.size());
    filter->SetMemoryLimit(bytes);
    filter->Update();
    RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
    const double made = 1024. * static_cast<double>(filter->GetOutput()->GetActualMemorySize());
    RELIEVO_CHECK_AT_MOST(made, bytes, "bytes that were made, against those expected");
    RELIEVO_CHECK_AT_MOST(bytes, 6. * made, "bytes expected, against those that were made");
  }
}

// A checkerboard is all seams; and weights of forty labels.
void TestMemoryOfMany()
{
  for (const bool seams : { true, false })
  {
    vtkNew<Filter> filter;
    filter->SetSeams(seams);
    filter->SetNormals(Filter::NO_NORMALS);
    filter->SetMaterialWeights(!seams);
    filter->SetInputData(MakeBlocks({ 40, 40, 40 }, [&](int i, int j, int k) {
      return vtkTypeInt64((i + j + k) % 2 ? 0 : seams ? 1 : 1 + (i * 3 + j * 5 + k * 7) % 40);
    }));
    filter->SetMemoryLimit(1e5);
    double bytes = 0.;
    {
      ExpectMessage expect("MemoryLimit is 100000 bytes");
      filter->Update();
      RELIEVO_CHECK(expect.Count() == 1);
      const std::string before = "it would take ";
      const std::string said = expect.Messages().empty() ? before : expect.Messages().front();
      bytes = std::atof(said.c_str() + said.find(before) + before.size());
    }
    filter->SetMemoryLimit(0.);
    filter->Update();
    // The output and its sources: faces of 48 bytes, and lists of seams of 32 bytes, or the weights
    // of all vertices.
    const auto lines = static_cast<double>(filter->GetOutput(1)->GetNumberOfLines());
    const auto faces = static_cast<double>(filter->GetOutput()->GetNumberOfPolys()) / 2.;
    RELIEVO_CHECK(seams == (lines > 100000.));
    const double from = 32. * faces + (seams ? 32. * lines : 4. * 40. * 41. * 41. * 41.);
    const double made = from +
      1024. *
        static_cast<double>(
          filter->GetOutput()->GetActualMemorySize() + filter->GetOutput(1)->GetActualMemorySize());
    RELIEVO_CHECK_AT_MOST(made, bytes, seams ? "bytes of seams" : "bytes of weights");
    RELIEVO_CHECK_AT_MOST(bytes, 3. * made, "bytes expected, against those that were made");
  }
}

// Where float would round by more than a thousandth of a block, points are double; a choice of
// precision counts first.
void TestFarAway()
{
  vtkSmartPointer<vtkImageData> image = MakeBlocks({ 6, 6, 6 }, BallOf(2.5, { 3., 3., 3. }));
  vtkNew<Filter> near;
  near->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkPolyData* truth = Run(near, image);
  vtkNew<vtkImageData> far;
  far->ShallowCopy(image);
  far->SetOrigin(5e5, 5e6, 0.);
  far->SetSpacing(0.1, 0.1, 0.1);
  vtkNew<Filter> filter;
  vtkPolyData* surface = Run(filter, far);
  RELIEVO_CHECK(surface->GetPoints()->GetDataType() == VTK_DOUBLE);
  RELIEVO_CHECK(filter->GetOutput(1)->GetPoints()->GetDataType() == VTK_DOUBLE);
  double worst = 0.;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Place place;
    Place own;
    surface->GetPoint(i, place.data());
    truth->GetPoint(i, own.data());
    for (int c = 0; c < 3; ++c)
    {
      worst = std::max(worst, std::abs(place[c] - far->GetOrigin()[c] - 0.1 * own[c]));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-8, "places far from the origin");
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  RELIEVO_CHECK(Run(filter, far)->GetPoints()->GetDataType() == VTK_FLOAT);
  vtkNew<Filter> plain;
  RELIEVO_CHECK(Run(plain, image)->GetPoints()->GetDataType() == VTK_FLOAT);
}

// The next update makes an aborted output, although nothing has changed.
void TestAbort()
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  });
  vtkNew<Filter> filter;
  filter->SetInputData(MakeBlocks({ 20, 20, 20 }, AnyOf(3, 3)));
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  RELIEVO_CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() > 1000);
  RELIEVO_CHECK(filter->GetOutput(1)->GetNumberOfPoints() > 1000);
}

#ifdef RELIEVO_VTK_CHECK_ABORT
// Aborting an upstream filter aborts this one, too.
void TestAbortBefore()
{
  vtkNew<vtkRelievoCaves> caves;
  caves->SetSize(40, 40, 40);
  caves->SetScale(20.);
  caves->SetContent(vtkRelievoCaves::LABELS);
  vtkNew<Filter> filter;
  filter->SetInputConnection(caves->GetOutputPort());
  const unsigned long tag = filter->AddObserver(
    vtkCommand::ProgressEvent, caves.Get(), &vtkAlgorithm::SetAbortExecuteAndUpdateTime);
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  filter->RemoveObserver(tag);
  caves->SetAbortExecute(0);
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() > 1000);
}
#endif

void TestMessages()
{
  const LabelOf label = AnyOf(8, 3);
  const auto refuses = [](vtkImageData* image, const std::string& words) {
    vtkNew<Filter> filter;
    filter->SetInputData(image);
    CheckRefused(filter.Get(), words);
  };
  refuses(MakeBlocks({ 3, 3, 3 }, label, VTK_FLOAT), "'labels' is of type float");
  refuses(MakeBlocks({ 3, 3, 3 }, label, VTK_DOUBLE), "'labels' is of type double");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 3);
  refuses(bare, "On cells there are: none; on points: none");
  vtkSmartPointer<vtkImageData> fields = MakeBlocks({ 3, 3, 3 }, label);
  vtkNew<vtkIntArray> few;
  few->SetName("few");
  few->SetNumberOfTuples(7);
  fields->GetCellData()->SetScalars(nullptr);
  fields->GetFieldData()->AddArray(few);
  vtkNew<Filter> ofField;
  ofField->SetInputData(fields);
  ofField->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_NONE, "few");
  ExpectMessage expect("'few' has 7 values, but the image has 27 cells");
  ofField->Update();
  vtkSmartPointer<vtkImageData> flat = MakeBlocks({ 3, 3, 1 }, label);
  flat->SetDimensions(4, 4, 1);
  refuses(flat, "the image is flat");
  vtkSmartPointer<vtkImageData> thin = MakeBlocks({ 3, 3, 3 }, label);
  thin->SetSpacing(1., 0., 1.);
  refuses(thin, "no volume");
  vtkNew<Filter> filter;
  vtkNew<vtkImageData> nothing;
  RELIEVO_CHECK(Run(filter, nothing)->GetNumberOfPoints() == 0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSmoothBlocksInput)
{
  relievoTest::Session session;
  TestTypes();
  TestBlanking();
  TestMemory();
  TestMemoryOfMany();
  TestFarAway();
  TestAbort();
#ifdef RELIEVO_VTK_CHECK_ABORT
  TestAbortBefore();
#endif
  TestMessages();
  return session.Result();
}
}
