// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one stage wrote for others on the GPU: how a shader gets at it. The shader includes a file
// of shaders/ that says what may be read; the resource says with which defines, and binds it.
#ifndef vtkRelievoResource_h
#define vtkRelievoResource_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <string>

class vtkShaderProgram;

class VTKRELIEVOFRAME_EXPORT vtkRelievoResource
{
public:
  virtual ~vtkRelievoResource();

  // The structure, as preprocessor defines.
  virtual std::string GetDefines() const;

  ///@{
  // Sets the program's uniforms and takes texture units; gives them back.
  virtual void Activate(vtkShaderProgram* program) = 0;
  virtual void Deactivate() = 0;
  ///@}
};

#endif
