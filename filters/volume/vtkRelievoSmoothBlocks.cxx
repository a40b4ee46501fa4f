// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSmoothBlocks.h"

#include "vtkRelievoBlockMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
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

vtkStandardNewMacro(vtkRelievoSmoothBlocks);

using SDDP = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
struct vtkRelievoSmoothBlocks::Internals
{
  // A vertex' face normals need the movements of its neighbours, which their neighbours decide.
  static constexpr int GhostLevels = 2;

  std::set<vtkTypeInt64> Rigid;
  std::set<vtkTypeInt64> Level;
  std::set<vtkTypeInt64> Weighted;

  /** The labels, and whether they are of points; null with words for the message. */
  static vtkDataArray* FindLabels(
    vtkRelievoSmoothBlocks* self, vtkImageData* image, bool& onPoints, std::string& problem)
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    vtkDataArray* labels = self->GetInputArrayToProcess(0, image, association);
    if (!labels && !self->GetInputArrayInformation(0)->Has(vtkDataObject::FIELD_NAME()))
    {
      labels = image->GetPointData()->GetScalars();
      association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    }
    onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
    if (!labels)
    {
      problem = "the image needs an array of labels, on cells or points; none was found "
                "(SetInputArrayToProcess chooses one)";
      return nullptr;
    }
    const std::string name = labels->GetName() ? labels->GetName() : "(unnamed)";
    const int type = labels->GetDataType();
    if (type == VTK_FLOAT || type == VTK_DOUBLE || type == VTK_BIT)
    {
      problem = "labels are whole numbers, but '" + name + "' is of type " +
        labels->GetDataTypeAsString() + "; convert it to an integer type first";
      return nullptr;
    }
    if (labels->GetNumberOfComponents() != 1)
    {
      problem = "labels have one component, but '" + name + "' has " +
        std::to_string(labels->GetNumberOfComponents());
      return nullptr;
    }
    int size[3];
    image->GetDimensions(size);
    if (!onPoints && std::min({ size[0], size[1], size[2] }) < 2)
    {
      problem = "the image is flat, so its cells are no blocks; it has " + std::to_string(size[0]) +
        " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
        " points. Put the labels on its points, or make it one cell thick";
      return nullptr;
    }
    return labels;
  }

  /** Blocks, numbered from 1, that belong to this piece. */
  static std::array<int, 6> FindOwned(
    vtkImageData* image, bool onPoints, const relievo::BlockBox& box, const int whole[6])
  {
    int extent[6];
    image->GetExtent(extent);
    const vtkIdType cells[3] = { std::max(extent[1] - extent[0], 1),
      std::max(extent[3] - extent[2], 1), std::max(extent[5] - extent[4], 1) };
    std::array<int, 6> owned = { 1, static_cast<int>(cells[0]), 1, static_cast<int>(cells[1]), 1,
      static_cast<int>(cells[2]) };
    vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
    if (ghosts && ghosts->GetNumberOfValues() == cells[0] * cells[1] * cells[2])
    {
      std::array<int, 6> found = { VTK_INT_MAX, 0, VTK_INT_MAX, 0, VTK_INT_MAX, 0 };
      for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
      {
        if (!(ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL))
        {
          const vtkIdType place[3] = { i % cells[0], i / cells[0] % cells[1],
            i / (cells[0] * cells[1]) };
          for (int axis = 0; axis < 3; ++axis)
          {
            const auto number = static_cast<int>(place[axis]) + 1;
            found[2 * axis] = std::min(found[2 * axis], number);
            found[2 * axis + 1] = std::max(found[2 * axis + 1], number);
          }
        }
      }
      owned = found;
    }
    for (int axis = 0; onPoints && axis < 3; ++axis)
    {
      // The last points of the last cells belong to the next piece, where there is one.
      int& last = owned[2 * axis + 1];
      const bool end =
        last == static_cast<int>(cells[axis]) && extent[2 * axis + 1] == whole[2 * axis + 1];
      last = end ? box.Size[axis] : std::min(last, box.Size[axis]);
    }
    return owned;
  }

  static void SetGeometry(vtkImageData* image, bool onPoints, relievo::BlockSettings& settings)
  {
    int extent[6];
    image->GetExtent(extent);
    for (int axis = 0; axis < 3; ++axis)
    {
      settings.First[axis] = extent[2 * axis] - (onPoints ? 0.5 : 0.);
      settings.Origin[axis] = image->GetOrigin()[axis];
      for (int row = 0; row < 3; ++row)
      {
        settings.Axes[row][axis] =
          image->GetDirectionMatrix()->GetElement(row, axis) * image->GetSpacing()[axis];
      }
    }
  }

  static std::array<int, 6> Grow(
    const std::array<int, 6>& box, int by, const std::array<int, 3>& size)
  {
    std::array<int, 6> grown = box;
    for (int axis = 0; axis < 3; ++axis)
    {
      grown[2 * axis] = std::max(box[2 * axis] - by, 1);
      grown[2 * axis + 1] = std::min(box[2 * axis + 1] + by, size[axis]);
    }
    return grown;
  }

  static void MakeSeams(const relievo::BlockSurface& surface, const std::array<int, 6>& owned,
    const std::array<int, 3>& size, vtkPolyData* output)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(surface.Points->GetDataType());
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkIntArray> uses;
    uses->SetName("uses");
    for (const relievo::BlockSeam& seam : surface.Seams)
    {
      bool mine = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        // Vertex i is below block i + 1; the last ones have no such block.
        const int last = owned[2 * axis + 1];
        const int vertex = seam.Vertex[axis] + 1;
        mine = mine && vertex >= owned[2 * axis] &&
          (vertex <= last || (last == size[axis] && vertex == last + 1));
      }
      if (mine)
      {
        lines->InsertNextCell(2);
        for (const vtkIdType point : seam.Points)
        {
          double place[3];
          surface.Points->GetTuple(point, place);
          lines->InsertCellPoint(points->InsertNextPoint(place));
        }
        uses->InsertNextValue(seam.Uses);
      }
    }
    output->SetPoints(points);
    output->SetLines(lines);
    output->GetCellData()->AddArray(uses);
  }
};

