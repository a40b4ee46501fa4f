// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleInputs.h"

#include "vtkRelievoVoxelDepths.h"
#include "vtkRelievoVoxelMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstring>

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace vtkRelievoParticleInputs
{
//------------------------------------------------------------------------------
vtkDataObject* Get(vtkInformationVector** inputs, int port)
{
  return inputs[port]->GetNumberOfInformationObjects() > 0 ? vtkDataObject::GetData(inputs[port])
                                                           : nullptr;
}

//------------------------------------------------------------------------------
std::vector<vtkMTimeType> GetStamps(vtkInformationVector** inputs)
{
  std::vector<vtkMTimeType> stamps;
  for (int port = 0; port < PORTS; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* data = vtkDataObject::GetData(inputs[port], i);
      stamps.push_back(data->GetMTime());
      stamps.push_back(data->GetUpdateTime());
      for (vtkDataSet* leaf : vtkRelievoVoxelMeshes::GetLeaves(data))
      {
        stamps.push_back(leaf->GetMTime());
      }
    }
    stamps.push_back(0);
  }
  return stamps;
}

//------------------------------------------------------------------------------
void RequestWhole(vtkInformation* input)
{
  if (input->Has(SDDP::TIME_STEPS()) && input->Length(SDDP::TIME_STEPS()) > 0)
  {
    input->Set(SDDP::UPDATE_TIME_STEP(), input->Get(SDDP::TIME_STEPS())[0]);
  }
  else if (input->Has(SDDP::TIME_RANGE()))
  {
    input->Set(SDDP::UPDATE_TIME_STEP(), input->Get(SDDP::TIME_RANGE())[0]);
  }
  else
  {
    input->Remove(SDDP::UPDATE_TIME_STEP());
  }
  if (input->Has(SDDP::WHOLE_EXTENT()))
  {
    input->Set(SDDP::UPDATE_EXTENT(), input->Get(SDDP::WHOLE_EXTENT()), 6);
  }
  input->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
  input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
std::pair<vtkIdType, vtkIdType> GetPiece(vtkInformation* output, vtkIdType count)
{
  const vtkIdType pieces =
    output->Has(SDDP::UPDATE_NUMBER_OF_PIECES()) ? output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) : 1;
  const vtkIdType piece =
    output->Has(SDDP::UPDATE_PIECE_NUMBER()) ? output->Get(SDDP::UPDATE_PIECE_NUMBER()) : 0;
  const auto cut = [&](vtkIdType i) { return count / pieces * i + std::min(count % pieces, i); };
  return { cut(piece), cut(piece + 1) };
}

//------------------------------------------------------------------------------
void Key::AddWord(std::uint64_t word)
{
  this->Hash = (this->Hash ^ word) * 0x9E3779B97F4A7C15U + 1;
  this->Hash ^= this->Hash >> 32;
}

//------------------------------------------------------------------------------
void Key::AddBytes(const void* bytes, std::size_t count)
{
  const auto* at = static_cast<const unsigned char*>(bytes);
  this->AddWord(count);
  for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t))
  {
    std::uint64_t word = 0;
    std::memcpy(&word, at + i, count - i < sizeof(word) ? count - i : sizeof(word));
    this->AddWord(word);
  }
}

//------------------------------------------------------------------------------
Key& Key::Add(double value)
{
  this->AddBytes(&value, sizeof(value));
  return *this;
}

//------------------------------------------------------------------------------
Key& Key::Add(const std::string& text)
{
  this->AddBytes(text.data(), text.size());
  return *this;
}

//------------------------------------------------------------------------------
Key& Key::Add(vtkDataArray* array)
{
  if (!array)
  {
    return this->Add(-1.);
  }
  this->Add(array->GetDataType()).Add(array->GetNumberOfComponents());
  const vtkIdType values = array->GetNumberOfValues();
  if (array->HasStandardMemoryLayout())
  {
    const auto size = static_cast<std::size_t>(array->GetDataTypeSize());
    this->AddBytes(
      values > 0 ? array->GetVoidPointer(0) : nullptr, size * static_cast<std::size_t>(values));
    return *this;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      this->Add(array->GetComponent(i, c));
    }
  }
  return *this;
}

//------------------------------------------------------------------------------
Key& Key::AddShape(vtkDataSet* data)
{
  this->Add(data->GetClassName());
  for (vtkFieldData* attributes : { static_cast<vtkFieldData*>(data->GetPointData()),
         static_cast<vtkFieldData*>(data->GetCellData()) })
  {
    this->Add(attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  }
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    this->Add(mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr);
    for (vtkCellArray* cells :
      { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
    {
      this->Add(cells->GetOffsetsArray()).Add(cells->GetConnectivityArray());
    }
  }
  else if (auto* image = vtkImageData::SafeDownCast(data))
  {
    this->AddBytes(image->GetExtent(), 6 * sizeof(int));
    this->AddBytes(image->GetSpacing(), 3 * sizeof(double));
    this->AddBytes(image->GetOrigin(), 3 * sizeof(double));
    this->AddBytes(image->GetDirectionMatrix()->GetData(), 9 * sizeof(double));
  }
  else
  {
    this->AddWord(data->GetMTime());
  }
  return *this;
}

//------------------------------------------------------------------------------
Key& Key::AddData(vtkDataObject* data, const std::string& array)
{
  for (vtkDataSet* leaf : vtkRelievoVoxelMeshes::GetLeaves(data))
  {
    this->AddShape(leaf);
    if (!array.empty())
    {
      this->Add(leaf->GetPointData()->GetArray(array.c_str()));
      this->Add(leaf->GetCellData()->GetArray(array.c_str()));
    }
  }
  return *this;
}

//------------------------------------------------------------------------------
Key& Key::AddImages(vtkInformationVector* images)
{
  std::vector<vtkImageData*> all;
  for (int i = 0; i < images->GetNumberOfInformationObjects(); ++i)
  {
    vtkRelievoVoxelDepths::Add(vtkDataObject::GetData(images, i), all);
  }
  for (vtkImageData* image : all)
  {
    this->AddShape(image).Add(image->GetPointData()->GetArray("depth"));
    this->Add(image->GetFieldData()->GetArray("worldToCamera"));
    this->Add(image->GetFieldData()->GetArray("worldToNDC"));
  }
  return *this;
}
}
