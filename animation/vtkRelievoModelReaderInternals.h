// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkRelievoModelReader holds.
 */
#ifndef vtkRelievoModelReaderInternals_h
#define vtkRelievoModelReaderInternals_h

#include "vtkRelievoModel.h"
#include "vtkRelievoModelPlay.h"
#include "vtkRelievoModelReader.h"
#include "vtkRelievoModelSources.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <map>
#include <set>
#include <string>

struct vtkRelievoModelReader::Internals
{
  relievo::Model Model;
  // What the model was read from.
  std::string Path;
  relievo::ModelSources Sources;
  int Weights = 0;
  bool Stands = false;
  std::set<std::string> Refused;                               // which names were complained about
  std::map<std::string, vtkSmartPointer<vtkImageData>> Images; // those that were asked for
  vtkSmartPointer<vtkStringArray> Names = vtkSmartPointer<vtkStringArray>::New();
  vtkSmartPointer<vtkStringArray> Bones = vtkSmartPointer<vtkStringArray>::New();

  // What is played, as the reader's settings have it.
  void Choose(vtkRelievoModelReader& reader, relievo::ModelPlay& play);
};

#endif
