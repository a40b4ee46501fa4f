// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelShell.h"

#include "vtkRelievoAbort.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoVoxelDepths.h"
#include "vtkRelievoVoxelFit.h"
#include "vtkRelievoVoxelMask.h"
#include "vtkRelievoVoxelMeshes.h"
#include "vtkRelievoVoxelPieces.h"
#include "vtkRelievoVoxelReport.h"
#include "vtkRelievoVoxelSurface.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkRelievoVoxelShell);

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
bool IsBox(const double bounds[6])
{
  return bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
}
}

//------------------------------------------------------------------------------
struct vtkRelievoVoxelShell::Internals
{
  vtkRelievoVoxelReport Report;

  // Fits the grid to the current inputs; false, with `problem` set, if that fails.
  static bool MakeGrid(vtkRelievoVoxelShell* self, vtkDataObject* surface,
    vtkRelievoVoxelGrid& grid, std::string& problem);
};

//------------------------------------------------------------------------------
bool vtkRelievoVoxelShell::Internals::MakeGrid(vtkRelievoVoxelShell* self, vtkDataObject* surface,
  vtkRelievoVoxelGrid& grid, std::string& problem)
{
  double box[6];
  std::copy(self->Bounds, self->Bounds + 6, box);
  if (!IsBox(box) && !(surface && vtkRelievoVoxelMeshes::GetBounds(surface, box)))
  {
    grid.Cells = { { 0, 0, 0 } };
    return true; // empty data
  }
  vtkRelievoVoxelFit fit;
  std::copy(self->Dimensions, self->Dimensions + 3, fit.Dimensions.begin());
  fit.CellSize = self->CellSize;
  fit.Resolution = self->Resolution;
  fit.Padding = self->Padding;
  problem = fit.FindProblem(box);
  if (!problem.empty())
  {
    return false;
  }
  const std::array<double, 3> count = fit.Count(box);
  const bool fromImages = self->GetNumberOfInputConnections(1) > 0;
  const double bytes =
    vtkRelievoVoxelMask::EstimateBytes(count, self->Method == PARITY && !fromImages,
      self->Method == SIX_VIEWS || fromImages ? -1 : self->Axis, self->Distances);
  const std::string lack = relievo::LackOfMemory(bytes, self->MemoryLimit);
  if (!lack.empty())
  {
    std::ostringstream out;
    out.precision(10);
    out << count[0] << " x " << count[1] << " x " << count[2] << " cells are asked for; " << lack
        << "; make cells larger or the limit higher";
    problem = out.str();
    return false;
  }
  grid = fit.Fit(box);
  return true;
}

