// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Fine structure on what is drawn, from image files: normals and relief.
 */
#ifndef Surface_h
#define Surface_h

class vtkRenderer;

namespace cli
{
class Progress;
struct RenderOptions;

/// Throws WordsError or WorkError for a map's file that is no image, or cannot be opened.
void CheckMaps(const RenderOptions& options);

/// Puts the maps on every actor. Throws WorkError with the file's name.
void SetMaps(vtkRenderer* renderer, const RenderOptions& options, Progress& progress);
}

#endif
