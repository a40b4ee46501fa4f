// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a reader of layers takes the words of the G-buffer from.
#ifndef vtkRelievoWordSource_h
#define vtkRelievoWordSource_h

#include <cstdint>
#include <vector>

class vtkRelievoWordSource
{
public:
  virtual ~vtkRelievoWordSource() = default;

  // Reads the attachment's words for all pixels of the region, row 0 at the bottom, each word into
  // its own plane.
  virtual bool Read(
    int attachment, const int region[4], const std::vector<std::uint32_t*>& planes) = 0;
};

#endif
