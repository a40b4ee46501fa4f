// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The eye of a prop's view. The origin of VTK's eye space is the camera, but in stereo, off-axis
// and sheared views the eye is elsewhere, and only the projection determines it.
#ifndef vtkRelievoMaterialEye_h
#define vtkRelievoMaterialEye_h

class vtkProp;
class vtkRenderer;
class vtkShaderProgram;

namespace vtkRelievoMaterialEye
{
// The renderer in the current window that is drawing the prop, or nullptr.
vtkRenderer* FindRenderer(vtkProp* prop);

// The uniforms of shaders/material/eye.glsl; without a renderer the eye is at the camera.
void SetParameters(vtkShaderProgram* program, vtkRenderer* renderer);
}

#endif
