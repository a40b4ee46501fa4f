// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPLYReader.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRelievoMeshText.h"
#include "vtkRelievoPLYMesh.h"
#include "vtkRelievoPLYText.h"

#include <exception>
#include <new>

vtkStandardNewMacro(vtkRelievoPLYReader);

namespace
{
using namespace relievo;
using namespace relievo::ply;

}

//------------------------------------------------------------------------------
vtkRelievoPLYReader::vtkRelievoPLYReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoPLYReader::~vtkRelievoPLYReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkRelievoPLYReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  // Returns 1 even on errors: after 0 the pipeline would add its own error, without a file name.
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("no file name is set: call SetFileName");
    return 1;
  }
  const auto refuse = [&](unsigned long code, const std::string& text) {
    output->Initialize();
    this->SetErrorCode(code);
    vtkErrorMacro("cannot read " << this->FileName << ": " << text);
  };
  try
  {
    ply::Content content = ply::Read(LoadMeshText(this->FileName), [this](double share) {
      this->UpdateProgress(0.8 * share);
      return !this->GetAbortExecute();
    });
    if (!this->GetAbortExecute())
    {
      MakeMesh(content, output);
      this->UpdateProgress(1.);
    }
  }
  catch (const Refusal& refusal)
  {
    refuse(refusal.Code, refusal.Text);
  }
  catch (const std::bad_alloc&)
  {
    refuse(vtkErrorCode::OutOfDiskSpaceError, "memory ran out");
  }
  catch (const std::exception& thrown)
  {
    refuse(vtkErrorCode::OutOfDiskSpaceError, thrown.what());
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoPLYReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
