// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunHours.h"

#include "Messages.h"
#include "Outputs.h"
#include "Progress.h"
#include "SightFiles.h"
#include "SunOptions.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoSunExposure.h"

#include <cstdio>

namespace cli
{
namespace
{
void Print(const SunOptions& options, vtkPolyData* mesh)
{
  vtkDataSetAttributes* where = mesh->GetCellData();
  where = options.Points ? mesh->GetPointData() : where;
  vtkDataArray* hours = where->GetArray("sun_hours");
  double sum = 0.;
  for (vtkIdType i = 0; i < hours->GetNumberOfTuples(); ++i)
  {
    sum += hours->GetTuple1(i);
  }
  std::printf("%s: %.1f hours of sun in the mean of %lld %s, of %.1f\n", options.File.c_str(),
    sum / static_cast<double>(hours->GetNumberOfTuples()),
    static_cast<long long>(hours->GetNumberOfTuples()), options.Points ? "points" : "cells",
    mesh->GetFieldData()->GetArray("possible_hours")->GetTuple1(0));
}
}

//------------------------------------------------------------------------------
void SunHours(const SunOptions& options)
{
  const scene::Messages::Scope scope;
  scene::Outputs outputs;
  outputs.Add("-o", options.File, options.Files);
  scene::Progress progress;
  vtkNew<vtkRelievoSunExposure> sun;
  const int up = ReadMeshes(options.Files, options.AllowedFolders, sun, progress);
  sun->SetLatitude(options.Latitude);
  sun->SetLongitude(options.Longitude);
  sun->SetFirstDay(options.Days[0].data());
  sun->SetLastDay(options.Days[1].data());
  sun->SetDayStep(options.DayStep);
  sun->SetStep(options.Step);
  sun->SetUpAxis(options.Up < 0 ? up : options.Up);
  sun->SetPoints(options.Points);
  sun->SetSkySamples(options.Sky);
  progress.Begin("following the sun");
  progress.Observe(sun);
  sun->Update();
  scene::Messages::Check("sun");
  WriteMesh(sun->GetOutput(), "-o", options.File, outputs, progress);
  outputs.Commit();
  progress.End();
  Print(options, sun->GetOutput());
}
}
