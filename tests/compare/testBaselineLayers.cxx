// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Capturing a baseline leaves the renderer's pass as it was.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"
#include "vtkRelievoBaseline.h"
#include "vtkRelievoPass.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <string>
#include <vector>

namespace testBaselineLayers
{
RELIEVO_TEST_CASE(testBaselineLayers)
{
  relievoTest::Session session;
  {
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkRelievoPass> pass;
    renderer->SetPass(pass);
    const auto window = relievoTest::MakeWindow(16, 16, renderer);
    const std::vector<std::string> layers = { "ambient", "none" };
    pass->SetOptionalLayers(layers);
    vtkNew<vtkRelievoBaseline> baseline;
    baseline->SetRenderer(renderer);
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(baseline->Capture(image));
    RELIEVO_CHECK(pass->GetOptionalLayers() == layers);
  }
  return session.Result();
}
}
