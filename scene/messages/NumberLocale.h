// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * While it lives, VTK's readers take a point for the decimal point in this thread, whatever locale
 * the program has: a Python program, or one of Qt's, may have its user's.
 */
#ifndef NumberLocale_h
#define NumberLocale_h

#include <locale.h> // for uselocale

namespace scene
{
class NumberLocale
{
public:
  NumberLocale()
    : Own(newlocale(LC_NUMERIC_MASK, "C", duplocale(uselocale(locale_t(0)))))
    , Former(uselocale(this->Own))
  {
  }
  ~NumberLocale()
  {
    uselocale(this->Former);
    freelocale(this->Own);
  }
  NumberLocale(const NumberLocale&) = delete;
  void operator=(const NumberLocale&) = delete;

private:
  locale_t Own;
  locale_t Former;
};
}

#endif
