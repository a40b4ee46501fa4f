// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelPieces.h"

#include "vtkAlgorithm.h"
#include "vtkExtentTranslator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

using SDDP = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
void vtkRelievoVoxelPieces::UpdateWhole(vtkAlgorithm* producer, int port)
{
  vtkNew<vtkInformation> whole;
  whole->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
  whole->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
  whole->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(port + 1);
  requests->SetInformationObject(port, whole);
  producer->Update(port, requests);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelPieces::SetWhole(vtkInformation* output, const std::array<int, 6>& extent)
{
  std::array<int, 6> before{ { 0, -1, 0, -1, 0, -1 } };
  std::array<int, 6> asked = before;
  if (output->Has(SDDP::WHOLE_EXTENT()) && output->Has(SDDP::UPDATE_EXTENT()))
  {
    output->Get(SDDP::WHOLE_EXTENT(), before.data());
    output->Get(SDDP::UPDATE_EXTENT(), asked.data());
  }
  bool within = asked != before;
  for (std::size_t i = 0; i < 6; i += 2)
  {
    within = within && asked[i] >= extent[i] && asked[i + 1] <= extent[i + 1];
  }
  output->Set(SDDP::WHOLE_EXTENT(), extent.data(), 6);
  if (!within)
  {
    output->Set(SDDP::UPDATE_EXTENT(), extent.data(), 6);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelPieces::Crop(vtkImageData* image, vtkInformation* output)
{
  if (image->GetNumberOfCells() == 0)
  {
    return;
  }
  std::array<int, 6> asked;
  output->Get(SDDP::UPDATE_EXTENT(), asked.data());
  std::array<int, 6> part;
  image->GetExtent(part.data());
  bool empty = false;
  for (std::size_t i = 0; i < 6; i += 2)
  {
    part[i] = std::max(part[i], asked[i]);
    part[i + 1] = std::min(part[i + 1], asked[i + 1]);
    empty = empty || part[i] >= part[i + 1]; // a single layer of points has no cells
  }
  if (empty)
  {
    image->Initialize();
    return;
  }
  image->Crop(part.data());
}

//------------------------------------------------------------------------------
std::array<int, 6> vtkRelievoVoxelPieces::Of(vtkInformation* input, vtkInformation* output)
{
  std::array<int, 6> whole;
  input->Get(SDDP::WHOLE_EXTENT(), whole.data());
  std::array<int, 6> piece = whole;
  const int pieces = output->Get(SDDP::UPDATE_NUMBER_OF_PIECES());
  if (pieces > 1)
  {
    vtkNew<vtkExtentTranslator> translator;
    if (!translator->PieceToExtentThreadSafe(output->Get(SDDP::UPDATE_PIECE_NUMBER()), pieces, 0,
          whole.data(), piece.data(), vtkExtentTranslator::BLOCK_MODE, 0))
    {
      piece = { { 0, -1, 0, -1, 0, -1 } };
    }
  }
  return piece;
}
