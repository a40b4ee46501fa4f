// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoWrapTexture
 * @brief A texture with separate wrap modes along u and v: repeated, mirrored or clamped.
 *
 * vtkTexture has one Wrap for both. WrapU and WrapV replace it, and Wrap is ignored.
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
  /** Mode outside 0 to 1 of u and v: vtkTexture::Repeat (default), MirroredRepeat, ClampToEdge. */
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
