// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The names of a frame's resources, by which stages declare their inputs and outputs. Names have a
// type of their own, and text does not convert to it: a misspelt name does not compile.
#ifndef vtkRelievoResourceName_h
#define vtkRelievoResourceName_h

#include <string>
#include <utility>

class vtkRelievoResourceName
{
public:
  // Names a layer, an array, or a stage's own resource; all other names are the constants below.
  static vtkRelievoResourceName Of(std::string name)
  {
    return vtkRelievoResourceName(std::move(name));
  }

  const std::string& Get() const { return this->Name; }

  bool operator==(const vtkRelievoResourceName& other) const { return this->Name == other.Name; }
  bool operator!=(const vtkRelievoResourceName& other) const { return !(*this == other); }

private:
  explicit vtkRelievoResourceName(std::string name)
    : Name(std::move(name))
  {
  }

  std::string Name;
};

namespace vtkRelievoResources
{
using Name = vtkRelievoResourceName;

// The window's content, and the linear colour from which it is made.
inline const Name Picture = Name::Of("picture");
inline const Name Color = Name::Of("color");

// Beside the linear colour: the delegate's drawing with its depth; its translucent geometry, stored
// separately, with its depth.
inline const Name Drawn = Name::Of("drawn");
inline const Name Translucent = Name::Of("translucent");
inline const Name TranslucentDepth = Name::Of("translucent depth");

// Samples of a frame: the samples drawn at once, if several are needed, and their sum.
inline const Name Samples = Name::Of("samples");
inline const Name Marks = Name::Of("marks");
inline const Name Gathered = Name::Of("gathered");

// Layers of the G-buffer that stages read, and its stored surface data, for lamps and for lights
// that are evaluated after the drawing (vtkRelievoShading).
inline const Name Depth = Name::Of("depth");
inline const Name Normal = Name::Of("normal");
inline const Name GeometricNormal = Name::Of("geometric_normal");
inline const Name Actor = Name::Of("actor");
inline const Name Surface = Name::Of("surface");
inline const Name Shading = Name::Of("shading");

// In the G-buffer: the share of casting lights in a pixel's light. The stage that darkens the rest
// by rays reads it.
inline const Name DirectLight = Name::Of("direct light");

// Outputs of the stage `shadows`: for stages with their own lighting, for layers, and for lamps
// from data (vtkRelievoLampShadows).
inline const Name ShadowMaps = Name::Of("shadow maps");
inline const Name Visibility = Name::Of("visibility");
inline const Name LampShadows = Name::Of("lamp shadows");
}

#endif
