// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoOBJText.h
 * @brief Reads the text of an OBJ file into tables; private to vtkRelievoOBJReader.
 */
#ifndef vtkRelievoOBJText_h
#define vtkRelievoOBJText_h

#include "vtkRelievoMeshText.h"
#include "vtkType.h"

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace relievo::obj
{
// A number of occurrences, and the line of the first.
struct Tally
{
  vtkIdType Count = 0;
  long long Line = 0;

  void Add(long long line) { this->Line = this->Count++ == 0 ? line : this->Line; }
};

// Names in the order of their first occurrence in the file.
struct NameList
{
  std::vector<std::string> Names;
  std::unordered_map<std::string, int> Places;

  int Find(const std::string& name)
  {
    const auto [place, isNew] = this->Places.emplace(name, static_cast<int>(this->Names.size()));
    if (isNew)
    {
      this->Names.push_back(name);
    }
    return place->second;
  }
};

// Statements in force for a cell; -1: none.
struct State
{
  int Material = -1;
  int Group = -1;
  int Object = -1;
  int Smoothing = 0;
};

// The cells of one kind. Each corner has a point and, in vectors that are empty if no corner has
// any, a texture coordinate and a normal; -1: none.
struct CellList
{
  std::vector<vtkIdType> Starts = { 0 };
  std::vector<vtkIdType> Points;
  std::vector<vtkIdType> TextureCoordinates;
  std::vector<vtkIdType> Normals;
  std::vector<int> States;
};

enum CellKind
{
  Verts,
  Lines,
  Polys
};

struct Content
{
  std::vector<double> Points;            // three each; NaN if a coordinate is not a number
  std::vector<float> Colors;             // three each; -1: none; empty if no point has any
  std::vector<float> TextureCoordinates; // two each; NaN if not a number
  std::vector<float> Normals;            // three each; NaN if not a number
  CellList Cells[3];
  std::vector<State> States = { {} };
  NameList Materials;
  NameList Groups;
  NameList Objects;
  std::vector<std::string> Libraries; // the text after each mtllib
  Tally InvalidPoints;
  Tally InvalidTextureCoordinates;
  Tally InvalidNormals;
  Tally Curves; // and free-form surfaces
};

// Reads the text, or throws a Refusal. `goOn` is called regularly with the share done; if it
// returns false, the content read so far is returned.
Content Read(std::string_view text, const std::function<bool(double)>& goOn);
}

#endif
// VTK-HeaderTest-Exclude: vtkRelievoOBJText.h
