// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageTools.h
 * @brief Shared by the tests of io/: small pictures to write, and comparisons with read images.
 */
#ifndef ImageTools_h
#define ImageTools_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

class vtkDataArray;

namespace ioTest
{
/** A picture of width x height x 1 points without arrays. */
vtkSmartPointer<vtkImageData> MakeImage(int width, int height);

/** Adds a point array of a VTK type; value(point, component) gives its values. */
vtkDataArray* AddArray(vtkImageData* image, const std::string& name, int vtkType, int components,
  const std::function<double(int, int)>& value);

/** Adds a field array of one tuple. */
void AddField(vtkImageData* image, const std::string& name, const std::vector<double>& values);

/** Adds a field array of strings. */
void AddStrings(
  vtkImageData* image, const std::string& name, const std::vector<std::string>& values);

/**
 * Every layer of a capture, background, infinities, NaNs and large ids included, and field data.
 */
vtkSmartPointer<vtkImageData> MakeLayers(int width, int height);

/** Reads a file; the output is empty when that fails. */
vtkSmartPointer<vtkImageData> Read(const std::string& file);

/** Writes a file with the writer's defaults; whether it said it did. */
bool Write(vtkImageData* image, const std::string& file);

/** Says how two arrays differ in name, type, size or bits; empty when they do not. */
std::string Difference(vtkDataArray* expected, vtkDataArray* actual);

/** Says how two images differ in size or in any point array, order included; empty when not. */
std::string Difference(vtkImageData* expected, vtkImageData* actual);

/** The bytes of a file; empty when it is not there. */
std::string Bytes(const std::string& file);
void WriteBytes(const std::string& file, const std::string& bytes);

/** Names of the files in a folder, hidden ones too, sorted, with blanks between. */
std::string Listing(const std::string& folder);
}

#endif
