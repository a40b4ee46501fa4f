// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws once over the frame's viewport with a shader that reads layers: the drawing half of a stage
// that works on the picture. The shader includes gbuffer/read.glsl, and is given texCoord (vec2)
// and as uniforms relievoSize (vec2) and relievoOffset (ivec2): the texel of a pixel in the layers
// is ivec2(floor(texCoord * relievoSize)) + relievoOffset.
#ifndef vtkRelievoScreenQuad_h
#define vtkRelievoScreenQuad_h

#include <memory>
#include <string>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRelievoGBufferPass;
class vtkShaderProgram;
class vtkWindow;
struct vtkRelievoView;

class vtkRelievoScreenQuad
{
public:
  vtkRelievoScreenQuad();
  ~vtkRelievoScreenQuad();

  // The program of this source (a name below shaders/), ready to be given its own uniforms;
  // compiled only when the way the layers are packed, or `defines`, changed. nullptr if it does
  // not compile or the G-buffer holds no layer.
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, vtkRelievoGBufferPass* gbuffer,
    const std::string& source, const std::string& defines = "");

  // Draws with the program that Ready gave, without depth test. Blending is as the caller set it.
  void Draw(
    vtkOpenGLRenderWindow* window, vtkRelievoGBufferPass* gbuffer, const vtkRelievoView& view);

  void Release(vtkWindow* window);

private:
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string Key; // what the program was compiled for
};

#endif
