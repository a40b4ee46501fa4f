// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A float texture with one texel per viewport pixel. A stage draws it, others read it in their
// shaders, and it can be read back as a layer.
#ifndef vtkRelievoScreenTarget_h
#define vtkRelievoScreenTarget_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoResource.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>

class vtkImageData;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRelievoFrameContext;
class vtkRelievoScopedState;
class vtkTextureObject;
class vtkWindow;

class VTKRELIEVOFRAME_EXPORT vtkRelievoScreenTarget : public vtkRelievoResource
{
public:
  struct Format
  {
    int Channels = 4; // 1, 2 or 4
    bool Halves = true;
    bool Depth = false; // with a depth buffer of 32-bit floats
  };

  // `sampler` is the name of the sampler2D in shaders that read the texture.
  explicit vtkRelievoScreenTarget(const std::string& sampler);
  ~vtkRelievoScreenTarget() override;
  vtkRelievoScreenTarget(const vtkRelievoScreenTarget&) = delete;
  void operator=(const vtkRelievoScreenTarget&) = delete;

  // Makes the texture in the size of the context's viewport. Returns an error message, or an empty
  // string.
  std::string Prepare(vtkRelievoFrameContext& context, const Format& format);

  ///@{
  // Binds the texture for drawing, cleared to the value in every channel; End() restores the
  // binding and OpenGL's state. Viewport and scissor cover the whole texture; blending and depth
  // test are off. GoOn() does not clear. With a part (x, y, width, height in pixels) only the part
  // is cleared.
  void Begin(vtkRelievoFrameContext& context, float value = 0.0f, const int* part = nullptr);
  void GoOn(vtkRelievoFrameContext& context);
  void End();
  ///@}

  // Preprocessor defines for shaders that read the texture.
  void SetDefines(const std::string& defines) { this->Defines = defines; }
  std::string GetDefines() const override { return this->Defines; }

  // The size in pixels; also the area for vtkRelievoScreenQuad::Draw.
  const int* GetArea() const { return this->Area; }
  const Format& GetFormat() const { return this->Shape; }

  // Adds the last frame's values to the image as the float point array `name`. One channel fills
  // all components; otherwise components are the channels in order. Returns an error message, or an
  // empty string.
  std::string Read(
    const std::string& name, int components, vtkImageData* image, int firstChannel = 0);

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  std::string Sampler;
  std::string Defines;
  Format Shape;
  int Area[4] = { 0, 0, 0, 0 };
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkRelievoScopedState> SavedState;
};

#endif
