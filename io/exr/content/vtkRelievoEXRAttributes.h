// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRAttributes.h
 * @brief Field data of an image as attributes of an EXR header, and back.
 *
 * | field data                   | attributes                                       |
 * |------------------------------|--------------------------------------------------|
 * | the camera                   | see vtkRelievoEXRCamera.h                        |
 * | lights (strings)             | relievo:light_0, relievo:light_1 ... (string)    |
 * | displayWindow, dataWindow    | the header's windows (min x, min y, max x, max y)|
 * | chromaticities (8 floats)    | chromaticities                                   |
 * | envmap (1 integer)           | envmap                                           |
 * | NAME, 1 or more strings      | NAME (string or stringvector)                    |
 * | NAME, 1, 2, 3 int            | NAME (int, v2i, v3i)                             |
 * | NAME, 1, 2, 3, 9, 16 float   | NAME (float, v2f, v3f, m33f, m44f)               |
 * | NAME, 1, 2, 3, 9, 16 double  | NAME (double, v2d, v3d, m33d, m44d)              |
 *
 * Field arrays of other types or sizes, and attributes of other types, are left out.
 */
#ifndef vtkRelievoEXRAttributes_h
#define vtkRelievoEXRAttributes_h

#include <OpenEXR/ImfHeader.h>

#include <set>
#include <string>

class vtkFieldData;

namespace relievo::exr
{
/**
 * Adds the field data to the header, except arrays named in `except`. Throws Failure if a known
 * array has the wrong size.
 */
void WriteAttributes(
  vtkFieldData* fields, const std::set<std::string>& except, Imf::Header& header);

/** Adds the header's attributes to the field data. */
void ReadAttributes(const Imf::Header& header, vtkFieldData* fields);

/**
 * True for names available to the user's own attributes: 1 to 255 bytes, neither used by the format
 * nor given a meaning by the table above.
 */
bool IsFreeAttribute(const std::string& name);
}

#endif
