// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Asks the user where to save.
 */
#ifndef SavePlace_h
#define SavePlace_h

#include <QString>

class QWidget;

namespace viewer
{
/// A path that ends in the suffix, such as ".png", in letters of any case; empty if the user wants
/// none. Nothing that exists is given without the user's word.
QString AskPlace(QWidget* parent, const QString& title, const QString& suffix);
}

#endif
