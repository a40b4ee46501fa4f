// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileBytes.h
 * @brief Whole files as text, to change and to write elsewhere.
 */
#ifndef FileBytes_h
#define FileBytes_h

#include <fstream>
#include <sstream>
#include <string>

namespace relievoTest
{
inline std::string Load(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void Store(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}
}

#endif
