// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A list of floats for shaders, of any length, as a buffer texture (OpenGL 3.2). Whole numbers up
// to 2^24 are exact in it.
#ifndef vtkRelievoTextureBuffer_h
#define vtkRelievoTextureBuffer_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
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
  // Makes room for texels, and writes some of them.
  std::string Allocate(vtkOpenGLRenderWindow* window, std::size_t texels, int channels);
  void Write(std::size_t firstFloat, const float* values, std::size_t count);
  ///@}

  // Whether there is a list in this window.
  bool IsIn(vtkOpenGLRenderWindow* window) const;

  ///@{
  // Takes a texture unit and sets the program's samplerBuffer of that name; gives it back.
  void Activate(vtkShaderProgram* program, const char* sampler);
  void Activate(); // the unit alone
  void SetUniform(vtkShaderProgram* program, const char* sampler);
  void Deactivate();
  ///@}

  int GetTextureUnit() const { return this->Unit; } // -1 while it has none

  vtkIdType GetBytes() const { return this->Bytes; }

  // Deletes what is held in this window, whichever is being drawn.
  void Release(vtkWindow* window);

  // Of a list, in the current context.
  static std::size_t GetMostTexels();

  // Refuses longer lists than OpenGL would; 0: as OpenGL. For tests.
  static void SetMostTexels(int texels);

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkWindow* Owner = nullptr; // the same, also in its destructor; only compared
  unsigned int Buffer = 0;
  unsigned int Texture = 0;
  int Unit = -1;
  vtkIdType Bytes = 0;
};

#endif
