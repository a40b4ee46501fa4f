// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelCubes.h"

#include "vtkRelievoAbort.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPrecision.h"
#include "vtkRelievoReserve.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoVoxelDirection.h"
#include "vtkRelievoVoxelDistance.h"
#include "vtkRelievoVoxelNearest.h"
#include "vtkRelievoVoxelPieces.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoVoxelCubes);

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
// Smallest scale of an instance: VTK ignores shapes of size 0.
constexpr double LeastInstance = 1e-6;

// Whether the cell and its six neighbours are inside.
bool IsInner(const unsigned char* mask, const std::array<int, 3>& cells, const int cell[3])
{
  vtkIdType stride = 1;
  vtkIdType at = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    at += cell[axis] * stride;
    stride *= cells[axis];
  }
  bool inner = mask[at] != 0;
  stride = 1;
  for (int axis = 0; axis < 3 && inner; ++axis)
  {
    inner =
      cell[axis] > 0 && cell[axis] + 1 < cells[axis] && mask[at - stride] && mask[at + stride];
    stride *= cells[axis];
  }
  return inner;
}
}

//------------------------------------------------------------------------------
vtkRelievoVoxelCubes::vtkRelievoVoxelCubes()
{
  this->SetNumberOfInputPorts(2);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Parameters;
  list.AddNumber("transition", vtkRelievoMember(Transition), 0.0, infinity, "",
    "The distance outside over which sizes fall, in the data's units; 0: only cubes inside.");
  list.AddNumber(
    "rest_size", vtkRelievoMember(RestSize), 0.0, 1.0, "", "Size of cubes farther outside.");
  list.AddFlag("whole_grid", vtkRelievoMember(WholeGrid), "Whether all cells outside have cubes.");
  list.AddNumber("growth", vtkRelievoMember(Growth), 0.0, 1.0, "",
    "Fraction of the sizes above the rest size, for animations.");
  list.AddVector("repeller", vtkRelievoMember(Repeller), "A point that repels cubes.").Advanced =
    true;
  list
    .AddNumber("repeller_radius", vtkRelievoMember(RepellerRadius), 0.0, infinity, "",
      "Radius within which cubes are repelled, in the data's units; 0: nothing moves.")
    .Advanced = true;
  list
    .AddNumber("memory_limit", vtkRelievoMember(MemoryLimit), 0.0, infinity, "bytes",
      "Upper bound of the cubes' memory; more is refused. 0: all free memory.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
vtkRelievoVoxelCubes::~vtkRelievoVoxelCubes() = default;

//------------------------------------------------------------------------------
int vtkRelievoVoxelCubes::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoVoxelCubes::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(0);
  std::array<int, 6> extent;
  input->Get(SDDP::WHOLE_EXTENT(), extent.data());
  // The nearest cell inside may be anywhere in the input.
  if (!(this->Transition > 0.))
  {
    const std::array<int, 6> whole = extent;
    extent = vtkRelievoVoxelPieces::Of(input, output);
    // Inner cells are found from their neighbours.
    for (std::size_t i = 0; i < 6 && extent[0] <= extent[1]; i += 2)
    {
      extent[i] = std::max(extent[i] - 1, whole[i]);
      extent[i + 1] = std::min(extent[i + 1] + 1, whole[i + 1]);
    }
  }
  // Otherwise the executive would divide the piece's extent again.
  input->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
  input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  input->Set(SDDP::UPDATE_EXTENT(), extent.data(), 6);
  for (int i = 0; i < inputs[1]->GetNumberOfInformationObjects(); ++i)
  {
    // The nearest point may be anywhere in the model.
    vtkInformation* model = inputs[1]->GetInformationObject(i);
    if (model->Has(SDDP::WHOLE_EXTENT()))
    {
      model->Set(SDDP::UPDATE_EXTENT(), model->Get(SDDP::WHOLE_EXTENT()), 6);
    }
    model->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
    model->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
    model->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoVoxelCubes::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  relievo::Begin(outputs);
  auto* mask = vtkUnsignedCharArray::SafeDownCast(image->GetCellData()->GetArray("mask"));
  if (image->GetNumberOfCells() == 0)
  {
    return 1;
  }
  if (!mask || mask->GetNumberOfComponents() != 1)
  {
    // The output stays empty. Status 0 would make the pipeline report a second error.
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No cubes: the image has no cell array 'mask' of unsigned char; the filter Voxel "
                  "Shell makes such images.");
    return 1;
  }
  const vtkRelievoVoxelDirection turn(image);
  if (turn.IsSkewed())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(
      "No cubes: the cells are no boxes, as the columns of the image's direction matrix "
      "are not perpendicular and of length 1.");
    return 1;
  }
  const int* extent = image->GetExtent();
  const std::array<int, 3> cells{ { std::max(1, extent[1] - extent[0]),
    std::max(1, extent[3] - extent[2]), std::max(1, extent[5] - extent[4]) } };
  std::array<double, 3> spacing;
  image->GetSpacing(spacing.data());
  // Each cell has its cube in one piece. If the data came in separate blocks, all cells other than
  // ghosts belong to this piece.
  std::array<int, 6> own =
    vtkRelievoVoxelPieces::Of(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  for (std::size_t i = 0; i < 6; i += 2)
  {
    if (extent[i] > own[i] || extent[i + 1] < own[i + 1])
    {
      std::copy(extent, extent + 6, own.begin());
      break;
    }
  }
  if (own[0] > own[1])
  {
    return 1; // an empty piece
  }
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    image->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  constexpr unsigned char Blanked =
    vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  std::vector<unsigned char> visible; // marks visible cells of the mask, if any are blanked
  if (ghosts)
  {
    visible.assign(mask->GetPointer(0), mask->GetPointer(0) + mask->GetNumberOfValues());
    for (vtkIdType i = 0; i < mask->GetNumberOfValues(); ++i)
    {
      visible[static_cast<std::size_t>(i)] &= (ghosts->GetValue(i) & Blanked) ? 0 : 255;
    }
  }
  const unsigned char* inside = ghosts ? visible.data() : mask->GetPointer(0);
  const auto isOwn = [&](vtkIdType at, const int cell[3]) {
    bool is = !ghosts || !(ghosts->GetValue(at) & (Blanked | vtkDataSetAttributes::DUPLICATECELL));
    for (int axis = 0; axis < 3 && is; ++axis)
    {
      const int index = extent[2 * axis] + cell[axis];
      is = index >= own[2 * axis] && index < std::max(own[2 * axis + 1], own[2 * axis] + 1);
    }
    return is;
  };
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  const bool inDouble = relievo::NeedsDouble(
    image, info->Has(SDDP::WHOLE_EXTENT()) ? info->Get(SDDP::WHOLE_EXTENT()) : extent);
  vtkNew<vtkPoints> points;
  points->SetDataType(inDouble ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("size");
  const double radius = this->Instanced ? 0. : this->RepellerRadius;
  const double growth = this->Instanced ? 1. : this->Growth;
  const double longest =
    std::max({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  const relievo::f64::vec3 repeller(this->Repeller[0], this->Repeller[1], this->Repeller[2]);
  vtkDataSet* model = vtkDataSet::GetData(inputs[1]);
  std::string left;
  std::string lack;
  const auto work = [&]() {
    std::vector<float> squares;
    const auto count = static_cast<double>(mask->GetNumberOfValues());
    double bytes = this->Transition > 0. ? count * sizeof(float) : 0.;
    lack = relievo::LackOfMemory(bytes, this->MemoryLimit);
    if (!lack.empty())
    {
      return;
    }
    if (this->Transition > 0.)
    {
      squares = vtkRelievoVoxelDistance::Squared(inside, cells, spacing);
    }
    const double reach = this->Transition * this->Transition;
    const bool innerToo = this->Instanced || growth != 1. || radius > 0.;
    const auto forEachCell = [&](const auto& visit) {
      vtkIdType at = 0;
      int cell[3];
      for (cell[2] = 0; cell[2] < cells[2] && !relievo::IsStopped(this); ++cell[2])
      {
        for (cell[1] = 0; cell[1] < cells[1]; ++cell[1])
        {
          for (cell[0] = 0; cell[0] < cells[0]; ++cell[0], ++at)
          {
            const bool shown = inside[at] || this->WholeGrid ||
              (!squares.empty() && squares[static_cast<std::size_t>(at)] < reach);
            if (shown && isOwn(at, cell) && (innerToo || !IsInner(inside, cells, cell)))
            {
              visit(at, cell);
            }
          }
        }
      }
    };
    double cubes = 0.;
    forEachCell([&](vtkIdType, const int*) { cubes += 1.; });
    // The position, the size and three scales, and the four numbers of a rotation.
    bytes += cubes * (inDouble ? 3. * sizeof(double) : 3. * sizeof(float)) +
      cubes * (turn.IsTurned() ? 8. : 4.) * sizeof(float) +
      vtkRelievoVoxelNearest::EstimateBytes(model, cubes);
    lack = relievo::LackOfMemory(bytes, this->MemoryLimit);
    if (!lack.empty())
    {
      return;
    }
    // Allocated at once: growing takes twice the room.
    relievo::Reserve(points, static_cast<vtkIdType>(cubes));
    relievo::Reserve(sizes, static_cast<vtkIdType>(cubes));
    this->UpdateProgress(0.5);
    forEachCell([&](vtkIdType at, const int* cell) {
      double outside = inside[at] ? 0. : std::numeric_limits<double>::infinity();
      if (!inside[at] && this->Transition > 0.)
      {
        outside = std::sqrt(squares[static_cast<std::size_t>(at)]);
      }
      if (outside > 0. && outside >= this->Transition && !this->WholeGrid)
      {
        return;
      }
      double index[3];
      relievo::f64::vec3 place;
      for (int axis = 0; axis < 3; ++axis)
      {
        index[axis] = extent[2 * axis] + cell[axis] + 0.5;
      }
      image->TransformContinuousIndexToPhysicalPoint(index, &place.x);
      const double distance = glm::distance(place, repeller);
      if (distance >= radius && growth == 1. && !this->Instanced && IsInner(inside, cells, cell))
      {
        return;
      }
      place = relievo::f64::relievoCubePlace(place, repeller, radius);
      points->InsertNextPoint(&place.x);
      sizes->InsertNextValue(static_cast<float>(this->Instanced
          ? std::max(1. / (1. + outside / longest), LeastInstance)
          : relievo::f64::relievoCubeSize(outside, this->Transition, this->RestSize, growth)));
    });
    this->UpdateProgress(0.8);
    if (relievo::IsStopped(this))
    {
      return;
    }
    left = vtkRelievoVoxelNearest::Add(model, points, output->GetPointData());
  };
  vtkRelievoWithThreads(work);
  if (!lack.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No cubes: " << lack << "; make cells larger or the limit higher.");
    return 1;
  }
  if (relievo::IsStopped(this))
  {
    relievo::Discard(outputs);
    return 1;
  }
  if (!left.empty())
  {
    vtkWarningMacro("The point data " << left << " of the model are left out: cubes have their own "
                                      << "of this name. Rename them to have both.");
  }
  vtkNew<vtkFloatArray> scales;
  scales->SetName(this->Instanced ? "instance" : "scale");
  scales->SetNumberOfComponents(3);
  scales->SetNumberOfTuples(sizes->GetNumberOfValues());
  for (vtkIdType i = 0; i < sizes->GetNumberOfValues(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      scales->SetTypedComponent(
        i, axis, static_cast<float>(sizes->GetValue(i) * std::abs(spacing[axis])));
    }
  }
  output->SetPoints(points);
  if (!this->Instanced)
  {
    output->GetPointData()->AddArray(sizes);
  }
  output->GetPointData()->AddArray(scales);
  if (turn.IsTurned())
  {
    output->GetPointData()->AddArray(turn.MakeArray("orientation", points->GetNumberOfPoints()));
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  os << indent << "Instanced: " << this->Instanced << "\n";
}
