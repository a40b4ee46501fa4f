// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names of lower modules, which this module uses without their namespaces.
#ifndef LookNames_h
#define LookNames_h

namespace words
{
class OptionRows;
}
namespace reading
{
}

namespace look
{
using namespace words;
using namespace reading;
}

#endif
