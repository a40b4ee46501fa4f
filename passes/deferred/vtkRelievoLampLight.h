// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light buffer: what the lamps of a frame add at each pixel, summed on the GPU in one of the
// ways of vtkRelievoLampsStage, and how many were computed for it.
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
  // Takes the lamps, and tells the context which of them cast shadows: so many of the largest, and
  // those that always do. Then makes the buffers: for counts only if they are wanted. Returns what
  // is wrong, in words.
  void Take(
    vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets, int casting);
  std::string Prepare(
    vtkRelievoFrameContext& context, int way, bool floats, bool sums, bool counts);

  // Sums the light and, of surfaces that are more than matte, the gloss; and counts. Returns what
  // is wrong, in words.
  std::string Draw(vtkRelievoFrameContext& context, bool glossy);

  // Adds all of it to the linear colour in one step, where lamps are not drawn as quads and Prepare
  // has been told that no sums are wanted.
  std::string Add(vtkRelievoFrameContext& context, bool glossy);

  // The rectangle in NDC around what lamps but for those that cast reach. Returns how often it is
  // covered by their own rectangles, on average; 0: none is in sight.
  double FindReached(float all[4]) const;

  const vtkRelievoLampList& GetList() const { return this->List; } // but for those that cast
  const vtkRelievoLampList& GetCasting() const { return this->Casting; }
  vtkRelievoScreenTarget& GetSum() { return this->Sum; }
  vtkRelievoScreenTarget& GetGloss() { return this->Gloss; }
  vtkRelievoScreenTarget& GetCounts() { return this->Counts; } // computed, reaching

  // Lamps a pixel in the last frame, on average; -1: they were not counted.
  double GetComputed() const { return this->Computed; }
  double GetReaching() const { return this->Reaching; }

  int GetDrawCalls() const { return this->DrawCalls; }
  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  std::string Upload(vtkRelievoFrameContext& context);
  void Bind(vtkShaderProgram* program, bool casting);
  void Unbind();
  std::string DrawInto(vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target,
    vtkRelievoScreenQuad& quad, const std::string& defines);
  std::string DrawQuads(
    vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target, const std::string& defines);
  std::string DrawPixels(vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target,
    vtkRelievoScreenQuad& quad, const std::string& defines);
  vtkShaderProgram* ReadyPixels(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad,
    const std::vector<std::string>& reads, std::string defines);
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
