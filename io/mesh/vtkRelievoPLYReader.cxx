// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPLYReader.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRelievoMeshText.h"
#include "vtkRelievoPLYMesh.h"
#include "vtkRelievoPLYText.h"

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
  const auto refusal = FindRefusal([&]() {
    ply::Content content = ply::Read(LoadMeshText(this->FileName), [this](double share) {
      this->UpdateProgress(0.8 * share);
      return !this->GetAbortExecute();
    });
    if (!this->GetAbortExecute())
    {
      MakeMesh(content, output);
      this->UpdateProgress(1.);
    }
  });
  if (refusal)
  {
    output->Initialize();
    this->SetErrorCode(refusal->Code);
    vtkErrorMacro("cannot read " << this->FileName << ": " << refusal->Text);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoPLYReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
