// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words by which stages that leave volumes out say so in the frame's report:
// "; WORDS: 2 volumes", or "" without volumes.
#ifndef vtkRelievoTellVolumes_h
#define vtkRelievoTellVolumes_h

#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRelievoFrameContext.h"

#include <algorithm>
#include <string>

inline std::string vtkRelievoTellVolumes(
  const vtkRelievoFrameContext& context, const std::string& words)
{
  const auto& props = context.Scene.Props;
  const auto count = std::count_if(props.begin(), props.end(), [](const vtkRelievoFrameProp& each) {
    vtkNew<vtkPropCollection> volumes;
    each.Prop->GetVolumes(volumes);
    return volumes->GetNumberOfItems() > 0;
  });
  return count == 0
    ? std::string()
    : "; " + words + ": " + std::to_string(count) + (count == 1 ? " volume" : " volumes");
}

#endif
