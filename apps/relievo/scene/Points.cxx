// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points.h"

#include "DataSets.h"
#include "Failure.h"
#include "Messages.h"
#include "Readers.h"
#include "Values.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <set>
#include <vector>

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
void CheckArray(const std::string& option, const std::string& path, vtkDataObject* data,
  const std::string& what, const std::string& name)
{
  std::set<std::string> names;
  ForEachDataSet(data, [&names](vtkDataSet* part) {
    for (int i = 0; i < part->GetPointData()->GetNumberOfArrays(); ++i)
    {
      const char* own = part->GetPointData()->GetArrayName(i);
      names.insert(own ? own : "");
    }
  });
  if (!name.empty() && names.count(name) == 0)
  {
    RefuseValue(option + " " + path + "," + what, name,
      "a number, or a point array of the file" +
        (names.empty() ? ", which has none"
                       : ": " + Join(std::vector<std::string>(names.begin(), names.end()), ", ")));
  }
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
