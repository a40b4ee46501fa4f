// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A list of floats for shaders, of any length, in a buffer texture (OpenGL 3.2). Integers up to
// 2^24 are exact.
#ifndef vtkRelievoTextureBuffer_h
#define vtkRelievoTextureBuffer_h

#include "vtkRelievoBaseGLModule.h" // for the export macro
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class VTKRELIEVOBASEGL_EXPORT vtkRelievoTextureBuffer
{
public:
  vtkRelievoTextureBuffer();
  ~vtkRelievoTextureBuffer();
  vtkRelievoTextureBuffer(const vtkRelievoTextureBuffer&) = delete;
  void operator=(const vtkRelievoTextureBuffer&) = delete;

  // Makes texels of 1, 2 or 4 floats. Returns an error message, or an empty string.
  std::string Upload(vtkOpenGLRenderWindow* window, const std::vector<float>& values, int channels);

  ///@{
  // Allocates texels, and writes some of them.
  std::string Allocate(vtkOpenGLRenderWindow* window, std::size_t texels, int channels);
  void Write(std::size_t firstFloat, const float* values, std::size_t count);
  ///@}

  // Whether the window has a list.
  bool IsIn(vtkOpenGLRenderWindow* window) const;

  ///@{
  // Takes a texture unit and sets the program's samplerBuffer of that name; Deactivate() releases
  // it.
  void Activate(vtkShaderProgram* program, const char* sampler);
  void Activate(); // takes the unit only
  void SetUniform(vtkShaderProgram* program, const char* sampler);
  void Deactivate();
  ///@}

  int GetTextureUnit() const { return this->Unit; } // -1 without a unit

  vtkIdType GetBytes() const { return this->Bytes; }

  // Deletes the window's texture, in its own context.
  void Release(vtkWindow* window);

  // Maximum length of a list in the current context.
  static std::size_t GetMostTexels();

  // Limits lists to fewer texels than OpenGL does; 0: OpenGL's limit. For tests.
  static void SetMostTexels(int texels);

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkWindow* Owner = nullptr; // equals Window, also in its destructor; only compared
  unsigned int Buffer = 0;
  unsigned int Texture = 0;
  int Unit = -1;
  vtkIdType Bytes = 0;
};

#endif
