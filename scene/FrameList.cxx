// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameList.h"

#include "CameraPath.h"
#include "Options.h"
#include "Scene.h"
#include "SequenceOptions.h"
#include "Turntable.h"

#include "vtkMath.h"

namespace scene
{
//------------------------------------------------------------------------------
RenderOptions GetFrameOptions(const RenderOptions& options, int frame)
{
  RenderOptions own = options;
  if (!IsSequence(options))
  {
    return own;
  }
  if (!options.Model.Times.empty())
  {
    own.Model.Time = options.Model.Times[static_cast<std::size_t>(frame)];
    own.Model.Times.clear();
  }
  own.Motion.Turntable = 0; // one frame has a view
  own.Motion.Path.clear();
  for (std::string RenderOptions::*name : { &RenderOptions::PNG, &RenderOptions::EXR,
         &RenderOptions::Baseline, &RenderOptions::Gltf, &RenderOptions::Report })
  {
    own.*name = (own.*name).empty() ? "" : GetFrameName(own.*name, frame);
  }
  return own;
}

//------------------------------------------------------------------------------
int CountFrames(const RenderOptions& options)
{
  const MotionChoice& motion = options.Motion;
  const std::size_t frames = !options.Model.Times.empty() ? options.Model.Times.size()
    : motion.Path.empty() ? static_cast<std::size_t>(motion.Turntable)
                          : CameraPath::Read(motion.Path).GetTimes(motion.FramesPerSecond).size();
  return static_cast<int>(frames);
}

//------------------------------------------------------------------------------
FrameList::FrameList(const Scene& scene, const RenderOptions& options)
{
  const MotionChoice& motion = options.Motion;
  if (!motion.Path.empty())
  {
    const CameraPath path = CameraPath::Read(motion.Path);
    for (const double time :
      options.Model.Times.empty() ? path.GetTimes(motion.FramesPerSecond) : options.Model.Times)
    {
      this->Views.push_back(path.Find(time));
    }
  }
  else if (motion.Turntable > 0)
  {
    CameraPlace first = GetPlace(scene.Renderer->GetActiveCamera());
    if (!options.View.Place && vtkMath::AreBoundsInitialized(scene.Bounds))
    {
      first = FitTurn(scene.Renderer, first, options.UpAxis, scene.Bounds);
    }
    this->Views = MakeTurn(first, motion.Turntable, options.UpAxis);
  }
  this->Count =
    static_cast<int>(this->Views.empty() ? options.Model.Times.size() : this->Views.size());
}

//------------------------------------------------------------------------------
RenderOptions FrameList::Get(const RenderOptions& options, int frame) const
{
  RenderOptions own = GetFrameOptions(options, frame);
  if (!this->Views.empty())
  {
    own.View.Place = this->Views[static_cast<std::size_t>(frame)];
  }
  return own;
}
}
