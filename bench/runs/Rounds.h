// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Rounds.h
 * @brief Limits the rounds of benches, for a quick first run.
 */
#ifndef relievoBenchRounds_h
#define relievoBenchRounds_h

namespace relievoBench
{
/** The maximum number of timed rounds; 0, the default: as many as the bench asks for. */
void SetMostRounds(int rounds);

/** The number of rounds to run out of those asked for. */
int GetRounds(int asked);

/** The number of unmeasured rounds before them: at most one if rounds are limited. */
int GetWarmUp(int asked);
}

#endif
