// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRHeaderScan.h
 * @brief Checks, before OpenEXR uses a header, whether the file's size can contain the data that it
 * announces.
 *
 * OpenEXR allocates the memory that a header asks for before it reads the data. So the header is
 * checked twice: ScanHeaders() checks its bytes before OpenEXR parses them, CheckPlausible() checks
 * the parsed sizes before memory for pixels is allocated.
 */
#ifndef vtkRelievoEXRHeaderScan_h
#define vtkRelievoEXRHeaderScan_h

#include "vtkRelievoEXRStream.h"

#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfHeader.h>

#include <vector>

namespace relievo::exr
{
/**
 * Walks the attributes of every header in the file, without allocating, and leaves the stream at
 * its start. Throws Failure unless the file begins as OpenEXR files do, every name ends within its
 * limit, every attribute lies inside the file, attributes of the format's types have the size of
 * their type, and there are at most 1024 parts with at most 4096 channels and 4096 attributes each.
 */
void ScanHeaders(InputStream& stream);

/**
 * Throws Failure unless the announced pixels of the parts fit into a file of this size: each part's
 * table of chunks lies in the file, and its pixels have at most as many bytes as its compression
 * can unpack from the file in the best case.
 */
void CheckPlausible(const std::vector<const Imf::Header*>& parts, uint64_t fileSize);

/** Number of scan lines that a compression packs together. */
int LinesPerChunk(Imf::Compression compression);
}

#endif
