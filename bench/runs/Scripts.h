// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scripts.h
 * @brief Benches that are Python scripts of this folder, run with this build's package.
 */
#ifndef relievoBenchScripts_h
#define relievoBenchScripts_h

#include <string>
#include <variant>
#include <vector>

namespace relievoBench
{
/** Exit status of a script, and of its bench, that needs a package which cannot be imported. */
constexpr int MissingPackage = 3;

/** A place that is known only when a script runs. */
enum class ScriptPlace
{
  Relievo, ///< this program
  Data     ///< the folder of the environment variable RELIEVO_DATA
};

using ScriptWord = std::variant<std::string, ScriptPlace>;

/** Words that each script is given at its end. */
void SetScriptWords(const std::vector<std::string>& words);

/** Whether these words request the help of the script, which then measures nothing. */
bool IsScriptHelp();

/** Returns why a script cannot run here, as "there is no ...", or an empty string. */
std::string FindWhyNot(const std::string& script);

/**
 * Runs a script of this folder. `table`: the file for the standard output, which replaces an older
 * one only if the script succeeds; empty: shown. `quick`: words that are added if rounds are
 * limited (Rounds.h). If the script words request its help, that is shown. Returns 0 when done;
 * MissingPackage or, for any other failure, 1, with a message.
 */
int RunScript(const std::string& script, const std::vector<ScriptWord>& given,
  const std::string& table, const std::vector<std::string>& quick);
}

#endif
