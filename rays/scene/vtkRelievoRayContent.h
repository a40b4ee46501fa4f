// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The meshes that rays can hit: of a renderer's props, and of data.
#ifndef vtkRelievoRayContent_h
#define vtkRelievoRayContent_h

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoPlacedMesh.h"
#include "vtkRelievoRaySource.h"
#include "vtkRelievoWorldCopies.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkRelievoRayContent
{
public:
  // An entry of AddData.
  struct Added
  {
    vtkSmartPointer<vtkDataObject> Data;
    vtkSmartPointer<vtkMatrix4x4> Matrix;
  };

  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<Added> Data;
  std::vector<vtkRelievoPlacedMesh> Meshes;
  std::vector<vtkRelievoRaySource> Sources;        // one for each of Meshes
  std::vector<vtkSmartPointer<vtkPolyData>> Owned; // references to all of Meshes
  std::vector<vtkSmartPointer<vtkProp>> LeftOut;
  std::string Fault; // of Data

  // Lists the meshes of the renderer and the data; `pointIds`: name of an array, or none. Those of
  // the last list live until Release().
  void Collect(const char* pointIds);
  void Release() { this->OwnedBefore.clear(); }

  void RemoveData();
  bool HasIds() const;

private:
  // The outer surface of data other than vtkPolyData.
  struct Surface
  {
    vtkWeakPointer<vtkDataSet> Data;
    vtkMTimeType Time = 0;
    vtkSmartPointer<vtkPolyData> Mesh;
  };

  std::map<vtkDataSet*, Surface> Surfaces; // of Data
  vtkRelievoWorldCopies Copies;
  vtkRelievoGlyphPlaces Glyphs{ vtkRelievoGlyphPlaces::Numbers::Exact };
  std::vector<vtkSmartPointer<vtkPolyData>> OwnedBefore; // until the trees have new meshes

  static void FindNormals(vtkPolyData* mesh, vtkRelievoRaySource& source);
  void AddProps();
  void AddActors(vtkProp* prop, std::map<vtkProp*, int>& numbers);
  void AddAdded();
  std::string AddBlock(vtkDataObject* data, int block, int prop, vtkMatrix4x4* matrix);
  void TakeIds(const char* name);
};

#endif
