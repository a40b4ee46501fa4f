// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Captures a sphere's depth, writes it to FILE.exr (the only word of the command line), reads it
// back, and doubles its colour with a stage of its own: an installed Relievo, seen from outside.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoEXRReader.h>
#include <vtkRelievoEXRWriter.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <iostream>

namespace
{
// Depth at the middle of an image of odd size; -1 without such a layer.
double MiddleDepth(vtkImageData* image)
{
  vtkDataArray* depth = image->GetPointData()->GetArray("depth");
  return depth ? depth->GetComponent(image->GetNumberOfPoints() / 2, 0) : -1.;
}

// Red of the linear colour at the middle of the picture.
double MiddleRed(vtkRelievoLayerSource* layers)
{
  layers->RemoveAllLayers();
  layers->AddLayer("color");
  layers->HDROn();
  layers->Update();
  vtkImageData* image = layers->GetOutput();
  vtkDataArray* color = image->GetPointData()->GetArray("color");
  return color ? color->GetComponent(image->GetNumberOfPoints() / 2, 0) : -1.;
}
}

int main(int, char* argv[])
{
  vtkNew<vtkSphereSource> sphere; // radius 0.5, with a vertex at (0, 0, 0.5)
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(101, 101);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0., 0., 3.);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRelievoLayerSource> layers;
  layers->SetRenderer(renderer);
  layers->AddLayer("depth");
  layers->Update();
  const double captured = MiddleDepth(layers->GetOutput());

  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetFileName(argv[1]);
  writer->SetInputConnection(layers->GetOutputPort());
  writer->Write();
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  const double read = MiddleDepth(reader->GetOutput());

  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  const double red = MiddleRed(layers);
  vtkRelievoStage* times = frame->GetStage("times");
  if (!times || !times->SetParameter("factor", "2"))
  {
    std::cerr << "the frame does not know this project's stage\n";
    return EXIT_FAILURE;
  }
  times->EnabledOn();
  const double doubled = MiddleRed(layers);
  std::cout << "red " << red << ", times two " << doubled << " (" << times->GetReason() << ")\n";

  std::cout << "depth " << captured << ", read back " << read << "\n";
  const bool right = std::abs(captured - 2.5) < 1e-5 && read == captured && red > 0.1 &&
    std::abs(doubled - 2. * red) < 2e-3 && times->GetReason() == "meshes: 1";
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
