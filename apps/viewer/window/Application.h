// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Qt's application, with a locale that suits file readers: Qt applies the user's locale, in which
 * C's functions, and so VTK's readers, would use a decimal comma.
 */
#ifndef Application_h
#define Application_h

#include <QApplication>

#include <clocale>

namespace viewer
{
class Application : public QApplication
{
public:
  Application(int& argc, char** argv)
    : QApplication(argc, argv)
  {
    std::setlocale(LC_NUMERIC, "C");
  }
};
}

#endif
