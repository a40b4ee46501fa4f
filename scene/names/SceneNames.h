// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names of lower modules, which this module uses without their namespaces.
#ifndef SceneNames_h
#define SceneNames_h

namespace words
{
class OptionRows;
}
namespace reading
{
}
namespace look
{
}

namespace scene
{
using namespace words;
using namespace reading;
using namespace look;
}

#endif
