// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The textures of the G-buffer, bound as additional attachments of another pass's framebuffer, or
// in a framebuffer of their own with its own depth.
#ifndef vtkRelievoGBufferTarget_h
#define vtkRelievoGBufferTarget_h

#include "vtkRelievoWordSource.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;
struct vtkRelievoGBufferLayout;

class vtkRelievoGBufferTarget : public vtkRelievoWordSource
{
public:
  vtkRelievoGBufferTarget() = default;
  ~vtkRelievoGBufferTarget() override;
  vtkRelievoGBufferTarget(const vtkRelievoGBufferTarget&) = delete;
  void operator=(const vtkRelievoGBufferTarget&) = delete;

  // Makes the textures for the layout, width x height texels. Returns an error message, or an empty
  // string.
  std::string Allocate(
    vtkOpenGLRenderWindow* window, const vtkRelievoGBufferLayout& layout, int width, int height);

  // Adds the textures to the framebuffer bound for drawing, and clears the region x y w h to the
  // background. Returns an error message, with nothing changed, or an empty string.
  std::string AttachShared(const vtkRelievoGBufferLayout& layout, const int region[4]);
  void DetachShared();

  // Binds a framebuffer with the textures and its own depth buffer.
  std::string BeginOwn(const vtkRelievoGBufferLayout& layout);
  void EndOwn();

  // Between Begin/Attach and End/Detach: whether the following draw calls write the layers.
  void WriteLayers(bool on);

  bool Read(
    int attachment, const int region[4], const std::vector<std::uint32_t*>& planes) override;

  vtkTextureObject* GetTexture(int attachment);
  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
  std::vector<int> Channels;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  int Width = 0;
  int Height = 0;
  std::vector<unsigned int> DrawBuffers; // with the layers; index 0 is location 0
  unsigned int SharedFramebuffer = 0;
  unsigned int SharedColorBuffer = 0;
  bool Writing = false;
};

#endif
