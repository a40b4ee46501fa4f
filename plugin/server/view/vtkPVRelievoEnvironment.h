// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The environment of one of ParaView's views, on one process: read from a file when something first
// shows it or mirrors it, with levels and irradiance only for what mirrors. Views with the same
// file share what was made of it.
//
// The sky is a prop of the view's renderer. Several processes that draw together have no place for
// it there, for what has no depth is left out when their pictures are put together: it is put
// behind the whole.
#ifndef vtkPVRelievoEnvironment_h
#define vtkPVRelievoEnvironment_h

#include "vtkNew.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentLight.h"
#include "vtkRelievoNullLight.h"
#include "vtkRelievoSkybox.h"

#include <memory>
#include <string>

class vtkObject;
class vtkPVRenderView;

class vtkPVRelievoEnvironment
{
public:
  // Rotation, intensity and so on.
  vtkNew<vtkRelievoEnvironment> Environment;
  // Whether it is shown.
  bool Sky = false;

  void SetFile(const char* file);

  // Before each picture of the view: reads, makes and places what the picture needs. `self` speaks.
  void Prepare(vtkObject* self, vtkPVRenderView* view);

  // After each picture, before processes send it or show it.
  void Finish(vtkPVRenderView* view);

  // Takes the sky out of the view.
  void Leave(vtkPVRenderView* view);

private:
  static std::shared_ptr<vtkRelievoEnvironmentLight> Read(vtkObject* self, const std::string& path);
  bool Ready(vtkObject* self, bool mirrored, bool rough);

  vtkNew<vtkRelievoSkybox> Skybox;
  vtkRelievoNullLight Darkness;
  std::string Path;
  bool HasRead = false;
  std::shared_ptr<vtkRelievoEnvironmentLight> Content;
};

#endif
