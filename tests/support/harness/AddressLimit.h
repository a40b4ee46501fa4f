// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AddressLimit.h
 * @brief Leaves a test little memory.
 */
#ifndef relievoTestAddressLimit_h
#define relievoTestAddressLimit_h

namespace relievoTest
{
/**
 * Limits the addresses of this process to those that it has and `bytes` more, from construction
 * until its end. Linux only: elsewhere nothing is limited.
 */
class AddressLimit
{
public:
  /**
   * Whether memory can be allocated under a limit. With AddressSanitizer each allocation takes
   * addresses besides its own, and a failed one ends the process.
   */
  static const bool IsUsable;

  explicit AddressLimit(double bytes);
  ~AddressLimit();

  AddressLimit(const AddressLimit&) = delete;
  void operator=(const AddressLimit&) = delete;

private:
  unsigned long long Before = 0;
};
}

#endif
