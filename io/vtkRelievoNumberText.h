// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers in files as other programs write them.
#ifndef vtkRelievoNumberText_h
#define vtkRelievoNumberText_h

#include <charconv>
#include <string_view>
#include <system_error>
#include <type_traits>

// Like std::from_chars, but also with a leading plus; numbers too small for their type are zero
// instead of out of range.
template <typename Number>
std::from_chars_result vtkRelievoReadNumber(const char* first, const char* last, Number& value)
{
  const bool plus = last - first > 1 && *first == '+' && first[1] != '-';
  std::from_chars_result result = std::from_chars(first + (plus ? 1 : 0), last, value);
  if (std::is_floating_point<Number>::value && result.ec == std::errc::result_out_of_range)
  {
    const std::string_view number(first, static_cast<std::size_t>(result.ptr - first));
    const std::size_t exponent = number.find_first_of("eE");
    if (exponent != std::string_view::npos && number.find('-', exponent) == exponent + 1)
    {
      value = Number();
      result.ec = std::errc();
    }
  }
  return result;
}

#endif
