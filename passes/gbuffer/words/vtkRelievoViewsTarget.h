// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The textures of the G-buffer for many views of one size, a layer of texture arrays for each. All
// views begin at pixel 0, 0, because an offset changes how the rasteriser rounds; they are drawn
// without waiting in between, and read back at once.
#ifndef vtkRelievoViewsTarget_h
#define vtkRelievoViewsTarget_h

#include "vtkRelievoWordSource.h"

class vtkOpenGLRenderWindow;
struct vtkRelievoGBufferLayout;

class vtkRelievoViewsTarget : public vtkRelievoWordSource
{
public:
  // For up to `views` views in a window whose context is current.
  vtkRelievoViewsTarget(vtkOpenGLRenderWindow* window, const vtkRelievoGBufferLayout& layout,
    int width, int height, int views);
  ~vtkRelievoViewsTarget() override;
  vtkRelievoViewsTarget(const vtkRelievoViewsTarget&) = delete;
  void operator=(const vtkRelievoViewsTarget&) = delete;

  // The views that fit; 0: none.
  int GetNumberOfViews() const { return this->Views; }

  // Binds the framebuffer, with the state of a pass of its own. False: this OpenGL cannot.
  bool Begin();
  // The next draws are this view's, which begins with the background.
  void Draw(int view);
  // Releases the framebuffer, and reads all views.
  void End();

  // Whose words are read next.
  void Select(int view) { this->Selected = view; }
  bool Read(
    int attachment, const int region[4], const std::vector<std::uint32_t*>& planes) override;

private:
  vtkOpenGLRenderWindow* Window;
  const vtkRelievoGBufferLayout& Layout;
  int Width;
  int Height;
  int Views;
  int Selected = 0;
  unsigned int Framebuffer = 0;
  unsigned int Depth = 0;
  std::vector<unsigned int> Textures;
  std::vector<std::vector<std::uint32_t>> Words; // by attachment
};

#endif
