// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How an actor looks as lines of Python.
 */
#ifndef PythonProperty_h
#define PythonProperty_h

#include <ostream>

class vtkMapper;
class vtkProperty;

namespace viewer
{
/// Lines for `mapper`. Whether it shows colours already, and interpolates values before they are
/// colours.
void WriteColors(std::ostream& out, vtkMapper* mapper, bool wasColored, bool wasInterpolated);

/// Lines for `property`, of which all is so already that `before` has.
void WriteProperty(std::ostream& out, vtkProperty* property, vtkProperty* before);
}

#endif
