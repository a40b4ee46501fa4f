// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoTerrainReader.h"

#include "vtkRelievoGeoTIFFReader.h"
#include "vtkRelievoTerrain.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkPVRelievoTerrainReader);

//------------------------------------------------------------------------------
vtkPVRelievoTerrainReader::vtkPVRelievoTerrainReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkPVRelievoTerrainReader::~vtkPVRelievoTerrainReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkPVRelievoTerrainReader::CanReadFile(const char* name)
{
  return vtkRelievoGeoTIFFReader::CanReadFile(name);
}

//------------------------------------------------------------------------------
int vtkPVRelievoTerrainReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // The first piece has everything, so that parallel processes together have it once.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* output = outputs->GetInformationObject(0);
  if (output->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkNew<vtkRelievoGeoTIFFReader> reader;
  reader->SetFileName(this->FileName);
  vtkNew<vtkRelievoTerrain> terrain;
  terrain->SetInputConnection(reader->GetOutputPort());
  terrain->Update(); // prints errors
  vtkPolyData::GetData(outputs)->ShallowCopy(terrain->GetOutput());
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVRelievoTerrainReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
