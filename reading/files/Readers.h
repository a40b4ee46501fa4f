// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of data to VTK data objects, by the extension of the name. Programs of ours have another
 * process read them (Apart). Models are whole scenes and not data: ReadModel reads them.
 */
#ifndef Readers_h
#define Readers_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace scene
{
class ReadContext;

/// The extension in lower case with its dot, ".vtp"; "" without one.
std::string ExtensionOf(const std::string& path);

///@{
/// Those that readers take, without dots: of data, of models, of both.
std::vector<std::string> GetDataExtensions();
std::vector<std::string> GetModelExtensions();
std::vector<std::string> GetExtensions();
///@}

/// Throws UsageError if no reader takes the path's extension.
void CheckExtension(const std::string& path);

/// Whether some reader takes it.
bool HasReader(const std::string& path);

/// Whether the path's extension is that of glTF.
bool IsGLTF(const std::string& path);

/// Whether the path's extension is glTF's or that of other models, which ReadModel reads.
bool IsModel(const std::string& path);

/// Whether files of the path's format have z up, where nothing else says so.
bool HasZUp(const std::string& path);

/// Whose reader reads the path, for messages: "VTK", or a format that Relievo itself reads.
std::string GetReaderName(const std::string& path);

/// Throws WorkError unless the path is a file that can be opened.
void CheckReadable(const std::string& path);

/// Throws WorkError unless the path, which came with --allow-folder, is a folder.
void CheckFolder(const std::string& path);

/// What is said of a file that no reader understands and VTK has no words for.
std::string NotAsNamed(const std::string& path);

/// What there is to draw of a file: its surface, as MakeSurface. With `images`, one that
/// GetVolumeImage takes stays an image. Throws WorkError with its
/// name.
vtkSmartPointer<vtkDataObject> ReadSurface(
  const std::string& path, bool smooth, bool images, ReadContext& context);

/// The points of a file with their arrays. Throws WorkError with its name.
vtkSmartPointer<vtkDataObject> ReadPoints(const std::string& path, ReadContext& context);
}

#endif
