// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An image as a texture for shaders: unchanged values (integers scaled to 0 .. 1), with mipmaps, in
// the image's precision.
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

  // Least and greatest known value of the first component; 0 and 1 for integers, which shaders
  // scale.
  void GetRange(double range[2]) const;

  // Name of the map in messages.
  const char* GetName() const { return this->Name; }

  // Whether the present image can be a map; checked anew, since it may be changed in place.
  bool IsUsable() const { return this->Image && this->GetFault().empty(); }

  // The reason why the image cannot be a map, once until it changes; else an empty string.
  std::string TakeFault();

  // Makes the texture, if the image, the window or `repeat` has changed. `remark` receives a
  // message about changes to the values. False if there is no texture. Only for a usable image.
  bool Load(vtkOpenGLRenderWindow* window, bool repeat, std::string& remark);

  // Binds the texture to a unit until Deactivate().
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
  vtkMTimeType FailTime = 0; // of the image that failed as a texture
  vtkSmartPointer<vtkImageData> Image;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkMTimeType LoadTime = 0;
  bool Repeat = true;
  int Size[2] = { 0, 0 };
  vtkIdType Bytes = 0;
};

#endif
