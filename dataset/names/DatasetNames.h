// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names of lower modules, which this module uses without their namespaces.
#ifndef DatasetNames_h
#define DatasetNames_h

namespace words
{
}
namespace reading
{
}
namespace look
{
}
namespace scene
{
}

namespace dataset
{
using namespace words;
using namespace reading;
using namespace look;
using namespace scene;
}

#endif
