// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoPLYText.h
 * @brief From the bytes of a PLY file to tables; private to vtkRelievoPLYReader.
 */
#ifndef vtkRelievoPLYText_h
#define vtkRelievoPLYText_h

#include "vtkRelievoMeshText.h"
#include "vtkType.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::ply
{
// A property of an element, with its numbers: one for each of them, or lists one after the other.
struct Column
{
  std::string Name;
  int Type = 0;      // of VTK
  int CountType = 0; // of lists; 0: no list
  bool Kept = true;
  std::vector<double> Values;
  std::vector<vtkIdType> Starts; // of lists in the values, and the end
};

struct Element
{
  std::string Name;
  vtkIdType Count = 0;
  std::vector<Column> Columns;

  Column* Find(const std::string& name)
  {
    for (Column& column : this->Columns)
    {
      if (column.Name == name)
      {
        return &column;
      }
    }
    return nullptr;
  }
};

struct Content
{
  std::vector<Element> Elements;
  std::vector<std::string> Textures; // names of files, of the comments TextureFile

  Element* Find(const std::string& name)
  {
    for (Element& element : this->Elements)
    {
      if (element.Name == name)
      {
        return &element;
      }
    }
    return nullptr;
  }
};

// Reads the elements `vertex`, `face`, `tristrips` and `edge`, or throws a Refusal. `goOn` is
// called now and then with the share that is done; when it returns false, what was read so far is
// returned.
Content Read(std::string_view text, const std::function<bool(double)>& goOn);
}

#endif
// VTK-HeaderTest-Exclude: vtkRelievoPLYText.h
