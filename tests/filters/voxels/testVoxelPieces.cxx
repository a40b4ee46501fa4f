// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pipeline requests to voxel shells and cubes: pieces, times, blanked cells, aborts.
#include "Check.h"
#include "Refusal.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkRelievoVoxelCubes.h>
#include <vtkRelievoVoxelShell.h>
#include <vtkSphereSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkThreshold.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cmath>
#include <set>

namespace testVoxelPieces
{
namespace
{
using SDDP = vtkStreamingDemandDrivenPipeline;

// A sphere of the radius 1 + t, at the times 0, 1 and 2.
class Growing : public vtkPolyDataAlgorithm
{
public:
  static Growing* New();
  vtkTypeMacro(Growing, vtkPolyDataAlgorithm);

protected:
  Growing() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double steps[3] = { 0., 1., 2. };
    const double range[2] = { 0., 2. };
    outputs->GetInformationObject(0)->Set(SDDP::TIME_STEPS(), steps, 3);
    outputs->GetInformationObject(0)->Set(SDDP::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(40);
    sphere->SetPhiResolution(40);
    sphere->SetRadius(
      1. + (info->Has(SDDP::UPDATE_TIME_STEP()) ? info->Get(SDDP::UPDATE_TIME_STEP()) : 0.));
    sphere->Update();
    vtkPolyData::GetData(outputs)->ShallowCopy(sphere->GetOutput());
    return 1;
  }
};
vtkStandardNewMacro(Growing);

void TestTimes()
{
  vtkNew<Growing> source;
  vtkNew<vtkRelievoVoxelShell> shell;
  shell->SetInputConnection(source->GetOutputPort());
  shell->SetCellSize(0.25);
  for (const double time : { 0., 2., 1. })
  {
    shell->UpdateTimeStep(time);
    const int cells = static_cast<int>(8. * (1. + time));
    RELIEVO_CHECK(shell->GetOutput()->GetDimensions()[2] == cells + 1);
    const int* whole = shell->GetOutputInformation(0)->Get(SDDP::WHOLE_EXTENT());
    RELIEVO_CHECK(whole[0] == 0 && whole[5] == cells);
  }
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputConnection(shell->GetOutputPort());
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "mask");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(0.5);
  for (const double time : { 0., 2., 1. })
  {
    threshold->UpdateTimeStep(time);
    const double* bounds = threshold->GetOutput()->GetBounds();
    for (int i = 0; i < 6; ++i)
    {
      RELIEVO_CHECK_NEAR(
        bounds[i], (i % 2 ? 1. : -1.) * (1. + time), 0.26, "bounds of cells inside");
    }
  }
}

vtkSmartPointer<vtkRelievoVoxelShell> ShellOfTorus()
{
  const relievoTest::Solid torus = relievoTest::MakeTorus(1e-3);
  auto shell = vtkSmartPointer<vtkRelievoVoxelShell>::New();
  shell->SetInputData(torus.Mesh);
  shell->SetResolution(30);
  return shell;
}

using Place = std::array<double, 3>;

void TestPiecesOfShell()
{
  const auto whole = ShellOfTorus();
  whole->DistancesOn();
  whole->Update();
  vtkImageData* all = whole->GetOutput();
  for (const int pieces : { 2, 5 })
  {
    vtkIdType cells = 0;
    for (int piece = 0; piece < pieces; ++piece)
    {
      const auto shell = ShellOfTorus();
      shell->DistancesOn();
      shell->UpdatePiece(piece, pieces, 0);
      vtkImageData* part = shell->GetOutput();
      cells += part->GetNumberOfCells();
      RELIEVO_CHECK(shell->GetReport() == whole->GetReport());
      RELIEVO_CHECK(part->GetFieldData()->GetArray("inside") != nullptr);
      int mismatches = 0;
      for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
      {
        double bounds[6];
        part->GetCellBounds(i, bounds);
        double middle[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          middle[axis] = (bounds[2 * axis] + bounds[2 * axis + 1]) / 2.;
        }
        int index[3];
        double place[3];
        all->ComputeStructuredCoordinates(middle, index, place);
        const vtkIdType at = all->ComputeCellId(index);
        for (const char* name : { "mask", "front" })
        {
          const double found = part->GetCellData()->GetArray(name)->GetTuple1(i);
          const double truth = all->GetCellData()->GetArray(name)->GetTuple1(at);
          mismatches += found == truth || (std::isnan(found) && std::isnan(truth)) ? 0 : 1;
        }
      }
      RELIEVO_CHECK_AT_MOST(mismatches, 0., "wrong values of a piece");
    }
    RELIEVO_CHECK(cells == all->GetNumberOfCells());
  }
}

void TestPiecesOfCubes()
{
  for (const double transition : { 0., 0.2 })
  {
    const auto make = [&](int piece, int pieces, std::multiset<Place>& places) {
      const auto shell = ShellOfTorus();
      vtkNew<vtkRelievoVoxelCubes> cubes;
      cubes->SetInputConnection(shell->GetOutputPort());
      cubes->SetTransition(transition);
      cubes->UpdatePiece(piece, pieces, piece % 2);
      for (vtkIdType i = 0; i < cubes->GetOutput()->GetNumberOfPoints(); ++i)
      {
        Place place;
        cubes->GetOutput()->GetPoint(i, place.data());
        places.insert(place);
      }
    };
    std::multiset<Place> whole;
    make(0, 1, whole);
    RELIEVO_CHECK(whole.size() > 1000);
    for (const int pieces : { 2, 3, 7 })
    {
      std::multiset<Place> sum;
      for (int piece = 0; piece < pieces; ++piece)
      {
        make(piece, pieces, sum);
      }
      RELIEVO_CHECK_THAT(sum == whole,
        std::to_string(pieces) + " pieces: " + std::to_string(sum.size()) + " cubes, expected " +
          std::to_string(whole.size()));
    }
  }
}

void TestBlanked()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(6, 6, 6);
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("mask");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int cell = 0; cell < 125; ++cell)
  {
    mask->InsertNextValue(1);
    ghosts->InsertNextValue(0);
  }
  image->GetCellData()->AddArray(mask);
  image->GetCellData()->AddArray(ghosts);
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputData(image);
  const auto count = [&](unsigned char flag) {
    ghosts->SetValue(2 * 31, flag); // the one in the middle
    ghosts->Modified();
    image->Modified();
    cubes->Modified();
    cubes->Update();
    return cubes->GetOutput()->GetNumberOfPoints();
  };
  const vtkIdType shell = 125 - 27;
  RELIEVO_CHECK(count(0) == shell);
  RELIEVO_CHECK(count(vtkDataSetAttributes::DUPLICATECELL) == shell);
  // Without the one in the middle, its neighbours are seen.
  RELIEVO_CHECK(count(vtkDataSetAttributes::HIDDENCELL) == shell + 6);
  RELIEVO_CHECK(count(vtkDataSetAttributes::REFINEDCELL) == shell + 6);
  cubes->SetGrowth(0.5); // inner ones as well
  RELIEVO_CHECK(count(0) == 125);
  RELIEVO_CHECK(count(vtkDataSetAttributes::DUPLICATECELL) == 124);
  RELIEVO_CHECK(count(vtkDataSetAttributes::HIDDENCELL) == 124);
}

