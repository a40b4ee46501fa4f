// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGpuTimer.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoSoftwareOpenGL.h"

namespace
{
// Time in milliseconds after the completion of all commands so far.
double Finish()
{
  glFinish();
  GLint64 now = 0;
  glGetInteger64v(GL_TIMESTAMP, &now);
  return 1e-6 * static_cast<double>(now);
}
}

//------------------------------------------------------------------------------
vtkRelievoGpuTimer::~vtkRelievoGpuTimer()
{
  this->Release();
}

//------------------------------------------------------------------------------
void vtkRelievoGpuTimer::BeginFrame(vtkOpenGLRenderWindow* window)
{
  if (window != this->Window)
  {
    this->Release();
    this->Window = window;
    this->Defers = vtkRelievoIsSoftwareOpenGL();
  }
  this->Current = nullptr;
  this->Finishes = this->Defers && this->Wanted > 0;
  this->Wanted -= this->Wanted > 0 ? 1 : 0;
  if (this->Defers)
  {
    this->Finished.clear();
    return;
  }
  for (Frame& frame : this->Ring)
  {
    if (frame.Pending)
    {
      this->Collect(frame);
    }
    if (!frame.Pending && !this->Current)
    {
      this->Current = &frame;
    }
  }
  if (this->Current)
  {
    this->Current->Number = ++this->Number;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoGpuTimer::EndFrame()
{
  if (this->Finishes)
  {
    this->Milliseconds = this->Finished;
    this->Finishes = false;
  }
  if (this->Current)
  {
    this->Current->Pending = !this->Current->Spans.empty();
    this->Current = nullptr;
  }
}

//------------------------------------------------------------------------------
unsigned int vtkRelievoGpuTimer::TakeQuery()
{
  if (this->FreeQueries.empty())
  {
    GLuint query = 0;
    glGenQueries(1, &query);
    return query;
  }
  const unsigned int query = this->FreeQueries.back();
  this->FreeQueries.pop_back();
  return query;
}

//------------------------------------------------------------------------------
void vtkRelievoGpuTimer::Begin(const std::string& name)
{
  if (this->Finishes)
  {
    this->Finished[name] -= Finish();
  }
  if (this->Current)
  {
    Span span{ name, { this->TakeQuery(), this->TakeQuery() }, false };
    glQueryCounter(span.Queries[0], GL_TIMESTAMP);
    this->Current->Spans.push_back(span);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoGpuTimer::End(const std::string& name)
{
  if (this->Finishes)
  {
    this->Finished[name] += Finish();
  }
  if (!this->Current)
  {
    return;
  }
  for (auto span = this->Current->Spans.rbegin(); span != this->Current->Spans.rend(); ++span)
  {
    if (span->Name == name && !span->Ended)
    {
      glQueryCounter(span->Queries[1], GL_TIMESTAMP);
      span->Ended = true;
      return;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoGpuTimer::Collect(Frame& frame)
{
  for (const Span& span : frame.Spans)
  {
    GLint available = GL_TRUE;
    if (span.Ended)
    {
      glGetQueryObjectiv(span.Queries[1], GL_QUERY_RESULT_AVAILABLE, &available);
    }
    if (!available)
    {
      return false;
    }
  }
  std::map<std::string, double> sums;
  for (const Span& span : frame.Spans)
  {
    if (span.Ended)
    {
      GLuint64 times[2] = { 0, 0 };
      glGetQueryObjectui64v(span.Queries[0], GL_QUERY_RESULT, &times[0]);
      glGetQueryObjectui64v(span.Queries[1], GL_QUERY_RESULT, &times[1]);
      sums[span.Name] += 1e-6 * static_cast<double>(times[1] - times[0]);
    }
    this->FreeQueries.push_back(span.Queries[0]);
    this->FreeQueries.push_back(span.Queries[1]);
  }
  // Frames may arrive out of order.
  if (frame.Number > this->Arrived)
  {
    this->Arrived = frame.Number;
    this->Milliseconds = sums;
  }
  frame.Spans.clear();
  frame.Pending = false;
  return true;
}

//------------------------------------------------------------------------------
double vtkRelievoGpuTimer::GetMilliseconds(const std::string& name) const
{
  auto found = this->Milliseconds.find(name);
  return found == this->Milliseconds.end() ? -1.0 : found->second;
}

//------------------------------------------------------------------------------
void vtkRelievoGpuTimer::Release()
{
  for (Frame& frame : this->Ring)
  {
    for (const Span& span : frame.Spans)
    {
      this->FreeQueries.push_back(span.Queries[0]);
      this->FreeQueries.push_back(span.Queries[1]);
    }
    frame = Frame();
  }
  // A deleted context has deleted its queries.
  if (this->Window && !this->FreeQueries.empty())
  {
    // Another window may be drawing now; its context is restored afterwards.
    const vtkRelievoScopedContext context(this->Window);
    glDeleteQueries(static_cast<GLsizei>(this->FreeQueries.size()), this->FreeQueries.data());
  }
  this->FreeQueries.clear();
  this->Milliseconds.clear();
  this->Finished.clear();
  this->Finishes = false;
  this->Current = nullptr;
  this->Window = nullptr;
}
