// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef relievoTestTextTools_h
#define relievoTestTextTools_h

#include <vtkFreeTypeTools.h>
#include <vtkTextRenderer.h>

namespace relievoTest
{
/**
 * VTK keeps what it draws text with until the process ends. Made before the Session that counts
 * living objects, and released before its Result(), this leaves nothing of it to count.
 */
class TextTools
{
public:
  TextTools() { vtkTextRenderer::GetInstance(); }
  void Release() { vtkFreeTypeTools::SetInstance(nullptr); }
};
}

#endif
