// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points.h"

#include "Failure.h"
#include "Messages.h"
#include "Readers.h"

namespace cli
{
//------------------------------------------------------------------------------
void CheckPointFile(const std::string& option, const std::string& path)
{
  CheckExtension(path);
  if (IsGLTF(path))
  {
    throw WordsError(option + ": " + path + " is a scene; expected a file of points");
  }
  CheckReadable(path);
}

//------------------------------------------------------------------------------
void CheckPoints(vtkRelievoPointValues* points, const std::string& path, const std::string& things,
  const std::string& needs)
{
  const int count = points->GetNumberOfPoints();
  const int leftOut = points->GetNumberLeftOut();
  Messages::Check(path, count == 0,
    leftOut == 0 ? "holds no points, expected " + things
                 : "holds no points that are " + things + ": " + needs);
  if (leftOut > 0)
  {
    Messages::Note(path + ": left out " + std::to_string(leftOut) + " of " +
      std::to_string(count + leftOut) + " points that are no " + things + ": " + needs);
  }
}
}
