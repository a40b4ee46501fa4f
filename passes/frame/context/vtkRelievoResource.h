// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stage's output for others on the GPU, and its binding to shaders. A shader includes the file of
// shaders/ that declares its functions; the resource supplies the defines, and binds textures.
#ifndef vtkRelievoResource_h
#define vtkRelievoResource_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <string>

class vtkShaderProgram;

class VTKRELIEVOFRAME_EXPORT vtkRelievoResource
{
public:
  virtual ~vtkRelievoResource();

  // The resource's structure, as preprocessor defines.
  virtual std::string GetDefines() const;

  ///@{
  // Sets the program's uniforms and takes texture units; Deactivate() releases them.
  virtual void Activate(vtkShaderProgram* program) = 0;
  virtual void Deactivate() = 0;
  ///@}
};

#endif
