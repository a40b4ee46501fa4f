// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * While it lives, VTK's readers take a point for the decimal point in this thread, and i for the
 * small I, whatever locale the program has: a Python program, or one of Qt's, may have its user's.
 * That stays: VTK's readers of .vtk files leave the program with the locale C.
 */
#ifndef NumberLocale_h
#define NumberLocale_h

#include <locale.h> // for uselocale

#include <string>

namespace scene
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
