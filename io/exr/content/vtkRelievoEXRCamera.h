// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRCamera.h
 * @brief The camera of a picture: field data in VTK's convention, standard attributes in OpenEXR's.
 *
 * | field data                 | attributes                                            |
 * |----------------------------|-------------------------------------------------------|
 * | worldToCamera (16 doubles) | worldToCamera (m44f, OpenEXR's convention),           |
 * |                            | relievo:worldToCamera (m44d, the doubles as they are) |
 * | worldToNDC (16 doubles)    | worldToNDC (m44f, OpenEXR's convention),              |
 * |                            | relievo:worldToNDC (m44d, the doubles as they are)    |
 * | near, far (1 double)       | near, far (float), relievo:near, relievo:far (double) |
 * | relievo:origin (3 doubles) | relievo:origin (v3d)                                  |
 *
 * VTK's matrices are stored row by row and multiply column vectors; the camera looks along -z; NDC
 * runs from -1 to 1, y up. OpenEXR's standard attributes multiply row vectors (Imath: p' = p M, the
 * translation is in the last row), have the camera look along +z (left-handed), and NDC from (0, 0)
 * in the upper left corner of the display window to (1, 1) in the lower right one
 * (ImfStandardAttributes.h). The conversion is done here and nowhere else.
 */
#ifndef vtkRelievoEXRCamera_h
#define vtkRelievoEXRCamera_h

#include <OpenEXR/ImfHeader.h>

class vtkFieldData;

namespace relievo::exr
{
/** Adds the camera's attributes; throws Failure if a field array has the wrong size. */
void WriteCamera(vtkFieldData* fields, Imf::Header& header);

/**
 * Adds the camera's field data, from the exact doubles if present, otherwise from the standard
 * attributes.
 */
void ReadCamera(const Imf::Header& header, vtkFieldData* fields);
}

#endif
