// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Qt's application, in which files are read as everywhere: Qt takes over the user's locale, in
 * which C's functions, and VTK's readers with them, take a comma for the decimal point.
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
