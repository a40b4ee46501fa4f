// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads layers of the last frame from whoever wrote them.
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

  // Of another frame: who writes which layer ("": any other), and those that cannot be made, with
  // the reason in words.
  void SetFrame(
    std::map<std::string, vtkRelievoStage*> writers, std::map<std::string, std::string> missing);

  // The stage leaves the frame.
  void Forget(vtkRelievoStage* stage);

  // Adds the layers to the image's point data; what is wrong, in words: "" if all were added.
  std::string Read(const std::vector<std::string>& names, vtkImageData* image);

private:
  vtkRelievoStage* FindWriter(const std::string& name) const;

  bool IsAlone(const std::string& name) const; // no stage's

  vtkRelievoColorTarget& Color;
  vtkRelievoSampleAccumulator& Samples;
  std::map<std::string, vtkRelievoStage*> Writers;
  std::map<std::string, std::string> Missing;
};

#endif