void TestAbort()
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  });
  const auto shell = ShellOfTorus();
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputConnection(shell->GetOutputPort());
  for (const int method : { vtkRelievoVoxelShell::TWO_VIEWS, vtkRelievoVoxelShell::PARITY })
  {
    shell->SetMethod(method);
    const unsigned long tag = shell->AddObserver(vtkCommand::ProgressEvent, abort);
    shell->Update();
    RELIEVO_CHECK(shell->GetOutput()->GetNumberOfCells() == 0);
    RELIEVO_CHECK(shell->GetNumberOfCellsInside() == 0);
    shell->RemoveObserver(tag);
    shell->SetAbortExecute(0);
    shell->Update();
    RELIEVO_CHECK(shell->GetNumberOfCellsInside() > 1000);
  }
  const unsigned long tag = cubes->AddObserver(vtkCommand::ProgressEvent, abort);
  cubes->Update();
  RELIEVO_CHECK(cubes->GetOutput()->GetNumberOfPoints() == 0);
  cubes->RemoveObserver(tag);
  cubes->SetAbortExecute(0);
  cubes->Update();
  RELIEVO_CHECK(cubes->GetOutput()->GetNumberOfPoints() > 1000);
}

void TestMemoryOfCubes()
{
  const auto shell = ShellOfTorus();
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputConnection(shell->GetOutputPort());
  cubes->WholeGridOn();
  cubes->Update();
  const auto bytes = static_cast<double>(28 * cubes->GetOutput()->GetNumberOfPoints());
  cubes->SetMemoryLimit(bytes - 1.);
  relievoTest::CheckRefused(cubes.Get(), "No cubes: it would take");
  cubes->SetMemoryLimit(bytes);
  cubes->Update();
  const vtkIdType count = cubes->GetOutput()->GetNumberOfPoints();
  RELIEVO_CHECK(count > 1000);
  // With the arrays of a model it takes as much more as there then is.
  const auto model = relievoTest::MakeTorus().Mesh;
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  values->SetNumberOfComponents(6);
  values->SetNumberOfTuples(model->GetNumberOfPoints());
  values->Fill(1.);
  model->GetPointData()->AddArray(values);
  cubes->SetInputData(1, model);
  cubes->SetMemoryLimit(static_cast<double>(count) * (28. + 48.));
  {
    relievoTest::ExpectMessage expect("No cubes: it would take");
    cubes->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  cubes->SetMemoryLimit(static_cast<double>(count) * (28. + 48. + 8.) +
    20. * static_cast<double>(model->GetNumberOfPoints()));
  cubes->Update();
  vtkDataArray* copied = cubes->GetOutput()->GetPointData()->GetArray("values");
  RELIEVO_CHECK(copied && copied->GetNumberOfTuples() == count);
}
}

RELIEVO_TEST_CASE(testVoxelPieces)
{
  relievoTest::Session session;
  TestTimes();
  TestPiecesOfShell();
  TestPiecesOfCubes();
  TestBlanked();
  TestAbort();
  TestMemoryOfCubes();
  return session.Result();
}
}
