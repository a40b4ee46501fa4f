// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The framebuffer that layers of volumes are drawn to, of the viewport's size: for each volume
// three textures of four floats a pixel (shaders/volumes/layers.glsl), and the depth of the
// surfaces, in the format from which VTK's mapper copies it.
#ifndef vtkRelievoVolumeTarget_h
#define vtkRelievoVolumeTarget_h

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRelievoFrameContext;
class vtkRelievoScopedState;
class vtkWindow;

class vtkRelievoVolumeTarget
{
public:
  static constexpr int Textures = 3;

  vtkRelievoVolumeTarget();
  ~vtkRelievoVolumeTarget();
  vtkRelievoVolumeTarget(const vtkRelievoVolumeTarget&) = delete;
  void operator=(const vtkRelievoVolumeTarget&) = delete;

  // Makes room for this number of volumes. Returns an error message, or an empty string.
  std::string Prepare(vtkRelievoFrameContext& context, int volumes);

  ///@{
  // Binds the framebuffer with its whole area as viewport; End() restores OpenGL's state. Select()
  // then attaches the volume's textures, cleared to zero.
  void Begin(vtkRelievoFrameContext& context);
  void Select(int volume);
  void End();
  ///@}

  // The texels of a volume, four floats a pixel in rows from the bottom.
  std::array<std::vector<float>, Textures> Read(int volume);

  // The texture of a volume's places: steps, value, depth, whether there is one.
  vtkTextureObject* GetPlaces(int volume) { return this->Volumes[volume][1]; }

  const int* GetArea() const { return this->Area; } // for vtkRelievoScreenQuad::Draw
  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  void Attach(int volume);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::vector<std::array<vtkSmartPointer<vtkTextureObject>, Textures>> Volumes;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkRelievoScopedState> SavedState;
  int Area[4] = { 0, 0, 0, 0 };
};

#endif
