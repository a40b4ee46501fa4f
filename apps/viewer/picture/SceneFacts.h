// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the files of a picture hold, for panels to offer.
 */
#ifndef SceneFacts_h
#define SceneFacts_h

#include "Facts.h"

namespace viewer
{
class Picture;

Facts GetFacts(const Picture& picture);
}

#endif
