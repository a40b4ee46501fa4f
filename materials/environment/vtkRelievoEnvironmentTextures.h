// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The textures of an environment's images, in each window that draws with them, and the uniforms of
// environment/lookup.glsl.
#ifndef vtkRelievoEnvironmentTextures_h
#define vtkRelievoEnvironmentTextures_h

#include "vtkMultiBlockDataSet.h"
#include "vtkRelievoEnvironmentImages.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRelievoEnvironment;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoEnvironmentTextures
{
public:
  // The structure for which shaders are compiled.
  struct Structure
  {
    int Projection = 0; // 0: there is no image
    bool Rough = false;
    bool Irradiance = false;
    bool Encoded = false;

    bool operator==(const Structure& other) const
    {
      return this->Projection == other.Projection && this->Rough == other.Rough &&
        this->Irradiance == other.Irradiance && this->Encoded == other.Encoded;
    }
    std::string GetDefines() const;
  };

  static vtkRelievoEnvironmentTextures& Of(vtkRelievoEnvironment* environment);

  explicit vtkRelievoEnvironmentTextures(vtkRelievoEnvironment* owner);
  ~vtkRelievoEnvironmentTextures();

  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkMultiBlockDataSet> Levels;
  vtkSmartPointer<vtkDataArray> Coefficients;
  int Projection = 0; // of the image; 0: by its size
  bool SRGB = false;
  vtkTimeStamp ChangeTime; // of the selection of images and their settings

  // Checks changed images; reports an error once.
  const Structure& GetStructure();

  // Binds the textures to units until Deactivate(), and sets the uniforms of
  // environment/lookup.glsl. Makes the textures if necessary. False if there are none.
  bool Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, double roughness);
  void Deactivate(vtkOpenGLRenderWindow* window);

  vtkIdType GetBytes();
  void Release(vtkWindow* window);

private:
  struct Cached
  {
    vtkWeakPointer<vtkOpenGLRenderWindow> Window;
    vtkSmartPointer<vtkTextureObject> Image;
    vtkSmartPointer<vtkTextureObject> Levels;
    double Detail = 1.0;
    vtkMTimeType Time = 0;
    vtkIdType Bytes = 0;

    // A finalized window has freed its textures.
    bool IsLost() const
    {
      return (this->Image && !this->Image->GetHandle()) ||
        (this->Levels && !this->Levels->GetHandle());
    }
  };

  vtkMTimeType GetImagesTime() const;
  vtkImageData* GetSharp() const;
  vtkImageData* GetLevel(unsigned int level) const;
  bool CheckLevels(std::string& failure) const;
  bool Load(Cached& cached);
  bool LoadLevels(Cached& cached);
  void Fail(const std::string& failure);

  vtkRelievoEnvironment* Owner;
  Structure Is;
  vtkMTimeType LookTime = 0;
  std::vector<Cached> All;
};

#endif
