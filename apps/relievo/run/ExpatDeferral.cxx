// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lets VTK before 9.3.1 read its own XML files with appended data beside a newer expat.
//
// Expat 2.6 (and 2.5 as Debian 12 mends it for security, 2.5.0-1+deb12u2) puts parsing off until a
// token is whole or its buffer has doubled. VTK's reader expects each piece parsed at once: it ends
// the document by hand where the appended bytes begin, is then told of that end too late, and hands
// the bytes to expat, which calls them "junk after document element". VTK's own cure is to switch
// the putting-off by XML_SetReparseDeferralEnabled(); this does the same for a VTK without it, by
// standing before expat's XML_ParserCreate for the whole process. Where VTK or expat need no cure,
// or VTK carries an expat of its own under other names, it changes nothing.

#include <dlfcn.h>

extern "C" __attribute__((visibility("default"))) void* XML_ParserCreate(const char* encoding)
{
  using Create = void* (*)(const char*);
  using Switch = unsigned char (*)(void*, unsigned char);
  const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "XML_ParserCreate"));
  const auto setDeferral =
    reinterpret_cast<Switch>(dlsym(RTLD_DEFAULT, "XML_SetReparseDeferralEnabled"));
  void* parser = create ? create(encoding) : nullptr;
  if (parser && setDeferral)
  {
    setDeferral(parser, 0);
  }
  return parser;
}
