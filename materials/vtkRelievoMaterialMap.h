// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An image as a texture for shaders: its values as they are (scaled to 0 .. 1 for integers), with
// mipmaps, in the precision it has.
#ifndef vtkRelievoMaterialMap_h
#define vtkRelievoMaterialMap_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkRelievoMaterialMap
{
public:
  vtkRelievoMaterialMap(const char* name, int leastComponents)
    : Name(name)
    , LeastComponents(leastComponents)
  {
  }
  ~vtkRelievoMaterialMap();

  void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const { return this->Image; }
  bool IsFloat() const;

  // Least and greatest known value of the first component; 0, 1 for integers, as shaders have them.
  void GetRange(double range[2]) const;

  // What messages call the map.
  const char* GetName() const { return this->Name; }

  // Whether there is an image that can be a map, as it is now: it may be mended or spoilt in place.
  bool IsUsable() const { return this->Image && this->GetFault().empty(); }

  // Why the image cannot be a map, in words, once for as long as it stays so; else nothing.
  std::string TakeFault();

  // Makes the texture, if the image, the window or the choice is another than before. `remark` says
  // what was done otherwise. False: there is no texture. Only of an image that is usable.
  bool Load(vtkOpenGLRenderWindow* window, bool repeat, std::string& remark);

  // Gives the texture a unit until Deactivate().
  int Activate();
  void Deactivate();

  int GetWidth() const { return this->Size[0]; }
  int GetHeight() const { return this->Size[1]; }
  vtkIdType GetBytes() const { return this->IsLoaded() ? this->Bytes : 0; }
  void Release(vtkWindow* window);

private:
  vtkMTimeType GetTime() const;
  std::string GetFault() const;
  bool IsLoaded() const;

  const char* Name;
  int LeastComponents;
  std::string LastFault;
  vtkMTimeType FailTime = 0; // of the image that OpenGL made no texture of
  vtkSmartPointer<vtkImageData> Image;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkMTimeType LoadTime = 0;
  bool Repeat = true;
  int Size[2] = { 0, 0 };
  vtkIdType Bytes = 0;
};

#endif
