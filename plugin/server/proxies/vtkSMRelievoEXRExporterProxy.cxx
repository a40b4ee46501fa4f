// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoEXRExporterProxy.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkSMRelievoCaptureProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkSMRelievoEXRExporterProxy);

//------------------------------------------------------------------------------
void vtkSMRelievoEXRExporterProxy::Write()
{
  this->CreateVTKObjects();
  auto* writer = vtkRelievoEXRWriter::SafeDownCast(this->GetClientSideObject());
  auto capture = vtk::TakeSmartPointer(vtkSMRelievoCaptureProxy::SafeDownCast(
    this->GetSessionProxyManager()->NewProxy("relievo", "Capture")));
  if (!this->View || !writer || !capture)
  {
    vtkErrorMacro("Nothing is exported: " << (this->View ? "the plugin is not loaded on the client "
                                                           "and the server"
                                                         : "there is no view; use SetView")
                                          << ".");
    return;
  }
  const std::vector<std::string> layers =
    vtkSMRelievoCaptureProxy::GetSelected(this->GetProperty("Layers"));
  if (layers.empty())
  {
    vtkErrorMacro("Nothing is exported: no layer is chosen; choose some in Layers.");
    return;
  }
  if (!capture->Capture(this->View, layers, vtkSMRelievoCaptureProxy::TO_CLIENT, false))
  {
    return;
  }
  vtkImageData* image = capture->GetImage();
  // Without points, an error has been reported. With several processes only the root has points.
  if (image && image->GetNumberOfPoints() > 0)
  {
    writer->SetInputData(image);
    writer->Write();
    writer->SetInputData(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoEXRExporterProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
