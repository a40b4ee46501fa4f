// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWrapTexture.h"

#include "vtkObjectFactory.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkRelievoWrapTexture);

namespace
{
int GetObjectWrap(int wrap)
{
  return wrap == vtkTexture::ClampToEdge ? vtkTextureObject::ClampToEdge
    : wrap == vtkTexture::MirroredRepeat ? vtkTextureObject::MirroredRepeat
                                         : vtkTextureObject::Repeat;
}
}

//------------------------------------------------------------------------------
void vtkRelievoWrapTexture::Load(vtkRenderer* renderer)
{
  if (!renderer) // a script may pass None
  {
    return;
  }
  this->Superclass::Load(renderer);
  vtkTextureObject* object = this->TextureObject;
  const int u = GetObjectWrap(this->WrapU);
  const int v = GetObjectWrap(this->WrapV);
  if (object && object->GetHandle() && (object->GetWrapS() != u || object->GetWrapT() != v))
  {
    object->SetWrapS(u);
    object->SetWrapT(v);
    object->SendParameters(); // the texture is bound now
  }
}

//------------------------------------------------------------------------------
void vtkRelievoWrapTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WrapU: " << this->WrapU << "\n";
  os << indent << "WrapV: " << this->WrapV << "\n";
}
