// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Codes passed from C++ to shaders, as macros because of #if, for C++ as well. static_assert
// compares them with the enumerations of public headers, which must not include this file.

#ifndef RELIEVO_CODES
#define RELIEVO_CODES

// RELIEVO_NORMAL_FORMAT: vtkRelievoLayersStage::NormalFormats, AUTO resolved
#define RELIEVO_NORMAL_FLOAT32 1
#define RELIEVO_NORMAL_FLOAT16 2
#define RELIEVO_NORMAL_OCT16 3
#define RELIEVO_NORMAL_OCT16_PRECISE 4
#define RELIEVO_NORMAL_OCT8 5
#define RELIEVO_NORMAL_OCT8_PRECISE 6
#define RELIEVO_NORMAL_RGB10A2 7
#define RELIEVO_NORMAL_RGB8 8

// RELIEVO_DEPTH_FORMAT: vtkRelievoLayersStage::DepthFormats
#define RELIEVO_DEPTH_32F 0
#define RELIEVO_DEPTH_16F 1
#define RELIEVO_DEPTH_WINDOW_Z24 2
#define RELIEVO_DEPTH_REVERSED_32F 3

// RELIEVO_NORMAL_DEPTH_FORMAT: vtkRelievoLayersStage::NormalDepthFormats
#define RELIEVO_NORMAL_DEPTH_SEPARATE 0
#define RELIEVO_NORMAL_DEPTH_RGBA8 1
#define RELIEVO_NORMAL_DEPTH_RGBA16F 2
#define RELIEVO_NORMAL_DEPTH_RGBA32F 3

// RELIEVO_PRIMITIVE_SOURCE: the source of a fragment's primitive word
#define RELIEVO_PRIMITIVE_OF_MESH 0
#define RELIEVO_PRIMITIVE_OF_GLYPHS 1 // the glyph's instance
#define RELIEVO_PRIMITIVE_NONE 2
#define RELIEVO_PRIMITIVE_OF_POINTS 3 // a sphere or a stick at every point

// Lighting model of a surface
#define RELIEVO_SHADING_NONE 0
#define RELIEVO_SHADING_PHONG 1 // including VTK's flat and Gouraud shading
#define RELIEVO_SHADING_PBR 2

// RELIEVO_METHOD: vtkRelievoMaterial::Methods
#define RELIEVO_METHOD_OFF 0
#define RELIEVO_METHOD_PARALLAX 1
#define RELIEVO_METHOD_STEEP 2
#define RELIEVO_METHOD_OCCLUSION 3
#define RELIEVO_METHOD_RELIEF 4

// RELIEVO_ENVIRONMENT: vtkRelievoEnvironment::ProjectionType, AUTO resolved
#define RELIEVO_ENVIRONMENT_EQUIRECTANGULAR 1
#define RELIEVO_ENVIRONMENT_CUBE 2
#define RELIEVO_ENVIRONMENT_SPHERE_MAP 3

#endif
