// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Words of Python.
 */
#ifndef PythonWords_h
#define PythonWords_h

#include <string>

namespace viewer
{
/// The text as a Python string. Throws cli::WorkError for bytes that are not UTF-8.
std::string Quote(const std::string& text);

/// The text, of any encoding, as Python bytes.
std::string QuoteBytes(const std::string& text);

/// "x, y, z".
std::string WriteThree(const double* values);

/// The class that reads a file of data. Throws cli::WorkError for one that the program cannot name.
const char* GetReader(const std::string& path);

/// Throws cli::WorkError: this cannot be said in Python.
[[noreturn]] void RefusePython(const std::string& what);
}

#endif
