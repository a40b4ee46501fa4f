// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads data files into VTK data objects, by the extension of the name. The command and the viewer
 * read them in a separate process (Apart). Models are whole scenes: ReadModel reads them.
 */
#ifndef Readers_h
#define Readers_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace reading
{
class ReadContext;

/// The extension in lower case with its dot, ".vtp"; "" if there is none.
std::string ExtensionOf(const std::string& path);

///@{
/// Extensions with a reader, without dots: of data, of models, of both.
std::vector<std::string> GetDataExtensions();
std::vector<std::string> GetModelExtensions();
std::vector<std::string> GetExtensions();
///@}

/// Throws UsageError if no reader accepts the path's extension.
void CheckExtension(const std::string& path);

/// Whether a reader accepts it.
bool HasReader(const std::string& path);

/// Whether the path has the extension of a raster of heights, which are along z.
bool IsRaster(const std::string& path);

/// Whether the path has a glTF extension.
bool IsGLTF(const std::string& path);

/// Whether the path has the extension of glTF or another model format, read by ReadModel.
bool IsModel(const std::string& path);

/// Whether the path's format has z up by custom.
bool HasZUp(const std::string& path);

/// Owner of the path's reader, for messages: "VTK", or a format that Relievo itself reads.
std::string GetReaderName(const std::string& path);

/// Throws WorkError unless the path is a file that can be opened.
void CheckReadable(const std::string& path);

/// Throws WorkError unless the path, given with --allow-folder, is a folder.
void CheckFolder(const std::string& path);

/// The message for a file that no reader understands, when VTK gives none.
std::string NotAsNamed(const std::string& path);

/// Reads a file's drawable surface, by MakeSurface. With `images`, an image that GetVolumeImage
/// accepts stays an image. Throws WorkError naming the file.
vtkSmartPointer<vtkDataObject> ReadSurface(
  const std::string& path, bool smooth, bool images, ReadContext& context);

/// Reads the points of a file with their arrays. Throws WorkError naming the file.
vtkSmartPointer<vtkDataObject> ReadPoints(const std::string& path, ReadContext& context);
}

#endif
