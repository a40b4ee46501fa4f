// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scripts.h
 * @brief Benches that are Python scripts of this folder, run with this build's package.
 */
#ifndef relievoBenchScripts_h
#define relievoBenchScripts_h

#include <string>
#include <vector>

namespace relievoBench
{
/** Words that each script is given at its end. */
void SetScriptWords(const std::vector<std::string>& words);

/** Returns why a script cannot run here, as "there is no ...", or an empty string. */
std::string FindWhyNot(const std::string& script);

/**
 * Runs a script of this folder. RELIEVO among the words stands for this program, DATA for the
 * folder of the environment variable RELIEVO_DATA. `table`: the file for the standard output, or
 * empty: shown. `quick`: words that are added if rounds are limited (Rounds.h). Returns 0 when
 * done; 1, with a message, if the script cannot run or failed.
 */
int RunScript(const std::string& script, std::vector<std::string> words, const std::string& table,
  const std::vector<std::string>& quick);
}

#endif
