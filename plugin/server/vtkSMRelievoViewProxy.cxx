// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoViewProxy.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkSMSession.h"
#include "vtkSMStringVectorProperty.h"

vtkStandardNewMacro(vtkSMRelievoViewProxy);

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  vtkSMProxy* view = this->GetParentProxy();
  if (!this->KnowsView && this->ObjectsCreated && view && view->GetObjectsCreated())
  {
    this->KnowsView = true;
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetView" << VTKOBJECT(view)
           << vtkClientServerStream::End;
    this->ExecuteStream(stream);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  this->Superclass::UpdatePropertyInformationInternal(property);
  auto* report = vtkSMStringVectorProperty::SafeDownCast(this->GetProperty("FrameReport"));
  vtkSMProxy* parent = this->GetParentProxy();
  auto* view = parent ? vtkPVRenderView::SafeDownCast(parent->GetClientSideObject()) : nullptr;
  vtkSMSession* session = this->GetSession();
  if ((property && property != report) || !report || !this->ObjectsCreated || !session || !view ||
    (session->GetProcessRoles() & vtkPVSession::RENDER_SERVER) != 0 ||
    !view->GetUseDistributedRenderingForRender())
  {
    return;
  }
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "GetFrameReport"
         << vtkClientServerStream::End;
  this->ExecuteStream(stream, false, vtkPVSession::RENDER_SERVER_ROOT);
  const char* text = nullptr;
  if (this->GetLastResult(vtkPVSession::RENDER_SERVER_ROOT).GetArgument(0, 0, &text) && text)
  {
    report->SetElement(0, text);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KnowsView: " << this->KnowsView << "\n";
}
