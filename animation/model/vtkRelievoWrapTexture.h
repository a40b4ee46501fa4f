// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoWrapTexture
 * @brief A texture that repeats, mirrors or extends its edges along u and along v apart.
 *
 * vtkTexture has one Wrap for both. WrapU and WrapV take its place, and Wrap counts for nothing.
 */
#ifndef vtkRelievoWrapTexture_h
#define vtkRelievoWrapTexture_h

#include "vtkOpenGLTexture.h"
#include "vtkRelievoAnimationModule.h" // for the export macro

class VTKRELIEVOANIMATION_EXPORT vtkRelievoWrapTexture : public vtkOpenGLTexture
{
public:
  static vtkRelievoWrapTexture* New();
  vtkTypeMacro(vtkRelievoWrapTexture, vtkOpenGLTexture);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Beyond 0 and 1 of u and of v: vtkTexture::Repeat (default), MirroredRepeat, ClampToEdge. */
  vtkSetClampMacro(WrapU, int, ClampToEdge, MirroredRepeat);
  vtkGetMacro(WrapU, int);
  vtkSetClampMacro(WrapV, int, ClampToEdge, MirroredRepeat);
  vtkGetMacro(WrapV, int);
  ///@}

  void Load(vtkRenderer* renderer) override;

protected:
  vtkRelievoWrapTexture() = default;
  ~vtkRelievoWrapTexture() override = default;

private:
  vtkRelievoWrapTexture(const vtkRelievoWrapTexture&) = delete;
  void operator=(const vtkRelievoWrapTexture&) = delete;

  int WrapU = Repeat;
  int WrapV = Repeat;
};

#endif
