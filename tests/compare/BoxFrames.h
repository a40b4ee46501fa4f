// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxFrames.h
 * @brief Draws boxes by rays in double precision, with all layers and records, for known changes.
 */
#ifndef BoxFrames_h
#define BoxFrames_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace compareTest
{
using Vector = std::array<double, 3>;

struct Box
{
  std::string Name;
  Vector Center, HalfSize;
  Vector Color = { 0.5, 0.5, 0.5 }; ///< in levels of 255, 0 to 1
  Vector MovedBy = { 0., 0., 0. };  ///< translation in the actor's matrix
  bool Visible = true;
  bool Translucent = false; ///< in the record, and in no layer
  double Specular = 0.0;
  std::string Mesh = {};   ///< check sum of the points; empty: derived from the size
  double Value = 1.0;      ///< of the array `pressure`
  std::string Cells = "6"; ///< count and check sum of the cells
  double PointSize = 1.0;
  std::string More = {}; ///< further entries of the record: `, "color": [1, 0, 0]`
};

struct Lamp
{
  std::string Name;
  Vector Direction; ///< towards the sun
  double Intensity = 1.0;
};

struct Boxes
{
  int Width = 160, Height = 120;
  Vector Eye = { 3.0, 4.0, 8.0 };
  double ViewAngle = 30.0;
  std::vector<Box> All;
  std::vector<Lamp> Lamps;
  std::vector<std::string> Overlays, Volumes, Settings = { "background=0 0 0" };
  bool HasRecord = true;
};

/** Makes a wheel, a helmet and a cup on a floor, lit by two suns. */
Boxes MakeBoxes();

/** Draws the layers color, depth, normal, albedo, actor, block, cell, pressure and shadow_N. */
vtkSmartPointer<vtkImageData> Draw(const Boxes& boxes);

/** Counts pixels with a difference in any common array. */
std::size_t CountDifferent(vtkImageData* a, vtkImageData* b);

/** Sets all components of an array in a rectangle of pixels. */
void Fill(vtkImageData* image, const char* array, int x0, int x1, int y0, int y1, double value);
}

#endif
