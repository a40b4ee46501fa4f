// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes depth and normals of a sphere to an OpenEXR file: capture FILE.exr
#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoEXRWriter.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  renderer->ResetCamera();

  vtkNew<vtkRelievoLayerSource> layers; // the ten lines: a source of layers, a writer of EXR
  layers->SetRenderer(renderer);
  layers->AddLayer("depth");
  layers->AddLayer("normal");
  layers->Update();

  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetFileName(argc > 1 ? argv[1] : "sphere.exr");
  writer->SetInputDataObject(layers->GetOutput());
  return writer->Write() == 1 ? 0 : 1;
}
