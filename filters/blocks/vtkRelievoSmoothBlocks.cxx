// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSmoothBlocks.h"

#include "vtkRelievoAbort.h"
#include "vtkRelievoBlockBytes.h"
#include "vtkRelievoBlockInput.h"
#include "vtkRelievoBlockMesh.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPrecision.h"

#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

vtkStandardNewMacro(vtkRelievoSmoothBlocks);

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
// The requested output: faces or seams.
int GetPort(vtkInformation* request)
{
  const int port = request->Has(vtkExecutive::FROM_OUTPUT_PORT())
    ? request->Get(vtkExecutive::FROM_OUTPUT_PORT())
    : 0;
  return std::max(port, 0);
}
}

//------------------------------------------------------------------------------
struct vtkRelievoSmoothBlocks::Internals
{
  // A vertex's normal needs the movements of adjacent vertices, which depend on their neighbours.
  static constexpr int GhostLevels = 2;

  std::set<vtkTypeInt64> Rigid;
  std::set<vtkTypeInt64> Level;
  std::set<vtkTypeInt64> Weighted;
  bool MissedGhosts = false; // the warning has been given
};

//------------------------------------------------------------------------------
vtkRelievoSmoothBlocks::vtkRelievoSmoothBlocks()
  : Internal(new Internals)
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::SCALARS);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  vtkRelievoParameterList& list = this->Parameters;
  list.AddWhole("air_label", vtkRelievoMember(AirLabel), -infinity, infinity, "",
    "The label of air, which has no surface.");
  list.AddNumber("strength", vtkRelievoMember(Strength), 0.0, 0.25, "blocks",
    "Movement of vertices. 0 leaves cubes, 0.125 makes a step a slope of 45 degrees.");
  list.AddChoice("surface", vtkRelievoMember(Surface), { "outside", "between_labels" },
    "The faces between blocks and air, or also those between two labels.");
  list.AddFlag("close_borders", vtkRelievoMember(CloseBorders),
    "Whether the surface is closed at the borders of the image.");
  list.AddChoice("normals", vtkRelievoMember(Normals),
    { "none", "across_materials", "within_materials" },
    "Point normals: the mean over all faces at a point, or over those of each label.");
  list
    .AddFlag("triangles", vtkRelievoMember(Triangles), "Whether the faces are cut into triangles.")
    .Advanced = true;
  vtkRelievoParameter& up = list.AddChoice("up", vtkRelievoMember(Up), { "x", "y", "z" },
    "The axis of the image that points up, for levels, noise and textures.");
  up.Label = "Up Axis";
  up.Advanced = true;
  list
    .AddNumber("noise_amplitude", vtkRelievoMember(NoiseAmplitude), 0.0, infinity, "blocks",
      "Amplitude of the noise added to heights.")
    .Advanced = true;
  list
    .AddNumber("noise_scale", vtkRelievoMember(NoiseScale), 0.1, infinity, "blocks",
      "Size of the noise's cells.")
    .Advanced = true;
  list.AddWhole("noise_seed", vtkRelievoMember(NoiseSeed), least, most, "", "Seed of the noise.")
    .Advanced = true;
  vtkRelievoParameter& noise = list.AddChoice("noise_dimensions", vtkRelievoMember(NoiseDimensions),
    { "ground_plane", "also_by_height" }, "Whether the noise also depends on height.", 2);
  noise.Advanced = true;
  list.AddFlag("texture_coordinates", vtkRelievoMember(TextureCoordinates),
    "Whether points have texture coordinates, which keep all lengths.");
  list
    .AddNumber("tile_size", vtkRelievoMember(TileSize), 0.0, infinity, "",
      "Size of one copy of the texture, in the data's units; 0 is the longest side of a block.")
    .Advanced = true;
  list
    .AddSize(
      "atlas", this->Atlas, [this](const int* tiles) { this->SetAtlas(tiles); }, 0,
      "Columns and rows of a texture with a tile for each label, from the lower left; 0 and 0: "
      "textures repeat.")
    .Advanced = true;
  list
    .AddFlag("material_weights", vtkRelievoMember(MaterialWeights),
      "Whether points have the share of each label, for soft borders between textures.")
    .Advanced = true;
  list
    .AddFlag("seams", vtkRelievoMember(Seams),
      "Whether the second output is made: edges that are not used by exactly two faces.")
    .Advanced = true;
  list
    .AddNumber("memory_limit", vtkRelievoMember(MemoryLimit), 0.0, infinity, "bytes",
      "Upper bound of the surface's memory; more is refused. 0: all free memory.")
    .Advanced = true;
  vtkRelievoParameter& precision = list.AddChoice("output_points_precision",
    vtkRelievoMember(OutputPointsPrecision), { "single", "double", "by_the_data" },
    "Type of the coordinates. By the data: double for surfaces far from the origin, else single.");
  precision.Label = "Points' Precision";
  precision.Advanced = true;
}

