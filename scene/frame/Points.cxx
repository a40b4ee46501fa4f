// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points.h"

#include "DataSets.h"
#include "Errors.h"
#include "Messages.h"
#include "Readers.h"
#include "Values.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <set>
#include <vector>

namespace scene
{
//------------------------------------------------------------------------------
void CheckPointFile(const std::string& option, const std::string& path)
{
  CheckExtension(path);
  if (IsGLTF(path))
  {
    throw UsageError(option + ": " + path + " is a scene; expected a file of points");
  }
  CheckReadable(path);
}

//------------------------------------------------------------------------------
PointFile::PointFile(const std::string& option, const std::string& path, Progress& progress)
  : Option(option)
  , Path(path)
  , Data(ReadData(path, progress))
{
}

//------------------------------------------------------------------------------
bool PointFile::Has(const std::string& array) const
{
  bool found = false;
  ForEachDataSet(this->Data, [&](vtkDataSet* part) {
    found = found || part->GetPointData()->GetArray(array.c_str()) != nullptr;
  });
  return found;
}

//------------------------------------------------------------------------------
void PointFile::TakeArray(
  vtkRelievoPointValues* points, const char* name, bool isSet, const std::string& array) const
{
  std::set<std::string> names;
  ForEachDataSet(this->Data, [&names](vtkDataSet* part) {
    for (int i = 0; i < part->GetPointData()->GetNumberOfArrays(); ++i)
    {
      const char* own = part->GetPointData()->GetArrayName(i);
      names.insert(own ? own : "");
    }
  });
  if (!array.empty() && names.count(array) == 0)
  {
    RefuseValue(this->Option + " " + this->Path + "," + name, array,
      "a number, or a point array of the file" +
        (names.empty() ? ", which has none"
                       : ": " + Join(std::vector<std::string>(names.begin(), names.end()), ", ")));
  }
  if (isSet || !array.empty())
  {
    points->SetArray(name, array);
  }
}

//------------------------------------------------------------------------------
void PointFile::Check(
  vtkRelievoPointValues* points, const std::string& things, const std::string& needs) const
{
  const int count = points->GetNumberOfPoints();
  const int leftOut = points->GetNumberLeftOut();
  Messages::Check(this->Path, count == 0,
    leftOut == 0 ? "holds no points, expected " + things
                 : "holds no points that are " + things + ": " + needs);
  if (leftOut > 0)
  {
    Messages::Note(this->Path + ": left out " + std::to_string(leftOut) + " of " +
      std::to_string(count + leftOut) + " points that are no " + things + ": " + needs);
  }
}
}