//------------------------------------------------------------------------------
vtkRelievoSmoothBlocks::vtkRelievoSmoothBlocks()
  : Self(new Internals)
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::SCALARS);
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
  vtkInformation* output = outputs->GetInformationObject(0);
  if (output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    const int levels = output->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()) + Internals::GhostLevels;
    input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), levels);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  this->SetErrorCode(vtkErrorCode::NoError);
  if (image->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  bool onPoints = false;
  std::string problem;
  vtkDataArray* array = Internals::FindLabels(this, image, onPoints, problem);
  relievo::BlockSettings settings;
  Internals::SetGeometry(image, onPoints, settings);
  if (array && !(std::abs(vtkMath::Determinant3x3(settings.Axes)) > 0.))
  {
    array = nullptr;
    problem = "blocks of an image with this spacing and direction matrix have no volume";
  }
  if (!array)
  {
    // The output stays empty. Status 0 would make the pipeline say it again in its own words.
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
  vtkUnsignedCharArray* ghosts =
    onPoints ? image->GetPointGhostArray() : image->GetCellGhostArray();
  const auto hiding = static_cast<unsigned char>(
    onPoints ? int(vtkDataSetAttributes::HIDDENPOINT) : int(vtkDataSetAttributes::HIDDENCELL));
  const std::unique_ptr<relievo::BlockLabels> labels =
    relievo::BlockLabels::New(array, box, this->AirLabel, ghosts, hiding);

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
  mesh.WeightedLabels.assign(this->Self->Weighted.begin(), this->Self->Weighted.end());
  const int levels = outputs->GetInformationObject(0)->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  mesh.Owned = Internals::FindOwned(image, onPoints, box, whole);
  mesh.Kept = Internals::Grow(mesh.Owned, levels, box.Size);
  // One more layer, for the normals at the border; its own faces are dropped.
  settings.Faces.Owners = Internals::Grow(mesh.Kept, 1, box.Size);
  const std::array<int, 6> all = { 1, box.Size[0], 1, box.Size[1], 1, box.Size[2] };
  mesh.HasGhosts = mesh.Owned != all;

  settings.Faces.BetweenLabels = this->Surface == BETWEEN_LABELS;
  settings.Strength = this->Strength;
  settings.Rigid = this->Self->Rigid;
  settings.Level = this->Self->Level;
  settings.Up = this->Up;
  settings.Noise.Amplitude = this->NoiseAmplitude;
  settings.Noise.Scale = this->NoiseScale;
  settings.Noise.Seed = static_cast<unsigned int>(this->NoiseSeed);
  settings.Noise.Solid = this->NoiseDimensions == 3;
  settings.Normals = this->Normals != NO_NORMALS;
  settings.Seams = this->Seams;
  settings.DoublePoints = this->OutputPointsPrecision == DOUBLE_PRECISION;
  settings.GoOn = [this](double progress) {
    this->UpdateProgress(progress);
    return !this->GetAbortExecute();
  };
  settings.KeepOffsets = mesh.SplitMaterials || mesh.TextureCoordinates || mesh.Weights;
  relievo::BlockSurface surface;
  const relievo::Made made = relievo::MakeBlockSurface(*labels, settings, surface);
  if (made == relievo::Made::TooLarge)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No surface of blocks: it would have 2^32 points or more; make it in pieces.");
  }
  if (made != relievo::Made::Done)
  {
    return 1;
  }
  const vtkIdType weighted =
    relievo::MakeBlockMesh(surface, *labels, array, settings, mesh, output);
  if (weighted > relievo::BlockMeshSettings::MostWeights)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No weights of materials: there are "
      << weighted << " labels, and at most " << relievo::BlockMeshSettings::MostWeights
      << " can have weights; choose some with AddWeightedLabel.");
  }
  if (this->Seams)
  {
    Internals::MakeSeams(surface, mesh.Owned, box.Size, vtkPolyData::GetData(outputs, 1));
  }
  this->UpdateProgress(1.);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::AddRigidLabel(vtkTypeInt64 label)
{
  if (this->Self->Rigid.insert(label).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::ClearRigidLabels()
{
  this->Self->Rigid.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::GetNumberOfRigidLabels()
{
  return static_cast<int>(this->Self->Rigid.size());
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::AddLevelLabel(vtkTypeInt64 label)
{
  if (this->Self->Level.insert(label).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::ClearLevelLabels()
{
  this->Self->Level.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::GetNumberOfLevelLabels()
{
  return static_cast<int>(this->Self->Level.size());
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::AddWeightedLabel(vtkTypeInt64 label)
{
  if (this->Self->Weighted.insert(label).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::ClearWeightedLabels()
{
  this->Self->Weighted.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoSmoothBlocks::GetNumberOfWeightedLabels()
{
  return static_cast<int>(this->Self->Weighted.size());
}

//------------------------------------------------------------------------------
void vtkRelievoSmoothBlocks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const std::set<vtkTypeInt64>& labels) {
    os << indent << name << ":";
    for (const vtkTypeInt64 label : labels)
    {
      os << " " << label;
    }
    os << (labels.empty() ? " none\n" : "\n");
  };
  os << indent << "AirLabel: " << this->AirLabel << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Surface: " << this->Surface << "\n";
  os << indent << "CloseBorders: " << (this->CloseBorders ? "on" : "off") << "\n";
  os << indent << "Triangles: " << (this->Triangles ? "on" : "off") << "\n";
  os << indent << "Normals: " << this->Normals << "\n";
  print("RigidLabels", this->Self->Rigid);
  print("LevelLabels", this->Self->Level);
  os << indent << "Up: " << this->Up << "\n";
  os << indent << "NoiseAmplitude: " << this->NoiseAmplitude << "\n";
  os << indent << "NoiseScale: " << this->NoiseScale << "\n";
  os << indent << "NoiseSeed: " << this->NoiseSeed << "\n";
  os << indent << "NoiseDimensions: " << this->NoiseDimensions << "\n";
  os << indent << "TextureCoordinates: " << (this->TextureCoordinates ? "on" : "off") << "\n";
  os << indent << "TileSize: " << this->TileSize << "\n";
  os << indent << "Atlas: " << this->Atlas[0] << " " << this->Atlas[1] << "\n";
  os << indent << "MaterialWeights: " << (this->MaterialWeights ? "on" : "off") << "\n";
  print("WeightedLabels", this->Self->Weighted);
  os << indent << "Seams: " << (this->Seams ? "on" : "off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
