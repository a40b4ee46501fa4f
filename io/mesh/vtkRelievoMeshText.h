// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What readers of meshes share: the whole text of a file, and why one is refused.
#ifndef vtkRelievoMeshText_h
#define vtkRelievoMeshText_h

#include <string>

namespace relievo
{
// What is wrong with the file, and the kind of error. Does not leave the readers.
struct Refusal
{
  unsigned long Code; // of vtkErrorCode
  std::string Text;
};

// The bytes of a file. Throws Refusal.
std::string LoadMeshText(const char* fileName);
}

#endif