//------------------------------------------------------------------------------
vtkRelievoSmoothBlocks::~vtkRelievoSmoothBlocks() = default;

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(GetPort(request));
  if (output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    const int levels = output->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()) + Internals::GhostLevels;
    input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), levels);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  this->SetErrorCode(vtkErrorCode::NoError);
  relievo::Begin(outputs);
  if (image->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, image, association);
  if (!array && !this->GetInputArrayInformation(0)->Has(vtkDataObject::FIELD_NAME()))
  {
    array = image->GetPointData()->GetScalars();
    association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  }
  const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  std::string problem;
  if (!std::isfinite(this->Strength) || !std::isfinite(this->NoiseAmplitude) ||
    !std::isfinite(this->NoiseScale) || !std::isfinite(this->TileSize))
  {
    problem = "Strength, NoiseAmplitude, NoiseScale and TileSize must be finite";
  }
  relievo::BlockSettings settings;
  relievo::SetBlockGeometry(image, onPoints, settings);
  if (problem.empty() && relievo::CheckBlockLabels(image, array, onPoints, problem) &&
    !(std::abs(vtkMath::Determinant3x3(settings.Axes)) > 0.))
  {
    problem = "blocks of an image with this spacing and direction matrix have no volume";
  }
  if (!problem.empty())
  {
    // The output stays empty. Status 0 would make the pipeline report a second error.
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No surface of blocks: " << problem << ".");
    return 1;
  }

  int extent[6];
  image->GetExtent(extent);
  int whole[6];
  std::copy(extent, extent + 6, whole);
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  if (info->Has(SDDP::WHOLE_EXTENT()))
  {
    info->Get(SDDP::WHOLE_EXTENT(), whole);
  }
  relievo::BlockBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box.Size[axis] = extent[2 * axis + 1] - extent[2 * axis] + (onPoints ? 1 : 0);
    for (int side = 2 * axis; side < 2 * axis + 2; ++side)
    {
      box.Closed[side] = this->CloseBorders && extent[side] == whole[side];
    }
  }
  const relievo::HiddenBlocks hidden = relievo::FindHiddenBlocks(image, onPoints);
  const std::unique_ptr<relievo::BlockLabels> labels =
    relievo::BlockLabels::New(array, box, this->AirLabel, hidden.Marks, hidden.Bits);

  relievo::BlockMeshSettings mesh;
  mesh.Triangles = this->Triangles;
  mesh.SplitMaterials = this->Normals == WITHIN_MATERIALS;
  mesh.TextureCoordinates = this->TextureCoordinates;
  mesh.AtlasColumns = this->Atlas[0];
  mesh.AtlasRows = this->Atlas[1];
  mesh.TileSize = this->TileSize;
  if (!(mesh.TileSize > 0.))
  {
    const double* spacing = image->GetSpacing();
    mesh.TileSize = std::max({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) }) *
      (mesh.AtlasColumns > 0 && mesh.AtlasRows > 0 ? 2. : 1.);
  }
  mesh.Weights = this->MaterialWeights;
  mesh.WeightedLabels.assign(this->Internal->Weighted.begin(), this->Internal->Weighted.end());
  vtkInformation* asked = outputs->GetInformationObject(GetPort(request));
  const int levels = asked->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  mesh.Owned = relievo::FindOwnedBlocks(image, onPoints, box, whole);
  mesh.Included = relievo::GrowBlocks(mesh.Owned, levels, box.Size);
  // One more layer for the normals at the border; its faces are dropped.
  settings.Faces.Owners = relievo::GrowBlocks(mesh.Included, 1, box.Size);
  if (asked->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1 && !this->Internal->MissedGhosts)
  {
    for (int side = 0; side < 6; ++side)
    {
      const int layers = side & 1 ? box.Size[side / 2] - mesh.Owned[side] : mesh.Owned[side] - 1;
      this->Internal->MissedGhosts = this->Internal->MissedGhosts ||
        (extent[side] != whole[side] && layers < Internals::GhostLevels);
    }
    if (this->Internal->MissedGhosts)
    {
      vtkWarningMacro("The input does not give "
        << Internals::GhostLevels
        << " layers of ghost cells around each piece, so pieces do not fit together at their "
           "borders. A filter of ghost cells makes them.");
    }
  }
  const std::array<int, 6> all = { 1, box.Size[0], 1, box.Size[1], 1, box.Size[2] };
  mesh.HasGhosts = mesh.Owned != all;

  settings.Faces.BetweenLabels = this->Surface == BETWEEN_LABELS;
  settings.Strength = this->Strength;
  settings.Rigid = this->Internal->Rigid;
  settings.Level = this->Internal->Level;
  settings.Up = this->Up;
  settings.Noise.Amplitude = this->NoiseAmplitude;
  settings.Noise.Scale = this->NoiseScale;
  settings.Noise.Seed = static_cast<unsigned int>(this->NoiseSeed);
  settings.Noise.Solid = this->NoiseDimensions == 3;
  settings.Normals = this->Normals != NO_NORMALS;
  settings.Seams = this->Seams;
  settings.DoublePoints = this->OutputPointsPrecision == DEFAULT_PRECISION
    ? relievo::NeedsDouble(image, whole)
    : this->OutputPointsPrecision == DOUBLE_PRECISION;
  settings.GoOn = [this](double progress) {
    this->UpdateProgress(progress);
    return !relievo::IsStopped(this);
  };
  settings.HasRoom = [&](vtkIdType vertices, vtkIdType faces, vtkIdType seams) {
    const std::string lack =
      relievo::LackOfMemory(relievo::BytesOfBlocks(vertices, faces, settings, mesh, array) +
          relievo::BytesOfSeams(seams, settings),
        this->MemoryLimit);
    if (!lack.empty())
    {
      this->SetErrorCode(vtkErrorCode::UserError);
      vtkErrorMacro("No surface of blocks: " << lack << ". It would have " << faces
                                             << " faces; make it in pieces.");
    }
    return lack.empty();
  };
  // Also needed for face normals where those at a vertex cancel out.
  settings.KeepOffsets = settings.Normals || mesh.TextureCoordinates || mesh.Weights;
  relievo::BlockSurface surface;
  const relievo::Made made = relievo::MakeBlockSurface(*labels, settings, surface);
  if (made == relievo::Made::TooLarge)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No surface of blocks: it would have 2^32 points or more; make it in pieces.");
  }
  if (made == relievo::Made::Stopped && this->GetErrorCode() == vtkErrorCode::NoError)
  {
    relievo::Discard(outputs);
  }
  if (made != relievo::Made::Done)
  {
    return 1;
  }
  const relievo::BlockMeshReport report =
    relievo::MakeBlockMesh(surface, *labels, array, settings, mesh, output);
  if (report.TileSize > mesh.TileSize * (1. + 1e-6))
  {
    vtkWarningMacro("Some faces are larger than the tiles of the atlas, and textures are stretched "
                    "at their borders: TileSize is "
      << mesh.TileSize << ", and these faces need " << report.TileSize << ".");
  }
  if (report.WeightedLabels > relievo::BlockMeshSettings::MostWeights)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No weights of materials: there are "
      << report.WeightedLabels << " labels, and at most " << relievo::BlockMeshSettings::MostWeights
      << " can have weights; name those that shall (weighted labels).");
  }
  if (this->Seams)
  {
    relievo::MakeBlockSeams(surface, mesh.Owned, box.Size, vtkPolyData::GetData(outputs, 1));
  }
  this->UpdateProgress(1.);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::AddRigidLabel(vtkTypeInt64 label)
{
  if (this->Internal->Rigid.insert(label).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::ClearRigidLabels()
{
  this->Internal->Rigid.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::GetNumberOfRigidLabels()
{
  return static_cast<int>(this->Internal->Rigid.size());
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::AddLevelLabel(vtkTypeInt64 label)
{
  if (this->Internal->Level.insert(label).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::ClearLevelLabels()
{
  this->Internal->Level.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::GetNumberOfLevelLabels()
{
  return static_cast<int>(this->Internal->Level.size());
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::AddWeightedLabel(vtkTypeInt64 label)
{
  if (this->Internal->Weighted.insert(label).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::ClearWeightedLabels()
{
  this->Internal->Weighted.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::GetNumberOfWeightedLabels()
{
  return static_cast<int>(this->Internal->Weighted.size());
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  const auto print = [&](const char* name, const std::set<vtkTypeInt64>& labels) {
    os << indent << name << ":";
    for (const vtkTypeInt64 label : labels)
    {
      os << " " << label;
    }
    os << (labels.empty() ? " none\n" : "\n");
  };
  os << indent << "AirLabel: " << this->AirLabel << "\n";
  print("RigidLabels", this->Internal->Rigid);
  print("LevelLabels", this->Internal->Level);
  os << indent << "NoiseDimensions: " << this->NoiseDimensions << "\n";
  os << indent << "Atlas: " << this->Atlas[0] << " " << this->Atlas[1] << "\n";
  print("WeightedLabels", this->Internal->Weighted);
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
