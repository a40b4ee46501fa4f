// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFogBuffer.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFogSpheres.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoSphereRays.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// The remainder of the value after rounding to float.
double Lacks(double value)
{
  return value - static_cast<double>(static_cast<float>(value));
}
}

//------------------------------------------------------------------------------
vtkRelievoFogBuffer::vtkRelievoFogBuffer()
  : Target("fogDepth")
{
}

//------------------------------------------------------------------------------
vtkRelievoFogBuffer::~vtkRelievoFogBuffer() = default;

//------------------------------------------------------------------------------
void vtkRelievoFogBuffer::Clear()
{
  this->Texels.clear();
  std::fill_n(this->Part, 4, 0);
}

//------------------------------------------------------------------------------
// Appends the spheres' texels, in the order in which shaders/fog/sphereVS.glsl reads them.
void vtkRelievoFogBuffer::Add(
  const vtkRelievoSphereRays& rays, vtkRelievoFogSpheres* fog, bool chord)
{
  using Fog = vtkRelievoFogSpheres;
  const int width = fog->GetRowWidth();
  const int count = static_cast<int>(fog->GetSharedRows().size()) / width;
  vtkRelievoSphereRays::Sphere sphere;
  for (int i = 0; i < count; ++i)
  {
    const double* row = fog->GetSharedRows().data() + static_cast<std::size_t>(i) * width;
    const double radius = row[Fog::RADIUS];
    if (!rays.Find({ row[0], row[1], row[2] }, radius, sphere))
    {
      continue;
    }
    const double density = row[Fog::DENSITY] * (chord ? 1.0 : radius);
    const glm::dvec3& a = sphere.Linear;
    const glm::dvec3& b = sphere.Square;
    const int* r = sphere.Rectangle;
    const bool first = this->Texels.empty();
    const double texels[32] = { double(r[0]), double(r[1]), double(r[2]), double(r[3]),   //
      a.x, a.y, a.z, sphere.MiddleDepth,                                                  //
      Lacks(a.x), Lacks(a.y), Lacks(a.z), Lacks(sphere.MiddleDepth),                      //
      b.x, b.y, b.z, 1. / radius,                                                         //
      Lacks(b.x), Lacks(b.y), Lacks(b.z), std::min(density, 1e30),                        //
      sphere.Offset.x, sphere.Offset.y, sphere.Pixel.x, sphere.Pixel.y,                   //
      sphere.Offsets[0].x, sphere.Offsets[0].y, sphere.Offsets[1].x, sphere.Offsets[1].y, //
      row[Fog::RED], row[Fog::GREEN], row[Fog::BLUE], 0. };
    this->Texels.insert(this->Texels.end(), texels, texels + 32);
    if (first)
    {
      std::copy_n(r, 4, this->Part);
      this->Part[2] -= r[0];
      this->Part[3] -= r[1];
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      const int begin = std::min(this->Part[axis], r[axis]);
      const int end = std::max(this->Part[axis] + this->Part[axis + 2], r[axis + 2]);
      this->Part[axis] = begin;
      this->Part[axis + 2] = end - begin;
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoFogBuffer::Draw(vtkRelievoFrameContext& context,
  const vtkRelievoSphereRays& rays, const Options& options,
  const std::vector<vtkRelievoResource*>& nearer)
{
  vtkRelievoInstancedQuads& quads = this->Quads[nearer.empty() ? 0 : 1];
  vtkShaderProgram* program = nullptr;
  vtkRelievoScreenTarget::Format format;
  format.Halves = false;
  format.Depth = options.Dominant;
  std::string error = this->Target.Prepare(context, format);
  vtkRelievoResource* depth =
    context.Find(this->BeforeDrawn ? vtkRelievoResources::Drawn : vtkRelievoResources::Depth);
  const bool any = !this->Texels.empty();
  if (error.empty() && any && !depth)
  {
    error = "the frame has no layer 'depth'";
  }
  if (error.empty() && any)
  {
    error = this->Spheres.Upload(context.Window, this->Texels, 4);
  }
  if (error.empty() && any)
  {
    std::string defines = depth->GetDefines();
    for (vtkRelievoResource* each : nearer)
    {
      defines += each->GetDefines();
    }
    program = quads.Ready(context, "fog/sphereVS.glsl", "fog/sphereFS.glsl",
      defines + (this->BeforeDrawn ? "#define RELIEVO_FOG_DRAWN_DEPTH\n" : "") +
        (options.Chord ? "#define RELIEVO_FOG_CHORD\n" : "") +
        (options.Dominant ? "#define RELIEVO_FOG_DOMINANT\n" : ""));
    error = quads.GetError();
  }
  if (!error.empty())
  {
    return error;
  }

  this->Target.Begin(context, 0.0f, options.Everywhere || !any ? nullptr : this->Part);
  if (any)
  {
    vtkOpenGLState* state = context.Window->GetState();
    if (options.Dominant)
    {
      const float none = 0.0f;
      state->vtkglEnable(GL_DEPTH_TEST);
      state->vtkglDepthMask(GL_TRUE);
      state->vtkglDepthFunc(GL_GREATER);
      glClearBufferfv(GL_DEPTH, 0, &none);
    }
    else
    {
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    }
    const glm::vec2 direction(rays.GetDirection(glm::dvec2(0.0)));
    const glm::mat2 directions(rays.GetDirections());
    const float step[4] = { directions[0].x, directions[0].y, directions[1].x, directions[1].y };
    const float first[2] = { direction.x, direction.y };
    program->SetUniform2f("fogDirection", first);
    program->SetUniform4f("fogDirectionStep", step);
    program->SetUniformf("fogBegin", static_cast<float>(rays.GetBegin()));
    const float range[3] = { static_cast<float>(context.View.Near),
      static_cast<float>(context.View.Far), context.View.Parallel ? 1.0f : 0.0f };
    program->SetUniform3f("relievoDrawnRange", range);
    depth->Activate(program);
    for (vtkRelievoResource* each : nearer)
    {
      each->Activate(program);
    }
    this->Spheres.Activate(program, "fogSpheres");
    quads.Draw(this->GetNumberOfSpheres());
    this->Spheres.Deactivate();
    depth->Deactivate();
    for (vtkRelievoResource* each : nearer)
    {
      each->Deactivate();
    }
  }
  this->Target.End();
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoFogBuffer::Release(vtkWindow* window)
{
  for (vtkRelievoInstancedQuads& quads : this->Quads)
  {
    quads.Release(window);
  }
  this->Target.Release(window);
  this->Spheres.Release(window);
}
