// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Rounds.h
 * @brief How often the benches time what they time: less for a first look.
 */
#ifndef relievoBenchRounds_h
#define relievoBenchRounds_h

namespace relievoBench
{
/** How often anything is timed at most; 0, the default: as often as the bench asks. */
void SetMostRounds(int rounds);

/** So many of the rounds asked for are done. */
int GetRounds(int asked);

/** And of those before them, which do not count: one at most where rounds are limited. */
int GetWarmUp(int asked);
}

#endif
