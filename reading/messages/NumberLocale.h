// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * While it lives, VTK's readers use a decimal point and the ASCII lower case of I in this thread,
 * whatever the program's locale: Python and Qt programs may use their user's. The program's locale
 * is preserved, although VTK's readers of .vtk files set it to C.
 */
#ifndef NumberLocale_h
#define NumberLocale_h

#include "ReadingNames.h"

#include <locale.h> // for uselocale

#include <string>

namespace reading
{
class NumberLocale
{
public:
  NumberLocale()
    : OfProgram(setlocale(LC_ALL, nullptr))
    , Own(newlocale(LC_ALL_MASK, "C", locale_t(0)))
    , Former(uselocale(this->Own))
  {
  }
  ~NumberLocale()
  {
    uselocale(this->Former);
    freelocale(this->Own);
    if (this->OfProgram != setlocale(LC_ALL, nullptr))
    {
      setlocale(LC_ALL, this->OfProgram.c_str());
    }
  }
  NumberLocale(const NumberLocale&) = delete;
  void operator=(const NumberLocale&) = delete;

private:
  std::string OfProgram;
  locale_t Own;
  locale_t Former;
};
}

#endif
