// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoStage.h"

#include "vtkRelievoDeclaration.h"
#include "vtkRelievoParameter.h"
#include "vtkSmartPointer.h"

//------------------------------------------------------------------------------
vtkRelievoStage::vtkRelievoStage() = default;

//------------------------------------------------------------------------------
vtkRelievoStage::~vtkRelievoStage() = default;

//------------------------------------------------------------------------------
const vtkRelievoStageDescription& vtkRelievoStage::GetDescription()
{
  if (!this->Description)
  {
    this->Description.reset(new vtkRelievoStageDescription);
    this->Describe(*this->Description);
    if (this->Description->Label.empty())
    {
      this->Description->Label = vtkRelievoCapitalize(this->Description->Name, true);
    }
    // This stage's own values may differ from the defaults.
    const auto fresh = vtkSmartPointer<vtkRelievoStage>::Take(this->NewInstance());
    vtkRelievoStageDescription ofFresh;
    fresh->Describe(ofFresh);
    for (vtkRelievoParameter& parameter : this->Description->Parameters)
    {
      const vtkRelievoParameter* same = ofFresh.Find(parameter.Name);
      parameter.Default = same ? same->Format() : std::string();
    }
  }
  return *this->Description;
}

//------------------------------------------------------------------------------
std::string vtkRelievoStage::GetStageName()
{
  return this->GetDescription().Name;
}

//------------------------------------------------------------------------------
std::string vtkRelievoStage::TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
{
  const vtkRelievoStageDescription& description = this->GetDescription();
  if (const vtkRelievoParameter* parameter = description.Find(name))
  {
    const std::string error = parameter->Parse(words);
    return error.empty() ? error : description.Name + ":" + name + ": " + error;
  }
  const std::string names = description.GetNames();
  return "the stage " + description.Name + " has no parameter '" + name + "', " +
    (names.empty() ? "nor any other" : "only " + names);
}

//------------------------------------------------------------------------------
bool vtkRelievoStage::SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
{
  const std::string error = this->TrySetParameter(name, words);
  if (!error.empty())
  {
    vtkErrorMacro(<< error << ".");
  }
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoStage::Declare(const vtkRelievoFrameContext&, vtkRelievoDeclaration&) const {}

//------------------------------------------------------------------------------
std::vector<vtkRelievoResourceName> vtkRelievoStage::GetReadsFor(
  const vtkRelievoFrameContext&, const std::vector<std::string>&) const
{
  return {};
}

//------------------------------------------------------------------------------
std::map<std::string, int> vtkRelievoStage::FindLights(
  const std::vector<std::string>&, vtkRenderer*) const
{
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoStage::ReadLayers(const std::vector<std::string>& names, vtkImageData*)
{
  return "The layer '" + names.front() + "' cannot be read: it stays on the GPU.";
}

//------------------------------------------------------------------------------
void vtkRelievoStage::Explain(const std::string& code, const std::string& words)
{
  this->ReasonCode = code;
  this->Reason = words;
}

//------------------------------------------------------------------------------
void vtkRelievoStage::Render(const vtkRenderState*)
{
  vtkErrorMacro("A stage is not a pass by itself: add it to a vtkRelievoPass.");
}

//------------------------------------------------------------------------------
void vtkRelievoStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->GetStageName() << "\n";
  os << indent << "Enabled: " << this->Enabled << "\n";
  this->GetDescription().Print(os, indent);
  os << indent << "DrawCalls: " << this->DrawCalls << "\n";
  os << indent << "Reason: " << this->Reason << "\n";
}
