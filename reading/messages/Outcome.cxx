// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Outcome.h"

#include "Errors.h"
#include "Messages.h"
#include "NumberLocale.h"

#include <exception>
#include <new>

namespace reading
{
//------------------------------------------------------------------------------
Outcome Try(const std::function<void()>& work)
{
  const Messages::Scope scope;
  const NumberLocale locale;
  try
  {
    work();
  }
  catch (const UsageError& error)
  {
    return { Outcome::Usage, error.what() };
  }
  catch (const FileError& error)
  {
    return { Outcome::File, error.what() };
  }
  catch (const std::bad_alloc&)
  {
    return { Outcome::Draw, "out of memory; a smaller --size or fewer --layers need less" };
  }
  catch (const std::exception& error)
  {
    return { Outcome::Draw, error.what() };
  }
  return {};
}
}
