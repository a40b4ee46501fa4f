// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Large pictures are drawn in bands of rows, which take the memory of one band: the window has the
 * size of a band, and the bands are tiles of VTK's. They overlap, because some pixels depend on
 * their neighbours.
 */
#ifndef Bands_h
#define Bands_h

#include "SceneNames.h"

#include <array>

class vtkRenderWindow;
class vtkRenderer;

namespace scene
{
struct RenderOptions;

/// Rows of a band for the options' picture; 0: the picture is drawn whole, because it is small or
/// because an output needs all of it, which a note then says. `wanted`: rows of small pictures,
/// too; 0 for the default.
int ChooseBandRows(const RenderOptions& options, int wanted);

class Bands
{
public:
  /// Divides a picture; 0 rows: a single band.
  Bands(const std::array<int, 2>& size, int rows);

  int GetCount() const { return this->Count; }

  /// Rows of the picture, counted from the bottom.
  struct Band
  {
    int Drawn;       ///< lowest row drawn
    int Lowest, End; ///< rows of this band alone
  };
  /// The first one is at the top.
  Band Get(int number) const;

  /// The size of the window that draws them.
  std::array<int, 2> GetWindowSize() const { return { this->Size[0], this->Rows }; }

  /// Makes the window's tiles cover the picture.
  void SetTiles(vtkRenderWindow* window, vtkRenderer* renderer) const;

private:
  std::array<int, 2> Size;
  int Rows, Count;
};
}

#endif
