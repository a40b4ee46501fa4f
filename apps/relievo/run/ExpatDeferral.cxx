// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lets VTK before 9.3.1 read its own XML files with appended data with a newer expat.
//
// Expat 2.6 (and 2.5 with Debian 12's security patch, 2.5.0-1+deb12u2) defers parsing until a token
// is complete or its buffer has doubled. VTK's reader expects each piece to be parsed at once: it
// ends the document by hand where the appended bytes begin, learns of that end too late, and passes
// the bytes to expat, which reports "junk after document element". Newer VTK disables the deferral
// by XML_SetReparseDeferralEnabled(); this file does so for older VTK, by overriding expat's
// XML_ParserCreate for the whole process. If VTK or expat do not need this, or VTK contains its own
// expat with other names, it changes nothing.

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
