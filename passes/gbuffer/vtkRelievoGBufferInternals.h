// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the parts of vtkRelievoGBufferPass share: its methods are in several files.
#ifndef vtkRelievoGBufferInternals_h
#define vtkRelievoGBufferInternals_h

#include "vtkRelievoDrawTable.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoGBufferSplice.h"
#include "vtkRelievoGBufferTarget.h"
#include "vtkRelievoGBufferTextures.h"
#include "vtkRelievoGlyphDraws.h"
#include "vtkRelievoMeshLinks.h"
#include "vtkRelievoOpaqueProps.h"
#include "vtkRelievoPrimitiveIds.h"
#include "vtkRelievoView.h"
#include "vtkRenderer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <set>
#include <string>
#include <vector>

class vtkRelievoGBufferPass::Internals
{
public:
  vtkRelievoGBufferLayout Layout;
  vtkRelievoGBufferSplice::Mode Mode;
  vtkTimeStamp StructureTime; // of the layout and the mode: shaders older than it are built anew
  vtkRelievoGBufferTarget Target;
  vtkRelievoGBufferTextures Textures;
  vtkRelievoView View;
  int Offset[2] = { 0, 0 }; // of the viewport within the textures
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkRelievoDrawTable Draws;
  vtkRelievoGlyphReach Glyphs;
  vtkRelievoMeshLinks Links; // built when a read needs them
  vtkRelievoOpaqueProps Props;
  std::set<std::string> Said; // refusals that have been reported, by reason and mapper's class
  std::string NotShared;      // why the delegate's geometry pass cannot be shared
  vtkRelievoPrimitiveIds::Route PrimitiveIds = vtkRelievoPrimitiveIds::AsWritten;
  bool Writing = false;
  bool RefinesDepth = true;              // of the last frame
  bool ShadingAsked = false;             // surfaces are to be lit by a later stage
  bool Shading = false;                  // and can be
  std::map<vtkMapper*, int> LineShaders; // vtkRelievoSurfaces::LineShaders, where VTK has several
  bool Alternating = false; // an actor's shaders are wrong for another that shares its mapper
  std::map<vtkMapper*, std::string> Lit;            // then: why VTK has to light what they draw
  std::map<vtkShaderProgram*, std::string> LeftOut; // the same of this frame's programs
  bool Stray = false;   // something is drawn that writes no layers, and cannot be told apart
  bool Strayed = false; // shaders without layers were built with this pass in their keys
  bool Valid = false;   // the textures hold the last frame's layers

  // The layout for what is asked of the stage.
  void Arrange(vtkRelievoGBufferPass& self, const vtkRelievoFrameContext& context);

  void CountLeft(vtkShaderProgram* program, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
  std::string WhyLit(vtkActor* actor) const;

  void SetMode(const vtkRelievoGBufferSplice::Mode& mode)
  {
    if (this->Mode != mode)
    {
      this->Mode = mode;
      this->StructureTime.Modified();
    }
  }
};

#endif
