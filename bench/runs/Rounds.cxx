// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rounds.h"

#include <algorithm>

namespace relievoBench
{
namespace
{
int MostRounds = 0;
}

//------------------------------------------------------------------------------
void SetMostRounds(int rounds)
{
  MostRounds = rounds;
}

//------------------------------------------------------------------------------
int GetRounds(int asked)
{
  return MostRounds > 0 ? std::min(asked, MostRounds) : asked;
}

//------------------------------------------------------------------------------
int GetWarmUp(int asked)
{
  return MostRounds > 0 ? std::min(asked, 1) : asked;
}
}
