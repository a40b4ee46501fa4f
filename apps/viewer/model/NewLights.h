// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Chooses position and strength for new lights, to show the scene well.
 */
#ifndef NewLights_h
#define NewLights_h

#include <string>

namespace viewer
{
class Document;

/// A word of --light; `kind` is sun, spot or point.
std::string WriteNewLight(const Document& document, const std::string& kind);
}

#endif
