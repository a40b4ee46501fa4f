// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a scene holds, for panels to offer.
 */
#ifndef SceneFacts_h
#define SceneFacts_h

#include "Facts.h"

namespace viewer
{
class BareScene;

Facts GetFacts(const BareScene& scene);
}

#endif
