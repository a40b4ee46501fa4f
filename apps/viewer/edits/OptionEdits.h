// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Controls for one option of the command line. Their object name is the option's, without dashes.
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
struct vtkRelievoOption;

namespace relievoQt
{
class Number;
}

namespace viewer
{
/// A row with a choice among the option's words, stored as the entries' data. The first entry
/// describes the default. `labels`: display texts of words.
QComboBox* AddChoice(Document* document, QFormLayout* rows, const char* option,
  const QString& first, const QString& help, const std::map<std::string, QString>& labels = {});

/// Shows the option's value, as a new entry if needed. Emits no signal.
void ShowChoice(QComboBox* box, const scene::Settings& settings, const char* option);

/// A check box for an option without a value.
QCheckBox* MakeFlag(Document* document, const char* option, QWidget* parent);
void ShowFlag(QCheckBox* box, const scene::Settings& settings, const char* option);

/// A number within the option's bounds; if these are excluded, from a step above to a step below.
relievoQt::Number* MakeNumber(const char* option, double step, int decimals, QWidget* parent);

/// A row with a control for any option, made from its description, which follows the document: a
/// check box, a choice among its words, or a line of text.
void AddOption(Document* document, QFormLayout* rows, const vtkRelievoOption& option);

/// The option's value, or none.
void SetOption(scene::Settings& settings, const char* option, const std::string& value);
}

#endif
