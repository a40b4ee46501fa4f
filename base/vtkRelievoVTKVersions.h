// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Differences between the versions of VTK that Relievo builds on (9.1 to 9.7). Code tests these
// names; version numbers are compared only here.
#ifndef vtkRelievoVTKVersions_h
#define vtkRelievoVTKVersions_h

#include "vtkVersionMacros.h"

// Shaders look up environment cubes with inverted z; in 9.1 by the world's directions.
#if VTK_VERSION_NUMBER > VTK_VERSION_CHECK(9, 1, 0)
#define RELIEVO_VTK_MIRRORED_CUBES true
#else
#define RELIEVO_VTK_MIRRORED_CUBES false
#endif

// The shader of edges as tubes does not compile without a light.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#define RELIEVO_VTK_TUBES_NEED_LIGHT 1
#endif

// PBR shading takes a surface's opacity only from its texture, if it has one.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#define RELIEVO_VTK_PBR_OPACITY_OF_TEXTURES 1
#endif

// PBR shading takes colours of points and cells as sRGB; before, as linear.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#define RELIEVO_VTK_PBR_SRGB_VERTEX_COLORS true
#else
#define RELIEVO_VTK_PBR_SRGB_VERTEX_COLORS false
#endif

// Blocks of composite data are drawn by vtkCompositeMapperHelper2, one for each kind of block;
// since 9.3 by vtkOpenGLBatchedPolyDataMapper.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#define RELIEVO_VTK_COMPOSITE_HELPERS 1
#endif

// vtkOrderIndependentTranslucentPass blends a transmittance into alpha; since 9.3 an opacity.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#define RELIEVO_VTK_AVERAGED_TRANSMITTANCE 1
#endif

// The renderer stores the props of a frame in a std::vector instead of an array and a count.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#define RELIEVO_VTK_PROP_VECTOR 1
#endif

// OpenGL's functions are loaded by glad; before by GLEW, which leaves those of OpenGL 1.1 to the
// linker.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define RELIEVO_VTK_GLAD 1
#endif

// If neither X nor EGL opens a window, VTK uses OSMesa, whose library it loads at run time; before,
// VTK was built for one kind of window.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define RELIEVO_VTK_LOADS_OSMESA 1
#endif

// vtkGLTFReader::GetTexture returns a texture as an object; before, GetGLTFTexture returned a
// struct.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define RELIEVO_VTK_GLTF_TEXTURE_OBJECTS 1
#endif

// Polygons of five or more corners are cut by ear clipping; before, all were cut into fans.
// Triangles with two corners at one position are drawn; before, they were left out.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#define RELIEVO_VTK_EAR_CLIPPING 1
#endif

// If some lights are lamps, PBR treats a sun among them as a lamp at its position.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 5, 0)
#define RELIEVO_VTK_PBR_SUNS_AT_PLACES 1
#endif

// vtkAlgorithm::CheckAbort() tells whether the filter or an upstream one has to stop, and informs
// downstream filters.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230101)
#define RELIEVO_VTK_CHECK_ABORT 1
#endif

// Faces of polyhedra are in cell arrays, GetPolyhedronFaces() and GetPolyhedronFaceLocations().
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define RELIEVO_VTK_POLYHEDRON_CELL_ARRAYS 1
#endif

// vtkPolygon::Triangulate(ids) is called TriangulateLocalIds(0, ids).
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define RELIEVO_VTK_TRIANGULATE_LOCAL_IDS 1
#endif

// The shader of lines wider than 1 turns normals to the eye, and is kept for all actors of a
// mapper.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#define RELIEVO_VTK_WIDE_LINE_NORMALS true
#else
#define RELIEVO_VTK_WIDE_LINE_NORMALS false
#endif

// vtkAbstractArray::Allocate(values) is called ReserveValues.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#define RELIEVO_VTK_RESERVE 1
#endif

// Gradients behind the scene have noise of one level, which differs between parts of a picture.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define RELIEVO_VTK_GRADIENT_NOISE 1
#endif

// Texts have the size of the whole picture in windows that draw its tiles.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
#define RELIEVO_VTK_MAGNIFIED_TEXTS true
#else
#define RELIEVO_VTK_MAGNIFIED_TEXTS false
#endif

// Image readers read bytes in memory from a vtkMemoryResourceStream, not from SetMemoryBuffer.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#define RELIEVO_VTK_IMAGE_STREAMS 1
#endif

// Blocks of composite data have consecutive primitive numbers only if colours of cells or edges are
// looked up by them; before, always.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 1)
#define RELIEVO_VTK_OVERLAPPING_BLOCKS 1
#endif

// The mapper of composite data leaves a texture active.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#define RELIEVO_VTK_LEAKED_TEXTURE_UNITS 1
#endif

// The order of vtkGeometryFilter's polygons depends on the timing of its threads.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#define RELIEVO_VTK_RANDOM_POLYGONS 1
#endif

// Actors may be placed in units of the device or of a room.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
#define RELIEVO_VTK_COORDINATE_SYSTEMS 1
#endif

#endif
