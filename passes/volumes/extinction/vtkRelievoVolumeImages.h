// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The images that a volume's mapper draws, and their samples.
#ifndef vtkRelievoVolumeImages_h
#define vtkRelievoVolumeImages_h

#include <glm/mat4x4.hpp>

#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkDataArray;
class vtkDataObject;
class vtkImageData;
class vtkVolume;
class vtkVolumeMapper;

namespace vtkRelievoVolumeImages
{
// The images among the data; `others`: whether there are data of other types.
std::vector<vtkImageData*> Find(vtkDataObject* data, bool& others);

// The values that the mapper draws; `cells`: whether they belong to cells.
vtkDataArray* GetScalars(vtkVolumeMapper* mapper, vtkImageData* image, int& cells);

// Whether the mapper draws without VTK's shader.
bool IsDrawnOnProcessor(vtkAbstractVolumeMapper* mapper);

// The part of vectors that a mapper draws: their component, or one of these.
constexpr int Everything = -1;
constexpr int Magnitude = -2;
int GetVectorPart(vtkVolumeMapper* mapper, vtkDataArray* values);

// The reason why VTK leaves an image of these values out, or "".
std::string FindWhyNotDrawn(
  vtkVolume* volume, vtkImageData* image, vtkDataArray* values, bool cells);

// VTK's shader looks values of 8 and 16 bits up in transfer functions as if they were larger by
// this factor: it divides them by their number of values (vtkVolumeTexture::GetScaleAndBias),
// OpenGL by the greatest value.
double GetStretch(vtkDataArray* values);

// From indices of samples, which are points or the centres of cells; and their number.
glm::dmat4 GetIndexToData(vtkImageData* image, bool cells, int size[3]);
}

#endif
