// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCaves.h"

#include "vtkRelievoAbort.h"
#include "vtkRelievoCaveFunction.h"
#include "vtkRelievoCaveImage.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoParameter.h"

#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkRelievoCaves);

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
// Limit of positions, in cells of the noise from the origin; its integers reach a little farther.
constexpr double Farthest = 5e8;

std::string Words(const double* numbers)
{
  std::ostringstream words;
  words << numbers[0] << " " << numbers[1] << " " << numbers[2];
  return words.str();
}

// Why the image cannot be made; empty if it can.
std::string FindProblem(vtkRelievoCaves* caves, const relievo::CaveField& field)
{
  std::ostringstream problem;
  const int* size = caves->GetSize();
  const double width = caves->GetTunnelWidth();
  const double widest = relievo::CaveField::Widest * caves->GetScale();
  double reach = 0.;
  bool finite = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = caves->GetOrigin()[axis];
    const double last = first + (size[axis] - 1) * caves->GetSpacing()[axis];
    for (const double place : { first * field.Cells[axis], last * field.Cells[axis] })
    {
      finite = finite && std::isfinite(place);
      reach = std::max(reach, std::abs(place));
    }
  }
  if (std::min({ size[0], size[1], size[2] }) < 1)
  {
    problem << "Size is " << size[0] << " " << size[1] << " " << size[2]
            << ", expected at least 1 sample along each axis";
  }
  else if (width > widest)
  {
    problem << "TunnelWidth is " << width << ", expected at most " << widest << ", half of Scale ("
            << caves->GetScale() << "); a larger Scale makes wider tunnels";
  }
  else if (caves->GetFunction()->GetTransform())
  {
    problem
      << "The function has a Transform, which images of samples do not follow; move the image "
         "with Origin and Spacing, or sample the function with vtkSampleFunction";
  }
  else if (!finite)
  {
    problem << "Origin (" << Words(caves->GetOrigin()) << ") and Spacing ("
            << Words(caves->GetSpacing()) << "), with Scale (" << caves->GetScale()
            << "), put samples at places that are not finite";
  }
  else if (reach > Farthest)
  {
    problem << "Origin and Spacing put samples " << reach
            << " cells of the noise (Scale) from the origin, expected at most " << Farthest;
  }
  return problem.str();
}
}

//------------------------------------------------------------------------------
vtkRelievoCaves::vtkRelievoCaves()
  : Function(vtkSmartPointer<vtkRelievoCaveFunction>::New())
{
  this->SetNumberOfInputPorts(0);
  vtkRelievoParameterList& list = this->Parameters;
  list.AddSize(
    "size", this->Size, [this](const int* size) { this->SetSize(size[0], size[1], size[2]); }, 1,
    "Samples along x, y and z.");
  this->Function->Describe(list);
  list.AddChoice(
    "content", this->Content, [this](int content) { this->SetContent(content); },
    { "mask", "density", "labels" },
    "Values of the samples: mask (1 in the air, 0 in the rock), density (-1 in the middle of "
    "tunnels, 0 at their walls, 1 in the rock) or labels (AirLabel and RockLabel, for smooth "
    "blocks).");
  list
    .AddWhole(
      "air_label", this->AirLabel, [this](int label) { this->SetAirLabel(label); }, 0, 255, "",
      "The label of air.")
    .Advanced = true;
  list
    .AddWhole(
      "rock_label", this->RockLabel, [this](int label) { this->SetRockLabel(label); }, 0, 255, "",
      "The label of rock.")
    .Advanced = true;
  list
    .AddVector(
      "origin", this->Origin,
      [this](const double* place) { this->SetOrigin(place[0], place[1], place[2]); },
      "Place of the first sample.")
    .Advanced = true;
  list
    .AddVector(
      "spacing", this->Spacing,
      [this](const double* step) { this->SetSpacing(step[0], step[1], step[2]); },
      "Distance between samples.")
    .Advanced = true;
  list
    .AddNumber(
      "memory_limit", this->MemoryLimit, [this](double bytes) { this->SetMemoryLimit(bytes); }, 0.,
      std::numeric_limits<double>::infinity(), "",
      "Upper bound of the image's bytes per process; more are refused. 0: all free memory.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
vtkRelievoCaves::~vtkRelievoCaves() = default;

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoCaves::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Function->GetMTime());
}

