// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tags of a TIFF that place it in the world: those of GeoTIFF (OGC 19-008), and GDAL's texts.
#ifndef vtkRelievoGeoTags_h
#define vtkRelievoGeoTags_h

#include "vtk_tiff.h"

#include <optional>
#include <string>
#include <vector>

namespace relievo::image
{
struct GeoTags
{
  std::vector<double> Scale;  // of pixels: x, y, z
  std::vector<double> Ties;   // column, row, 0, x, y, z of each
  std::vector<double> Matrix; // 4 x 4, row by row
  std::vector<unsigned short> Keys;
  std::vector<double> KeyNumbers;
  std::string KeyText;
  std::string NoData;
  std::string Metadata; // XML

  // NoData as a number, also infinite or NaN; empty: the file has none.
  std::optional<double> FindNoData() const;

  // Those of a TIFF of one grey channel or of bands, with a place in the world; empty for any other
  // file.
  static std::optional<GeoTags> Find(const char* file);

  // Whether samples of this PHOTOMETRIC_ kind are values, not colours.
  static bool IsRaster(int photometric, int bits)
  {
    return photometric == PHOTOMETRIC_MINISBLACK && bits >= 8;
  }

  ///@{
  // Which tags give the place in the world; with neither, the file has none.
  bool HasMatrix() const { return this->Matrix.size() == 16; }
  bool HasTie() const { return this->Scale.size() >= 2 && this->Ties.size() >= 6; }
  ///@}

  void Read(TIFF* tiff);
  void Write(TIFF* tiff) const; // to a new file
};
}

#endif
