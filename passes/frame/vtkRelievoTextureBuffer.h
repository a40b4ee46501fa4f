// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A list of floats for shaders, of any length, as a buffer texture (OpenGL 3.2). Whole numbers up
// to 2^24 are exact in it.
#ifndef vtkRelievoTextureBuffer_h
#define vtkRelievoTextureBuffer_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class VTKRELIEVOFRAME_EXPORT vtkRelievoTextureBuffer
{
public:
  vtkRelievoTextureBuffer();
  ~vtkRelievoTextureBuffer();
  vtkRelievoTextureBuffer(const vtkRelievoTextureBuffer&) = delete;
  void operator=(const vtkRelievoTextureBuffer&) = delete;

  // Makes texels of 1, 2 or 4 floats. Returns why it cannot, in words.
  std::string Upload(vtkOpenGLRenderWindow* window, const std::vector<float>& values, int channels);

  ///@{
  // Takes a texture unit and sets the program's samplerBuffer of that name; gives it back.
  void Activate(vtkShaderProgram* program, const char* sampler);
  void Deactivate();
  ///@}

  vtkIdType GetBytes() const { return this->Bytes; }
  void Release(vtkWindow* window);

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLBufferObject> Buffer;
  vtkSmartPointer<vtkTextureObject> Texture;
  std::size_t Texels = 0;
  int Channels = 0;
  vtkIdType Bytes = 0;
};

#endif
