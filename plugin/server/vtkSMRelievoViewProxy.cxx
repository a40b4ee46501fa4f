// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoViewProxy.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"

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
void vtkSMRelievoViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KnowsView: " << this->KnowsView << "\n";
}
