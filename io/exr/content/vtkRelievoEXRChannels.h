// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRChannels.h
 * @brief Which EXR channels hold which VTK array: the one table that reader and writer share. The
 * layers' suffixes are those of vtkRelievoLayerCatalogue.
 *
 * | array                              | channels                              |
 * |------------------------------------|---------------------------------------|
 * | color, 3 or 4 components           | R G B [A]                             |
 * | albedo, 3 or 4 components          | albedo.R albedo.G albedo.B [albedo.A] |
 * | depth, range, 1 component          | depth.Z, range.Z                      |
 * | actor, block, cell, 1 integer      | actor.id, block.id, cell.id           |
 * | any other NAME with 1 component    | NAME.V                                |
 * | with 2 or 3 components             | NAME.X NAME.Y [NAME.Z]                |
 * | with 4 or more components          | NAME.0 NAME.1 NAME.2 NAME.3 ...       |
 *
 * The string vector `relievo:arrays` records, array by array, the VTK type, the number of
 * components and the name ("double 3 position"), so that a file gives back the arrays it was made
 * from, in their order. Files of other programs have no such record: there the table alone decides,
 * R G B [A] after any layer name count as one array too, and every other channel is an array of its
 * own.
 */
#ifndef vtkRelievoEXRChannels_h
#define vtkRelievoEXRChannels_h

#include <string>
#include <vector>

class vtkDataArray;
class vtkPointData;

namespace relievo::exr
{
/** Name of the attribute (a string vector) that records the arrays of a file. */
constexpr const char* ArraysAttribute = "relievo:arrays";

/** Longest name, in bytes, of a channel or an attribute that OpenEXR can read back. */
constexpr std::size_t LongestName = 255;

/** Largest number of channels to read from a part. */
constexpr int MostChannels = 4096;

/**
 * Name of the channel that holds one component of an array.
 * \param array       Name of the array, not empty.
 * \param components  Number of its components, 1 or more.
 * \param integer     Whether its values are integers.
 * \param component   Index of the component, from 0.
 */
std::string ChannelName(const std::string& array, int components, bool integer, int component);

/** True for arrays whose bytes represent 0 to 1: 8-bit colours, `color` and `albedo`. */
bool IsNormalized(const std::string& array, int vtkType, int components);

/** True for arrays of positions, stored relative to `relievo:origin`: `position`. */
bool IsPosition(const std::string& array, int vtkType, int components);

/** The first of these arrays, or nullptr. */
vtkDataArray* FindPositions(vtkPointData* points);

/** A channel of a file, as needed for grouping by name. */
struct NamedChannel
{
  std::string Name;
  bool Integer; // UINT
};

/** An array of a file: its name, VTK type, and the indices of its channels by component. */
struct ArrayLayout
{
  std::string Name;
  int VtkType;
  std::vector<int> Channels;
};

/**
 * Sorts the channels of a file into arrays.
 * \param channels  Channels of the file, names all different.
 * \param record    Entries of `relievo:arrays`; empty for files of other programs. Entries that do
 *                  not fit the channels are passed over: the record may be damaged or out of date.
 * \return Every channel in exactly one array; the arrays' names are all different.
 */
std::vector<ArrayLayout> GroupChannels(
  const std::vector<NamedChannel>& channels, const std::vector<std::string>& record);

/** Entry of `relievo:arrays`; empty if EXR cannot hold arrays of this VTK type. */
std::string RecordEntry(const std::string& array, int vtkType, int components);
}

#endif
