// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The beginning of a Python program: what it imports, and functions that lines of it call.
 */
#ifndef PythonProgram_h
#define PythonProgram_h

#include <string>

namespace viewer
{
/**
 * The lines, behind the imports and functions that they need. These are
 *
 *   data(reader, path)     what a file holds
 *   image(path)            an image of a file
 *   surface(data)          the polygons to draw of data, composite data too
 *   finite(data)           these without cells that have infinite points
 *   smooth(data)           these with normals
 *   by_material(path, file, mesh)     the cells of each material of an OBJ file
 *   part(mesh, cells, coordinates)    these cells of a mesh; the name of its texture coordinates
 *   turn(actor)            texture coordinates of a glTF file, turned as it says
 *   mapped(data, mapping, up)         with texture coordinates
 */
std::string CompletePython(const std::string& lines);
}

#endif