//------------------------------------------------------------------------------
vtkRelievoVoxelShell::vtkRelievoVoxelShell()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Parameters;
  list.AddChoice("method", vtkRelievoMember(Method), { "two_views", "six_views", "parity" },
    "Parity finds hollows; views fill hidden ones.");
  list.AddWhole("resolution", vtkRelievoMember(Resolution), 1, VTK_INT_MAX, "",
    "Cubic cells along the longest side of the grid.");
  list.AddNumber("cell_size", vtkRelievoMember(CellSize), 0.0, infinity, "",
    "Side of the cells in the data's units; 0: set by Resolution.");
  list.AddFlag("distances", vtkRelievoMember(Distances),
    "Whether cells have the arrays front and back: distances behind the first surface of their "
    "column, and in front of the last.");
  list
    .AddChoice("axis", vtkRelievoMember(Axis), { "x", "y", "z" },
      "The axis that two views look along, and along which parity counts.")
    .Advanced = true;
  list
    .AddSize("dimensions", vtkRelievoMember(Dimensions), 0,
      "Cells along x, y and z; 0 0 0: set by Cell Size or Resolution.")
    .Advanced = true;
  list
    .AddBox("bounds", vtkRelievoMember(Bounds),
      "The box of the grid, from and to along x, y and z; while a pair is not in order, the "
      "input's bounds.")
    .Advanced = true;
  list.AddWhole("padding", vtkRelievoMember(Padding), 0, 1000000, "", "Cells added on each side.")
    .Advanced = true;
  list
    .AddNumber("memory_limit", vtkRelievoMember(MemoryLimit), 0.0, infinity, "bytes",
      "Upper bound of the grid's memory; more is refused. 0: all free memory.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
vtkRelievoVoxelShell::~vtkRelievoVoxelShell() = default;

//------------------------------------------------------------------------------
int vtkRelievoVoxelShell::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkRelievoVoxelShell::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // The input's bounds are valid only for one time.
  return request->Has(SDDP::REQUEST_TIME_DEPENDENT_INFORMATION())
    ? this->RequestInformation(request, inputs, outputs)
    : this->Superclass::ProcessRequest(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkRelievoVoxelShell::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  vtkDataObject* surface = nullptr;
  if (!IsBox(this->Bounds) && inputs[0]->GetNumberOfInformationObjects() > 0)
  {
    vtkInformation* input = inputs[0]->GetInformationObject(0);
    if (input->Has(SDDP::TIME_STEPS()) || input->Has(SDDP::TIME_RANGE()))
    {
      output->Set(SDDP::TIME_DEPENDENT_INFORMATION(), 1);
      output->Set(SDDP::UNRESTRICTED_UPDATE_EXTENT(), 1);
    }
    // Only the data determine the grid.
    int port = 0;
    vtkAlgorithm* producer = this->GetInputAlgorithm(0, 0, port);
    vtkRelievoVoxelPieces::UpdateWhole(producer, port);
    surface = producer->GetOutputDataObject(port);
  }
  vtkRelievoVoxelGrid grid;
  std::string problem;
  Internals::MakeGrid(this, surface, grid, problem);
  const std::array<int, 6> extent{ { 0, grid.Cells[0], 0, grid.Cells[1], 0, grid.Cells[2] } };
  const std::array<int, 6> none{ { 0, -1, 0, -1, 0, -1 } };
  vtkRelievoVoxelPieces::SetWhole(output, grid.GetNumberOfCells() > 0 ? extent : none);
  output->Set(vtkDataObject::ORIGIN(), grid.Origin.data(), 3);
  output->Set(vtkDataObject::SPACING(), grid.Spacing.data(), 3);
  output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoVoxelShell::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  if (output->Has(SDDP::TIME_DEPENDENT_INFORMATION()) && !IsBox(this->Bounds))
  {
    // Filters downstream request the extent of the first time they saw. In pieces, the executive
    // divides this extent.
    output->Set(SDDP::UPDATE_EXTENT(), output->Get(SDDP::WHOLE_EXTENT()), 6);
  }
  for (int port = 0; port < 2; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      if (input->Has(SDDP::WHOLE_EXTENT()))
      {
        input->Set(SDDP::UPDATE_EXTENT(), input->Get(SDDP::WHOLE_EXTENT()), 6);
      }
      input->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
      input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
      input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoVoxelShell::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  relievo::Begin(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  Internals& self = *this->Internal;
  self = Internals();
  vtkDataObject* surfaceData = vtkDataObject::GetData(inputs[0]);
  std::vector<vtkImageData*> images;
  for (int i = 0; i < inputs[1]->GetNumberOfInformationObjects(); ++i)
  {
    vtkRelievoVoxelDepths::Add(vtkDataObject::GetData(inputs[1], i), images);
  }
  const bool fromImages = inputs[1]->GetNumberOfInformationObjects() > 0;
  vtkRelievoVoxelGrid grid;
  std::string problem;
  if (!surfaceData && !fromImages)
  {
    problem = "there is no input; give a surface (input 0) or depth images (input 1)";
  }
  else if (Internals::MakeGrid(this, surfaceData, grid, problem) && fromImages && !surfaceData &&
    grid.GetNumberOfCells() == 0)
  {
    problem = "depth images alone do not say where the grid is; set Bounds";
  }
  std::vector<vtkRelievoVoxelViews> views;
  if (problem.empty() && fromImages && grid.GetNumberOfCells() > 0)
  {
    problem = vtkRelievoVoxelDepths::Read(images, grid, views);
  }
  if (!problem.empty())
  {
    // The output stays empty. Status 0 would make the pipeline report a second error.
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No cells: " << problem << ".");
    return 1;
  }

  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("mask");
  mask->SetNumberOfValues(static_cast<vtkIdType>(grid.GetNumberOfCells()));
  vtkIdType invalid = 0;
  if (grid.GetNumberOfCells() > 0)
  {
    output->SetDimensions(grid.Cells[0] + 1, grid.Cells[1] + 1, grid.Cells[2] + 1);
    output->SetOrigin(grid.Origin.data());
    output->SetSpacing(grid.Spacing.data());
    const auto work = [&]() {
      vtkRelievoVoxelSurface surface;
      for (vtkDataSet* leaf :
        fromImages ? std::vector<vtkDataSet*>() : vtkRelievoVoxelMeshes::GetLeaves(surfaceData))
      {
        surface.Add(vtkRelievoVoxelMeshes::GetSurface(leaf), grid);
        if (relievo::IsStopped(this))
        {
          return;
        }
      }
      invalid = surface.GetNumberOfInvalid();
      self.Report.Triangles = surface.GetNumberOfTriangles();
      self.Report.Closed = !fromImages && surface.IsClosed();
      this->UpdateProgress(0.3);
      const bool parity = this->Method == PARITY && !fromImages;
      for (int axis = 0; axis < 3 && !fromImages && (!parity || this->Distances); ++axis)
      {
        if (relievo::IsStopped(this))
        {
          return;
        }
        if (this->Method == SIX_VIEWS || axis == this->Axis)
        {
          views.push_back(vtkRelievoVoxelViews::Of(surface, grid, axis));
        }
      }
      this->UpdateProgress(0.6);
      if (relievo::IsStopped(this))
      {
        return;
      }
      if (!parity)
      {
        self.Report.Inside = vtkRelievoVoxelMask::FromViews(views, grid, mask->GetPointer(0));
      }
      else if (self.Report.Closed)
      {
        const vtkRelievoVoxelParity bits(surface, grid, this->Axis);
        self.Report.Count(this->Axis, bits, grid);
        self.Report.Inside =
          vtkRelievoVoxelMask::FromParity(bits, this->Axis, grid, mask->GetPointer(0));
      }
      else
      {
        std::vector<vtkRelievoVoxelParity> axes;
        for (int axis = 0; axis < 3; ++axis)
        {
          this->UpdateProgress(0.6 + 0.1 * axis);
          if (relievo::IsStopped(this))
          {
            return;
          }
          axes.emplace_back(surface, grid, axis);
          self.Report.Count(axis, axes.back(), grid);
        }
        self.Report.Inside = vtkRelievoVoxelMask::FromVote(axes, grid, mask->GetPointer(0));
      }
    };
    vtkRelievoWithThreads(work);
  }
  this->UpdateProgress(0.9);
  if (relievo::IsStopped(this))
  {
    relievo::Discard(outputs);
    self = Internals();
    return 1;
  }
  output->GetCellData()->SetScalars(mask);
  if (this->Distances)
  {
    vtkNew<vtkFloatArray> front;
    vtkNew<vtkFloatArray> back;
    front->SetName("front");
    back->SetName("back");
    for (vtkFloatArray* array : { front.Get(), back.Get() })
    {
      array->SetNumberOfComponents(std::max(1, static_cast<int>(views.size())));
      array->SetNumberOfTuples(mask->GetNumberOfTuples());
      output->GetCellData()->AddArray(array);
    }
    if (grid.GetNumberOfCells() > 0)
    {
      vtkRelievoWithThreads([&]() {
        vtkRelievoVoxelMask::Distances(views, grid, front->GetPointer(0), back->GetPointer(0));
      });
    }
  }
  vtkRelievoVoxelPieces::Crop(output, outputs->GetInformationObject(0));
  self.Report.Describe(
    this->Method == PARITY && !fromImages, this->Axis, views, grid, fromImages, invalid);
  self.Report.AddTo(output->GetFieldData());
  return 1;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVoxelShell::GetNumberOfCellsInside()
{
  return this->Internal->Report.Inside;
}

//------------------------------------------------------------------------------
bool vtkRelievoVoxelShell::IsClosed()
{
  return this->Internal->Report.Closed;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVoxelShell::GetNumberOfOpenColumns(int axis)
{
  return axis >= 0 && axis < 3 ? this->Internal->Report.Open[static_cast<std::size_t>(axis)] : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVoxelShell::GetNumberOfColumns(int axis)
{
  return axis >= 0 && axis < 3 ? this->Internal->Report.Columns[static_cast<std::size_t>(axis)] : 0;
}

//------------------------------------------------------------------------------
std::string vtkRelievoVoxelShell::GetReport()
{
  return this->Internal->Report.Words;
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelShell::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  os << indent << "Bounds: " << this->Bounds[0] << " " << this->Bounds[1] << " " << this->Bounds[2]
     << " " << this->Bounds[3] << " " << this->Bounds[4] << " " << this->Bounds[5] << "\n";
  os << indent << "Report: " << this->Internal->Report.Words << "\n";
}
