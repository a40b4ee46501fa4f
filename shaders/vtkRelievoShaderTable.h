// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRelievoShaderTable_h
#define vtkRelievoShaderTable_h

struct vtkRelievoShaderTableEntry
{
  const char* Name;
  const char* Text;
};

// Ends with an entry of null pointers.
extern const vtkRelievoShaderTableEntry vtkRelievoShaderTable[];

#endif
