// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Dataset_h
#define Dataset_h

namespace cli
{
struct DatasetOptions;

/// `relievo dataset`: shows the scene to all cameras, and writes what they see. Throws
/// scene::UsageError or scene::WorkError.
void Dataset(const DatasetOptions& options);
}

#endif
