// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The textures of the G-buffer and how they come before the pen: as further attachments of a
// framebuffer that somebody else draws to, or in a framebuffer of their own with its own depth.
#ifndef vtkRelievoGBufferTarget_h
#define vtkRelievoGBufferTarget_h

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

class vtkRelievoGBufferTarget
{
public:
  vtkRelievoGBufferTarget() = default;
  ~vtkRelievoGBufferTarget();
  vtkRelievoGBufferTarget(const vtkRelievoGBufferTarget&) = delete;
  void operator=(const vtkRelievoGBufferTarget&) = delete;

  // Textures for the layout, width x height texels. Returns what is wrong, in words.
  std::string Allocate(
    vtkOpenGLRenderWindow* window, const vtkRelievoGBufferLayout& layout, int width, int height);

  // Adds the textures to the framebuffer bound for drawing; the region x y w h is cleared to the
  // background. Returns why it cannot be, in words; nothing has changed then.
  std::string AttachShared(const vtkRelievoGBufferLayout& layout, const int region[4]);
  void DetachShared();

  // Draws into the textures and a depth buffer of their own.
  std::string BeginOwn(const vtkRelievoGBufferLayout& layout);
  void EndOwn();

  // Between Begin/Attach and End/Detach: whether the draw calls that follow write the layers.
  void WriteLayers(bool on);

  // The attachment's words, each of them for all pixels of the region, row 0 at the bottom, into
  // its own of the planes.
  bool Read(int attachment, const int region[4], const std::vector<std::uint32_t*>& planes);

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
  std::vector<unsigned int> DrawBuffers; // with the layers; location 0 first
  unsigned int SharedFramebuffer = 0;
  unsigned int SharedColorBuffer = 0;
  bool Writing = false;
};

#endif
