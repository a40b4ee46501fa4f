// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The environment of one of ParaView's views, on one process: read from its file at the first use
// as skybox or reflection, with levels and irradiance only for mirroring materials. Views of one
// file share the results.
//
// The skybox is a prop of the view's renderer. With several drawing processes that is impossible,
// because compositing drops pixels without depth: the skybox is then drawn behind the composited
// picture.
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
  // Whether the skybox is visible.
  bool Sky = false;

  void SetFile(const char* file);

  // Before each picture of the view: reads, computes and places the necessary parts. `self` reports
  // errors.
  void Prepare(vtkObject* self, vtkPVRenderView* view);

  // After each picture, before processes send it or show it.
  void Finish(vtkPVRenderView* view);

  // Removes the skybox from the view.
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
