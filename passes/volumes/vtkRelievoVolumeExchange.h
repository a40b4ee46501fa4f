// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The volumes of processes that each hold a part of the scene. Their transmittances multiply, so
// their optical depths add. All functions but IsOn are collective: every process calls them in the
// same order. In one process they change nothing.
#ifndef vtkRelievoVolumeExchange_h
#define vtkRelievoVolumeExchange_h

#include "vtkRelievoOpticalDepths.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkMultiProcessController;

class vtkRelievoVolumeExchange
{
public:
  explicit vtkRelievoVolumeExchange(vtkMultiProcessController* controller);
  ~vtkRelievoVolumeExchange();

  bool IsOn() const;
  vtkMultiProcessController* GetController() const { return this->Controller; }

  // Whether the argument is true on any process, or on all.
  bool IsAnywhere(bool here);
  bool IsEverywhere(bool here) { return !this->IsAnywhere(!here); }

  int GetLeast(int here);
  int GetMost(int here);

  // Sets the numbers to those of the first process, which has as many.
  void TakeFirst(std::vector<double>& numbers);

  // The extent of all processes' volumes. `others`: the corners of those of other processes, eight
  // for each.
  vtkRelievoOpticalDepths::Extent Join(
    const vtkRelievoOpticalDepths::Extent& own, std::vector<glm::dvec3>& others);

  // The sum over all processes, which have as many numbers each.
  void Add(float* numbers, std::size_t count);

private:
  int Reduce(int here, int operation);

  vtkSmartPointer<vtkMultiProcessController> Controller;
};

#endif
