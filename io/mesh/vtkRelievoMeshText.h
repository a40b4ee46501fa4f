// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the mesh readers: the whole text of a file, and the reason for refusing one.
#ifndef vtkRelievoMeshText_h
#define vtkRelievoMeshText_h

#include <functional>
#include <optional>
#include <string>

namespace relievo
{
// The problem of a file, and the error code. Never leaves the readers.
struct Refusal
{
  unsigned long Code; // of vtkErrorCode
  std::string Text;
};

// The bytes of a file. Throws Refusal.
std::string LoadMeshText(const char* fileName);

// Reads a file. The reason for refusing it, also one of memory; empty: it was read.
std::optional<Refusal> FindRefusal(const std::function<void()>& read);
}

#endif
