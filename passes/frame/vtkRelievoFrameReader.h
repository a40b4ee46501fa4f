// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads layers of the last frame from the stages that wrote them.
#ifndef vtkRelievoFrameReader_h
#define vtkRelievoFrameReader_h

#include <map>
#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoColorTarget;
class vtkRelievoSampleAccumulator;
class vtkRelievoStage;

class vtkRelievoFrameReader
{
public:
  vtkRelievoFrameReader(vtkRelievoColorTarget& color, vtkRelievoSampleAccumulator& samples)
    : Color(color)
    , Samples(samples)
  {
  }

  using Stages = std::map<std::string, vtkRelievoStage*>; // by layer

  // Starts a new frame: the writer of each layer ("": any other layer), stages that change layers
  // of others, and layers that cannot be made, with the reasons.
  void SetFrame(Stages writers, Stages amenders, std::map<std::string, std::string> missing);

  // For a stage that leaves the frame.
  void Forget(vtkRelievoStage* stage);

  // Adds the layers to the image's point data. Returns an error message; "" if all were added.
  std::string Read(const std::vector<std::string>& names, vtkImageData* image);

  // Lets stages change the layers that were read of others.
  std::string Amend(const std::vector<std::string>& names, vtkImageData* image);

private:
  vtkRelievoStage* FindWriter(const std::string& name) const;

  bool IsAlone(const std::string& name) const; // not written by a stage

  vtkRelievoColorTarget& Color;
  vtkRelievoSampleAccumulator& Samples;
  Stages Writers;
  Stages Amenders;
  std::map<std::string, std::string> Missing;
};

#endif
