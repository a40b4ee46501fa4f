// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Access to protected members of ParaView's view and representations and of VTK's light kit. The
// members are named through derived classes that are never instantiated, so that the compiler
// checks them.
#ifndef vtkPVRelievoAccess_h
#define vtkPVRelievoAccess_h

#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightKit.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkProcessModule.h"
#include "vtkSelectionRepresentation.h"
#include "vtkSynchronizedRenderers.h"

#include <array>
#include <vector>

namespace vtkPVRelievoAccess
{
class View : public vtkPVRenderView
{
public:
  // Where the view composes its passes.
  static vtkPVSynchronizedRenderer* Passes(vtkPVRenderView* view)
  {
    return view->*(&View::SynchronizedRenderers);
  }
  static vtkLightKit* Kit(vtkPVRenderView* view) { return view->*(&View::LightKit); }
  // Whether a server makes the view's picture, and this process only shows it.
  static bool IsDrawnElsewhere(vtkPVRenderView* view)
  {
    return vtkProcessModule::GetProcessType() == vtkProcessModule::PROCESS_CLIENT &&
      view->GetUseDistributedRenderingForRender();
  }
  // Whether the view is drawing a saved picture.
  static bool IsSaving(vtkPVRenderView* view) { return (view->*(&View::GetInCaptureScreenshot))(); }
};

class Surface : public vtkGeometryRepresentationWithFaces
{
public:
  // The representation's actors: the front, and the back if it can look different.
  static std::vector<vtkActor*> Actors(vtkGeometryRepresentation* representation)
  {
    std::vector<vtkActor*> actors = { representation->GetActor() };
    if (auto* faces = vtkGeometryRepresentationWithFaces::SafeDownCast(representation))
    {
      actors.push_back(faces->*(&Surface::BackfaceActor));
    }
    return actors;
  }
};

class Selection : public vtkSelectionRepresentation
{
public:
  // The representation's views.
  static vtkGeometryRepresentation* Surface(vtkSelectionRepresentation* selection)
  {
    return selection->*(&Selection::GeometryRepresentation);
  }
};

class Synchronizer : public vtkSynchronizedRenderers
{
public:
  // The picture that the view sends or shows.
  static vtkRawImage& Capture(vtkSynchronizedRenderers* synchronizer)
  {
    return (synchronizer->*(&Synchronizer::CaptureRenderedImage))();
  }
};

class LightKit : public vtkLightKit
{
public:
  static vtkLight* Key(vtkLightKit* kit) { return kit->*(&LightKit::KeyLight); }
  // The name for reports.
  static std::array<std::pair<vtkLight*, const char*>, 4> Others(vtkLightKit* kit)
  {
    return { { { kit->*(&LightKit::FillLight), "fill light" },
      { kit->*(&LightKit::BackLight0), "first back light" },
      { kit->*(&LightKit::BackLight1), "second back light" },
      { kit->*(&LightKit::HeadLight), "headlight" } } };
  }
};
}

#endif
