// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Controls that stand for one option of the command line. Their name is the option's, without
 * dashes.
 */
#ifndef OptionEdits_h
#define OptionEdits_h

#include "Document.h"

#include <QString>

#include <map>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QWidget;

namespace viewer
{
/// A row of the option's words, which are the entries' data. The first entry says what holds where
/// the option is not given. `labels`: of words that people read otherwise.
QComboBox* AddChoice(Document* document, QFormLayout* rows, const char* option,
  const QString& first, const QString& help, const std::map<std::string, QString>& labels = {});

/// Shows the option's value, as a new entry where there is none for it. Sends no signal.
void ShowChoice(QComboBox* box, const scene::Settings& settings, const char* option);

/// An option without a value.
QCheckBox* MakeFlag(Document* document, const char* option, QWidget* parent);
void ShowFlag(QCheckBox* box, const scene::Settings& settings, const char* option);

/// The option's one value, or none.
void SetOption(scene::Settings& settings, const char* option, const std::string& value);
}

#endif
