// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoSurfaceProxy.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"
#include "vtkSMRelievoAccess.h"

vtkStandardNewMacro(vtkSMRelievoSurfaceProxy);

//------------------------------------------------------------------------------
void vtkSMRelievoSurfaceProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  vtkSMProxy* parent = this->GetParentProxy();
  vtkSMProxy* surface =
    parent ? vtkSMRelievoAccess::Proxy::Find(parent, "SurfaceRepresentation") : nullptr;
  if (!this->KnowsRepresentation && this->ObjectsCreated && surface && surface->GetObjectsCreated())
  {
    this->KnowsRepresentation = true;
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetRepresentation"
           << VTKOBJECT(surface) << vtkClientServerStream::End;
    this->ExecuteStream(stream);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoSurfaceProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KnowsRepresentation: " << this->KnowsRepresentation << "\n";
}
