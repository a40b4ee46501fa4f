// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSurfaceParticles.h"

#include "vtkRelievoAbort.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoParticleInputs.h"
#include "vtkRelievoParticleOutput.h"
#include "vtkRelievoParticleStart.h"
#include "vtkRelievoParticleSteps.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoVoxelDepths.h"
#include "vtkRelievoVoxelFit.h"
#include "vtkRelievoVoxelMeshes.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkRelievoSurfaceParticles);

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace Inputs = vtkRelievoParticleInputs;

// The results for the inputs and settings of the last update.
struct vtkRelievoSurfaceParticles::Internals
{
  std::vector<vtkMTimeType> Stamps; // of the last update
  Inputs::Key MapsKey;              // of the data that the maps were made from
  Inputs::Key FieldKey;
  Inputs::Key StepsKey;
  vtkRelievoParticleMaps Maps;
  vtkRelievoParticleField Field;
  std::unique_ptr<vtkRelievoParticleSteps> Steps;
  vtkSmartPointer<vtkIdTypeArray> Numbers;
  vtkSmartPointer<vtkCellArray> Vertices;

  // Bytes held for particles, which are reused or freed before new ones are made.
  double GetBytesHeld() const;
  std::string Update(vtkRelievoSurfaceParticles* self, vtkInformationVector** inputs,
    vtkIdType first, vtkIdType end);
  std::string MakeMaps(vtkRelievoSurfaceParticles* self, vtkInformationVector** inputs);
  std::string MakeField(vtkRelievoSurfaceParticles* self, vtkInformationVector** inputs);
  void MakeSteps(
    vtkRelievoSurfaceParticles* self, vtkDataSet* points, vtkIdType first, vtkIdType end);
};

//------------------------------------------------------------------------------
double vtkRelievoSurfaceParticles::Internals::GetBytesHeld() const
{
  const double numbers =
    this->Numbers ? static_cast<double>(this->Numbers->GetNumberOfValues()) : 0.;
  return numbers * 3. * sizeof(vtkIdType) + (this->Steps ? this->Steps->GetBytesHeld() : 0.);
}

//------------------------------------------------------------------------------
// Remakes only the results whose inputs or settings changed. Returns the error, or an empty text.
std::string vtkRelievoSurfaceParticles::Internals::Update(
  vtkRelievoSurfaceParticles* self, vtkInformationVector** inputs, vtkIdType first, vtkIdType end)
{
  auto* points = vtkDataSet::SafeDownCast(Inputs::Get(inputs, Inputs::POINTS));
  vtkDataObject* surface = Inputs::Get(inputs, Inputs::SURFACE);
  Inputs::Key maps;
  maps.AddImages(inputs[Inputs::IMAGES]).Add(self->MemoryLimit);
  maps.Add(inputs[Inputs::IMAGES]->GetNumberOfInformationObjects());
  maps.Add(self->TexelSize).Add(self->Resolution).AddData(surface, {});
  vtkDataObject* given = Inputs::Get(inputs, Inputs::FIELD);
  Inputs::Key field = maps;
  field.Add(self->FieldArray).Add(given ? 1. : 0.);
  if (!self->FieldArray.empty())
  {
    field.AddData(given ? given : surface, self->FieldArray);
  }
  Inputs::Key steps = field;
  steps.Add(self->Place).Add(self->Seed).Add(self->NoiseSpeed).Add(self->NoiseScale);
  steps.Add(self->Velocity[0]).Add(self->Velocity[1]).Add(self->Velocity[2]);
  steps.Add(self->TimeStep).Add(self->NumberOfSteps).Add(self->Checkpoints);
  steps.Add(static_cast<double>(self->NumberOfParticles)).AddData(points, {});
  steps.Add(static_cast<double>(first)).Add(static_cast<double>(end));
  if (this->StepsKey == steps)
  {
    return {};
  }
  this->Steps.reset();
  this->Numbers = nullptr;
  this->StepsKey = {};
  std::string problem;
  if (!(this->MapsKey == maps))
  {
    problem = this->MakeMaps(self, inputs);
    this->MapsKey = problem.empty() ? maps : Inputs::Key();
  }
  if (problem.empty() && !(this->FieldKey == field))
  {
    problem = this->MakeField(self, inputs);
    this->FieldKey = problem.empty() ? field : Inputs::Key();
  }
  if (problem.empty())
  {
    this->MakeSteps(self, points, first, end);
    this->StepsKey = steps;
  }
  return problem;
}

