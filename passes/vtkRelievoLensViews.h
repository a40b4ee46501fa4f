// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pictures of pinholes from which a sensor's picture can be put together: where the rays of all
// its pixels pass through planes at distance 1, with enough pixels there.
#ifndef vtkRelievoLensViews_h
#define vtkRelievoLensViews_h

#include <array>
#include <string>
#include <vector>

class vtkRelievoCameraModel;
class vtkRelievoLensCamera;

// A rectangle of a plane at distance 1: x to the right of its axes, y downwards.
struct vtkRelievoLensView
{
  int Face = 0;
  double Low[2], High[2];
  double PixelsPerUnit;
  int Size[2];
};

class vtkRelievoLensViews
{
public:
  using View = vtkRelievoLensView;

  // Plans the views for all rays; returns an error, or "". The pixels of a view are no wider
  // than a pixel of the sensor over `oversampling`.
  std::string Plan(vtkRelievoCameraModel* sensor, double oversampling);

  const std::vector<View>& Get() const { return this->Views; }

  // A pinhole that sees a view.
  void SetCamera(const View& view, vtkRelievoLensCamera* camera) const;

  // Where the sensor's pixel is in the picture of its view: columns from the left, rows from the
  // top, centres at whole numbers. False where it is in another one, or sees nothing.
  bool Find(const View& view, int column, int row, double place[2]) const;

private:
  struct Bounds
  {
    double Low[2], High[2];
    bool IsAny = false;
    void Add(const double place[2]);
  };

  static bool GetFace(const double direction[3], bool single, int& face, double place[2]);
  bool IsWithinOne() const;
  void FindFaces(bool single);
  double GetPixelSide(int face) const;

  vtkRelievoCameraModel* Sensor = nullptr;
  bool Single = false;
  bool IsOnePlace = true;           // all rays begin there
  std::vector<unsigned char> Faces; // of each pixel; 6: it sees nothing
  std::vector<Bounds> FaceBounds;
  std::vector<View> Views;
};

#endif