//------------------------------------------------------------------------------
int vtkRelievoCaves::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  const int extent[] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, this->Size[2] - 1 };
  const bool empty = std::min({ this->Size[0], this->Size[1], this->Size[2] }) < 1;
  const int none[] = { 0, -1, 0, -1, 0, -1 };
  info->Set(SDDP::WHOLE_EXTENT(), empty ? none : extent, 6);
  info->Set(vtkDataObject::ORIGIN(), this->Origin, 3);
  info->Set(vtkDataObject::SPACING(), this->Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, this->Content == DENSITY ? VTK_FLOAT : VTK_UNSIGNED_CHAR, 1);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoCaves::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  image->Initialize(); // of the last update
  relievo::Begin(outputs);
  this->NumberOfEvaluations = 0;
  this->NumberOfAirSamples = 0;
  // The pipeline requests an empty image again and again.
  const bool isSaid = this->GetMTime() == this->RefusedAt;
  this->SetErrorCode(vtkErrorCode::NoError);
  relievo::CaveGrid grid;
  std::copy_n(info->Get(SDDP::UPDATE_EXTENT()), 6, grid.Extent.begin());
  std::copy_n(this->Origin, 3, grid.Origin.begin());
  std::copy_n(this->Spacing, 3, grid.Spacing.begin());
  relievo::CaveSettings settings;
  settings.Field = this->Function->GetField();
  settings.Skipping = this->Skipping;
  settings.GoOn = [this](double progress) {
    this->UpdateProgress(progress);
    return !relievo::IsStopped(this);
  };
  std::string problem = FindProblem(this, settings.Field);
  double samples = 1.;
  for (int axis = 0; axis < 3; ++axis)
  {
    samples *=
      std::max(static_cast<double>(grid.Extent[2 * axis + 1]) - grid.Extent[2 * axis] + 1., 0.);
  }
  if (problem.empty())
  {
    const double bytes =
      samples * (this->Content == DENSITY ? sizeof(float) : sizeof(unsigned char));
    problem = relievo::LackOfMemory(bytes, this->MemoryLimit);
    problem += problem.empty() ? "" : "; make it in pieces, or with a smaller Size";
  }
  if (!problem.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    if (!isSaid)
    {
      vtkErrorMacro("No caves: " << problem << ".");
    }
    this->RefusedAt = this->GetMTime();
    return 1;
  }
  image->SetExtent(grid.Extent.data());
  image->SetOrigin(this->Origin);
  image->SetSpacing(this->Spacing);
  if (samples == 0.) // an empty piece
  {
    return 1;
  }
  relievo::CaveCounts counts;
  if (this->Content == DENSITY)
  {
    vtkNew<vtkFloatArray> density;
    density->SetName("density");
    density->SetNumberOfValues(image->GetNumberOfPoints());
    counts = relievo::MakeCaveDensity(grid, settings, density->GetPointer(0));
    image->GetPointData()->SetScalars(density);
  }
  else
  {
    const bool labels = this->Content == LABELS;
    vtkNew<vtkUnsignedCharArray> mask;
    mask->SetName(labels ? "label" : "cave");
    mask->SetNumberOfValues(image->GetNumberOfPoints());
    counts =
      relievo::MakeCaveMask(grid, settings, static_cast<unsigned char>(labels ? this->AirLabel : 1),
        static_cast<unsigned char>(labels ? this->RockLabel : 0), mask->GetPointer(0));
    image->GetPointData()->SetScalars(mask);
  }
  if (counts.Stopped)
  {
    relievo::Discard(outputs);
    return 1;
  }
  this->NumberOfEvaluations = counts.Evaluations;
  this->NumberOfAirSamples = counts.Air;
  return 1;
}

//------------------------------------------------------------------------------
vtkRelievoCaveFunction* vtkRelievoCaves::GetFunction()
{
  return this->Function;
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::SetSeed(int seed)
{
  this->Function->SetSeed(seed);
}

//------------------------------------------------------------------------------
int vtkRelievoCaves::GetSeed()
{
  return this->Function->GetSeed();
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::SetScale(double scale)
{
  this->Function->SetScale(scale);
}

//------------------------------------------------------------------------------
double vtkRelievoCaves::GetScale()
{
  return this->Function->GetScale();
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::SetVerticalScale(double scale)
{
  this->Function->SetVerticalScale(scale);
}

//------------------------------------------------------------------------------
double vtkRelievoCaves::GetVerticalScale()
{
  return this->Function->GetVerticalScale();
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::SetUp(int axis)
{
  this->Function->SetUp(axis);
}

//------------------------------------------------------------------------------
int vtkRelievoCaves::GetUp()
{
  return this->Function->GetUp();
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::SetTunnelWidth(double width)
{
  this->Function->SetTunnelWidth(width);
}

//------------------------------------------------------------------------------
double vtkRelievoCaves::GetTunnelWidth()
{
  return this->Function->GetTunnelWidth();
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::SetShell(double low, double high)
{
  this->Function->SetShell(low, high);
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::SetShell(const double shell[2])
{
  this->Function->SetShell(shell);
}

//------------------------------------------------------------------------------
double* vtkRelievoCaves::GetShell()
{
  return this->Function->GetShell();
}

//------------------------------------------------------------------------------
void vtkRelievoCaves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  os << indent << "Skipping: " << (this->Skipping ? "on" : "off") << "\n";
  os << indent << "NumberOfEvaluations: " << this->NumberOfEvaluations << "\n";
  os << indent << "NumberOfAirSamples: " << this->NumberOfAirSamples << "\n";
  os << indent << "Function:\n";
  this->Function->PrintSelf(os, indent.GetNextIndent());
}