//------------------------------------------------------------------------------
// Returns the error, or an empty text.
std::string vtkRelievoSurfaceParticles::Internals::MakeMaps(
  vtkRelievoSurfaceParticles* self, vtkInformationVector** inputs)
{
  this->Maps.Views.clear();
  if (inputs[Inputs::IMAGES]->GetNumberOfInformationObjects() > 0)
  {
    std::vector<vtkImageData*> images;
    for (int i = 0; i < inputs[Inputs::IMAGES]->GetNumberOfInformationObjects(); ++i)
    {
      vtkRelievoVoxelDepths::Add(vtkDataObject::GetData(inputs[Inputs::IMAGES], i), images);
    }
    return images.size() > 255
      ? "there are " + std::to_string(images.size()) + " depth images, expected up to 255"
      : this->Maps.SetImages(images);
  }
  vtkDataObject* surface = Inputs::Get(inputs, Inputs::SURFACE);
  double box[6];
  if (!surface)
  {
    return "there is no input; give a surface (input 0) or depth images (input 1)";
  }
  if (!vtkRelievoVoxelMeshes::GetBounds(surface, box))
  {
    return {};
  }
  vtkRelievoVoxelFit fit;
  fit.CellSize = self->TexelSize;
  fit.Resolution = self->Resolution;
  const std::string problem = fit.FindProblem(box);
  if (!problem.empty())
  {
    return problem;
  }
  const std::array<double, 3> count = fit.Count(box);
  // Two maps per axis, and the two depths read from the surface.
  const double bytes = (count[0] * count[1] + count[1] * count[2] + count[2] * count[0]) *
    static_cast<double>(2 * vtkRelievoParticleView::GetBytesPerTexel() + 2 * sizeof(double));
  const std::string lack = relievo::LackOfMemory(bytes, self->MemoryLimit);
  if (!lack.empty())
  {
    return "for the maps " + lack + "; make texels larger or the limit higher";
  }
  this->Maps.SetSurface(surface, fit.Fit(box));
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoSurfaceParticles::Internals::MakeField(
  vtkRelievoSurfaceParticles* self, vtkInformationVector** inputs)
{
  vtkDataObject* given = Inputs::Get(inputs, Inputs::FIELD);
  vtkDataObject* data = given ? given : Inputs::Get(inputs, Inputs::SURFACE);
  if (self->FieldArray.empty() || (!data && this->Maps.GetNumberOfSeenTexels() == 0))
  {
    this->Field.ClearArray();
    return {};
  }
  return data ? this->Field.SetArray(data, self->FieldArray)
              : "FieldArray '" + self->FieldArray + "' needs data that have it: input 3 or 0";
}

//------------------------------------------------------------------------------
void vtkRelievoSurfaceParticles::Internals::MakeSteps(
  vtkRelievoSurfaceParticles* self, vtkDataSet* points, vtkIdType first, vtkIdType end)
{
  const bool inside = self->Place == INSIDE;
  const vtkRelievoParticleStart start(this->Maps, inside, static_cast<unsigned int>(self->Seed));
  glm::dvec3 low;
  glm::dvec3 high;
  this->Field.Velocity = glm::dvec3(self->Velocity[0], self->Velocity[1], self->Velocity[2]);
  this->Field.NoiseSeed = static_cast<unsigned int>(self->Seed);
  this->Field.Near = this->Maps.GetTexelSize();
  const bool seen = start.GetBox(low, high);
  const glm::dvec3 size = seen ? high - low : glm::dvec3(1.);
  const double longest = std::max({ size.x, size.y, size.z, this->Maps.GetTexelSize() });
  this->Field.NoiseScale = self->NoiseScale > 0. ? self->NoiseScale : longest / 5.;
  this->Field.NoiseSpeed = self->NoiseSpeed < 0. ? longest / 100. : self->NoiseSpeed;
  if (!std::isfinite(this->Field.NoiseSpeed))
  {
    this->Field.NoiseSpeed = 0.;
  }
  if (!inside)
  {
    vtkRelievoParticleSteps::SetVelocities(this->Maps, this->Field);
  }
  this->Steps = std::make_unique<vtkRelievoParticleSteps>(this->Maps, this->Field, inside);
  this->Steps->Begin(
    points ? start.AtPoints(points, first, end) : start.Spread(first, end, self->NumberOfParticles),
    self->TimeStep, self->NumberOfSteps, self->Checkpoints);
}

//------------------------------------------------------------------------------
vtkRelievoSurfaceParticles::vtkRelievoSurfaceParticles()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(Inputs::PORTS);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  vtkRelievoParameterList& list = this->Parameters;
  list.AddChoice(
    "place", vtkRelievoMember(Place), { "on_surface", "inside" }, "Where particles move.");
  list.AddNumber("noise_speed", vtkRelievoMember(NoiseSpeed), -infinity, infinity, "",
    "Speed by the curl of noise, in the data's units per unit of time; negative: a hundredth of "
    "the longest side.");
  list.AddNumber("noise_scale", vtkRelievoMember(NoiseScale), 0.0, infinity, "",
    "Width of whirls in the data's units; 0: a fifth of the longest side.");
  list.AddVector("velocity", vtkRelievoMember(Velocity),
    "A constant velocity, in the data's units per unit of time, added to the noise.");
  list.AddText(
    "field_array", [this] { return this->FieldArray; },
    [this](const std::string& array) { this->SetFieldArray(array.c_str()); },
    "The name of an array of 3 components, at points or cells, that is also added. Empty: none.");
  list.AddWhole("number_of_particles", vtkRelievoMember(NumberOfParticles), 0.0, infinity, "",
    "Number of particles if no points are given.");
  list.AddWhole("resolution", vtkRelievoMember(Resolution), 1, 16384, "texels",
    "Texels of the depth maps along the longest side. Particles are within one of the surface.");
  list.AddWhole(
    "number_of_steps", vtkRelievoMember(NumberOfSteps), 0, 100000000, "", "Number of time steps.");
  vtkRelievoParameter& step = list.AddNumber("time_step", vtkRelievoMember(TimeStep), 0.0, infinity,
    "", "The time from one step to the next.");
  step.Open = step.Advanced = true;
  list
    .AddNumber("start_time", vtkRelievoMember(StartTime), -infinity, infinity, "",
      "The time at which particles start.")
    .Advanced = true;
  list
    .AddWhole("checkpoints", vtkRelievoMember(Checkpoints), 0, 10000, "",
      "Steps to cache, so that earlier times need not be computed from the start: 25 bytes per "
      "particle each.")
    .Advanced = true;
  list
    .AddWhole(
      "seed", vtkRelievoMember(Seed), least, most, "", "Seed of starting positions and of noise.")
    .Advanced = true;
  list
    .AddNumber("texel_size", vtkRelievoMember(TexelSize), 0.0, infinity, "",
      "Side of the texels in the data's units; 0: set by Resolution.")
    .Advanced = true;
  list
    .AddFlag("orientations", vtkRelievoMember(Orientations),
      "Whether points have the array orientation: quaternions that rotate x to the normal and y to "
      "the velocity.")
    .Advanced = true;
  list
    .AddNumber("memory_limit", vtkRelievoMember(MemoryLimit), 0.0, infinity, "bytes",
      "Upper bound of the memory of maps and particles; more is refused. 0: all free memory.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
vtkRelievoSurfaceParticles::~vtkRelievoSurfaceParticles() = default;

//------------------------------------------------------------------------------
void vtkRelievoSurfaceParticles::SetFieldArray(const char* name)
{
  const std::string given = name ? name : "";
  if (this->FieldArray != given)
  {
    this->FieldArray = given;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoSurfaceParticles::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    port == Inputs::IMAGES ? "vtkImageData" : "vtkDataSet");
  if (port != Inputs::POINTS)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  if (port == Inputs::IMAGES)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoSurfaceParticles::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  std::vector<double> times(static_cast<std::size_t>(this->NumberOfSteps) + 1);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    times[i] = this->StartTime + static_cast<double>(i) * this->TimeStep;
  }
  const double range[2] = { times.front(), times.back() };
  output->Set(SDDP::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  output->Set(SDDP::TIME_RANGE(), range, 2);
  output->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoSurfaceParticles::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < Inputs::PORTS; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      Inputs::RequestWhole(inputs[port]->GetInformationObject(i));
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoSurfaceParticles::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(info);
  output->Initialize();
  relievo::Begin(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  Internals& self = *this->Internal;

  double steps = 0.;
  if (info->Has(SDDP::UPDATE_TIME_STEP()))
  {
    steps = (info->Get(SDDP::UPDATE_TIME_STEP()) - this->StartTime) / this->TimeStep;
    steps = steps > 0. ? std::min(steps, static_cast<double>(this->NumberOfSteps)) : 0.;
  }
  output->GetInformation()->Set(
    vtkDataObject::DATA_TIME_STEP(), this->StartTime + steps * this->TimeStep);

  auto* points = vtkDataSet::SafeDownCast(Inputs::Get(inputs, Inputs::POINTS));
  const vtkIdType count = points ? points->GetNumberOfPoints() : this->NumberOfParticles;
  const std::pair<vtkIdType, vtkIdType> piece = Inputs::GetPiece(info, count);
  const vtkIdType first = piece.first;
  const vtkIdType end = piece.second;

  const double bytes =
    vtkRelievoParticleSteps::EstimateBytes(end - first, this->NumberOfSteps, this->Checkpoints);
  std::string problem = relievo::LackOfMemory(bytes, this->MemoryLimit, self.GetBytesHeld());
  problem = problem.empty() ? problem
                            : "for " + std::to_string(end - first) + " of them " + problem +
      "; ask for fewer or a higher limit";
  const vtkRelievoParticleState* state = nullptr;
  const vtkRelievoParticleOutput out{ self.Maps, self.Field, this->Place == INSIDE,
    this->Orientations, self.Numbers, self.Vertices };
  std::string replaced;
  const auto work = [&]() {
    std::vector<vtkMTimeType> stamps = Inputs::GetStamps(inputs);
    stamps.insert(stamps.end(),
      { this->GetMTime(), static_cast<vtkMTimeType>(first), static_cast<vtkMTimeType>(end) });
    if (self.Stamps != stamps)
    {
      self.Stamps.clear();
      problem = self.Update(this, inputs, first, end);
      if (!problem.empty())
      {
        return;
      }
      self.Stamps = stamps;
      replaced = out.FindReplaced(points);
    }
    state = self.Steps->Get(steps, [this](double done) {
      this->UpdateProgress(0.1 + 0.8 * done);
      return !relievo::IsStopped(this);
    });
    if (state)
    {
      out.Write(*state, first, points, output);
    }
  };
  if (problem.empty())
  {
    vtkRelievoWithThreads(work);
  }
  if (!replaced.empty())
  {
    vtkWarningMacro("The point data " << replaced << " of the starting points are left out: "
                                      << "particles have their own of this name. Rename them to "
                                      << "have both.");
  }
  if (!problem.empty())
  {
    // The output stays empty. Status 0 would make the pipeline report a second error.
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No particles: " << problem << ".");
  }
  else if (!state)
  {
    relievo::Discard(outputs);
  }
  return 1;
}

//------------------------------------------------------------------------------
double vtkRelievoSurfaceParticles::GetUsedTexelSize()
{
  return this->Internal->Maps.GetTexelSize();
}

//------------------------------------------------------------------------------
void vtkRelievoSurfaceParticles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  os << indent << "NumberOfParticles: " << this->NumberOfParticles << "\n";
}
