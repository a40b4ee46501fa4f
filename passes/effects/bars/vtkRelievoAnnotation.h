// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers, ticks, ink and font of the colour bar, the grid and the scale bar over a picture.
#ifndef vtkRelievoAnnotation_h
#define vtkRelievoAnnotation_h

#include "vtkRelievoEffectsModule.h" // for the export macro

#include <array>
#include <string>
#include <vector>

class vtkRenderer;
class vtkTextProperty;

namespace vtkRelievoAnnotation
{
// Black or white, whichever contrasts more with the background.
VTKRELIEVOEFFECTS_EXPORT std::array<double, 3> GetInk(vtkRenderer* renderer);

// The largest 1, 2 or 5 times a power of 10 not above the value, as the nearest double.
VTKRELIEVOEFFECTS_EXPORT double RoundDown(double length);

// Writes at least two evenly spaced values with the fewest digits that are accurate to a few
// hundredths of the step; exponents shorten long numbers.
VTKRELIEVOEFFECTS_EXPORT std::vector<std::string> WriteValues(const std::vector<double>& values);

struct Ticks
{
  std::vector<double> Values; // ascending, with a text each
  std::vector<std::string> Texts;
  std::vector<double> Minor;
  std::string Factor; // of all texts, such as ×10⁵; may be empty
};

// At most `most` ticks, at least 2, at 1, 2 or 5 times a power of ten within an ascending range. A
// logarithmic range of two decades or more has powers of ten.
VTKRELIEVOEFFECTS_EXPORT Ticks MakeTicks(const double* range, bool log, int most);

// The value in five digits at most.
VTKRELIEVOEFFECTS_EXPORT std::string WriteValue(double value);

// DejaVu Sans, with Greek letters and superscripts: the file that the environment variable
// RELIEVO_FONT names, or else the system's; empty if there is none.
VTKRELIEVOEFFECTS_EXPORT const std::string& GetFontFile();

// A file to try after these, before the font is first used.
VTKRELIEVOEFFECTS_EXPORT void SetFallbackFont(const std::string& file);

// Sets that font, or else VTK's own, which has fewer letters.
VTKRELIEVOEFFECTS_EXPORT void SetFont(vtkTextProperty* text);
}

#endif
