// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light buffer: the light of a frame's lamps at each pixel, summed on the GPU in one of the
// ways of vtkRelievoLampsStage; and the number of lamps computed for it.
#ifndef vtkRelievoLampLight_h
#define vtkRelievoLampLight_h

#include "vtkRelievoLampClusters.h"
#include "vtkRelievoLampList.h"
#include "vtkRelievoLampQuads.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoTextureBuffer.h"

#include <string>
#include <vector>

class vtkRelievoLampLight
{
public:
  // The buffers that sum the light: floats instead of halves, no sums if Add() adds the light to
  // the colour, and counts of lamps only if they are requested.
  struct Buffers
  {
    bool Floats = false;
    bool Sums = false;
    bool Counts = false;
  };

  // Take() selects the lamps, and tells the context which ones cast shadows: the `casting` largest,
  // and those that always cast. Prepare() makes the buffers, and returns an error message, or an
  // empty string.
  void Take(
    vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets, int casting);
  std::string Prepare(vtkRelievoFrameContext& context, int way, const Buffers& buffers);

  // Gives the lamps to OpenGL, before the following. Returns an error message, or an empty string,
  // and so do these.
  std::string Upload(vtkRelievoFrameContext& context);

  // Sums the light, the gloss of glossy surfaces, and the counts; only if Prepare() was called with
  // sums.
  std::string Draw(vtkRelievoFrameContext& context, bool glossy);

  // Adds the light to the linear colour in one step, without sums; only if lamps are not drawn as
  // quads.
  std::string Add(vtkRelievoFrameContext& context, bool glossy);

  // Receives the rectangle in NDC around all lamps without shadows. Returns how often their own
  // rectangles cover it on average; 0 if none is in sight.
  double FindReached(float all[4]) const;

  const vtkRelievoLampList& GetList() const { return this->List; } // without those that cast
  const vtkRelievoLampList& GetCasting() const { return this->Casting; }
  vtkRelievoScreenTarget& GetSum() { return this->Sum; }
  vtkRelievoScreenTarget& GetGloss() { return this->Gloss; }
  vtkRelievoScreenTarget& GetCounts() { return this->Counts; } // computed, reaching

  // Average number of lamps per pixel in the last frame; -1 if they were not counted.
  double GetComputed() const { return this->Computed; }
  double GetReaching() const { return this->Reaching; }

  int GetDrawCalls() const { return this->DrawCalls; }
  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  void Bind(vtkShaderProgram* program, bool casting);
  void Unbind();
  std::string DrawInto(vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target,
    vtkRelievoScreenQuad& quad, const std::string& defines);
  std::string DrawQuads(
    vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target, const std::string& defines);
  std::string DrawPixels(vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target,
    vtkRelievoScreenQuad& quad, const std::string& defines);
  vtkShaderProgram* ReadyPixels(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad,
    const std::vector<vtkRelievoResourceName>& reads, std::string defines);
  bool HasQuads() const;
  void SumCounts();

  int Way = 0;
  bool Counting = false;
  bool Floats = false;
  int DrawCalls = 0;
  double Computed = -1.0;
  double Reaching = -1.0;
  vtkRelievoLampList List;
  vtkRelievoLampList Casting;
  vtkRelievoLampClusters Clusters;
  vtkRelievoLampQuads Quads;
  vtkRelievoLampQuads CastingQuads;
  vtkRelievoScreenTarget Sum{ "relievoLight" };
  vtkRelievoScreenTarget Gloss{ "relievoGlossSum" };
  vtkRelievoScreenTarget Counts{ "relievoLampCounts" };
  vtkRelievoScreenQuad Adder;
  vtkRelievoScreenQuad Lights;
  vtkRelievoScreenQuad Glosses;
  vtkRelievoScreenQuad Counter;
  vtkRelievoTextureBuffer Lamps;
  vtkRelievoTextureBuffer CastingLamps;
  vtkRelievoTextureBuffer Attenuations;
  vtkRelievoTextureBuffer Cells;
  vtkRelievoTextureBuffer Lists;
};

#endif
