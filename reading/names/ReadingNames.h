// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names of lower modules, which this module uses without their namespaces.
#ifndef ReadingNames_h
#define ReadingNames_h

namespace words
{
class OptionRows;
}

namespace reading
{
using namespace words;
}

#endif
