// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOBJReader.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRelievoMeshText.h"
#include "vtkRelievoOBJMesh.h"
#include "vtkRelievoOBJText.h"

vtkStandardNewMacro(vtkRelievoOBJReader);

namespace
{
using namespace relievo;
using namespace relievo::obj;

std::string Count(vtkIdType count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string FirstOf(const Tally& tally)
{
  return (tally.Count == 1 ? " (line " : " (the first on line ") + std::to_string(tally.Line) + ")";
}
}

//------------------------------------------------------------------------------
vtkRelievoOBJReader::vtkRelievoOBJReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoOBJReader::~vtkRelievoOBJReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
const char* vtkRelievoOBJReader::GetNote(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfNotes();
  return there ? this->Notes[static_cast<std::size_t>(index)].c_str() : nullptr;
}

//------------------------------------------------------------------------------
int vtkRelievoOBJReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Notes.clear();
  // Returns 1 even on errors: after 0 the pipeline would add its own error, without a file name.
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("no file name is set: call SetFileName");
    return 1;
  }
  const auto refusal = FindRefusal([&]() { this->Parse(output); });
  if (refusal)
  {
    output->Initialize();
    this->Notes.clear();
    this->SetErrorCode(refusal->Code);
    vtkErrorMacro("cannot read " << this->FileName << ": " << refusal->Text);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoOBJReader::Parse(vtkPolyData* output)
{
  Content content = Read(LoadMeshText(this->FileName), [this](double share) {
    this->UpdateProgress(0.8 * share);
    return !this->GetAbortExecute();
  });
  if (this->GetAbortExecute())
  {
    return;
  }
  const vtkIdType cells = MakeMesh(content,
    this->OutputPointsPrecision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE,
    this->Groups, output);
  if (content.InvalidPoints.Count > 0)
  {
    this->Notes.push_back("left out " + Count(content.InvalidPoints.Count, "point") +
      " with a coordinate that is no finite number" + FirstOf(content.InvalidPoints) + " and the " +
      Count(cells, "cell") + " of such points");
  }
  for (const auto& [invalid, noun] : { std::pair(content.InvalidNormals, "invalid normal"),
         std::pair(content.InvalidTextureCoordinates, "invalid texture coordinate") })
  {
    if (invalid.Count > 0)
    {
      this->Notes.push_back("read without " + Count(invalid.Count, noun) + FirstOf(invalid));
    }
  }
  if (content.Curves.Count > 0)
  {
    this->Notes.push_back("left out " + Count(content.Curves.Count, "free-form curve or surface") +
      FirstOf(content.Curves));
  }
  this->UpdateProgress(1.);
}

//------------------------------------------------------------------------------
void vtkRelievoOBJReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Groups: " << (this->Groups ? "on" : "off") << "\n";
}
