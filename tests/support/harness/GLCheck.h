// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLCheck.h
 * @brief Watches one OpenGL context: errors and severe messages of the driver fail the test.
 */
#ifndef relievoTestGLCheck_h
#define relievoTestGLCheck_h

#include <vtkWeakPointer.h>

#include <memory>
#include <string>

class vtkOpenGLRenderWindow;
class vtkRenderWindow;

namespace relievoTest
{
/**
 * Switches on the debug output (KHR_debug, synchronous) of a window's context and fails the test
 * on every message of type error or of high severity, so also on errors that somebody clears by
 * calling glGetError(). One per context; VTK's windows have one context each.
 *
 *     auto window = MakeWindow(300, 300, renderer);
 *     GLCheck gl(window);
 *     window->Render();
 */
class GLCheck
{
public:
  /** Initialises the window and makes it current. Fails the test if it cannot be watched. */
  explicit GLCheck(vtkRenderWindow* window);

  /** Polls once more and stops watching; harmless if the window has been deleted. */
  ~GLCheck();

  /** Fails the test if glGetError() reports anything; `where` goes into the message. */
  void Poll(const std::string& where);

  /** Number of errors and severe messages so far. */
  int Errors() const;

  GLCheck(const GLCheck&) = delete;
  void operator=(const GLCheck&) = delete;

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  // On the heap, because the driver stores its address.
  std::unique_ptr<int> Count;
};

/** The objects in a window's context, counted by OpenGL queries. */
struct GLObjects
{
  int Textures = 0;
  int Buffers = 0;
  int Renderbuffers = 0;
  int Framebuffers = 0;
  int Programs = 0;
  int Shaders = 0;
  int Queries = 0;
  int VertexArrays = 0;
  /** Bytes of texels and buffers: width x height x depth x bits x samples of all levels. */
  long long Bytes = 0;

  /** Number of objects of all kinds. */
  int Total() const;
  /** One line for the log. */
  std::string ToString() const;
};

/**
 * Counts the objects of a window's context by testing every name up to 65535; makes the window
 * current. Needs OpenGL 4.5; fails the test without it.
 */
GLObjects CountGLObjects(vtkRenderWindow* window);
}

#endif
