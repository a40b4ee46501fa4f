// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From where a prop is seen. VTK's eye space has the camera at its origin, but in stereo, off axis
// and in sheared views the eye is elsewhere, and only the projection knows.
#ifndef vtkRelievoMaterialEye_h
#define vtkRelievoMaterialEye_h

class vtkProp;
class vtkRenderer;
class vtkShaderProgram;

namespace vtkRelievoMaterialEye
{
// The renderer in whose window, the current one, a prop is being drawn, or nullptr.
vtkRenderer* FindRenderer(vtkProp* prop);

// The uniforms of shaders/material/eye.glsl; without a renderer the eye is at the camera.
void SetParameters(vtkShaderProgram* program, vtkRenderer* renderer);
}

#endif
