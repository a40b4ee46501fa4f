// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Splices text into the shaders with which VTK's ray casting mapper on the GPU draws volumes:
// vtkOpenGLGPUVolumeRayCastMapper, also inside of other mappers. The spliced shader is
// test-compiled; on an error, the volume is drawn without the text.
//
// Each change of a volume's passes rebuilds its shader; VTK finds the program in its cache.
#ifndef vtkRelievoVolumeSplice_h
#define vtkRelievoVolumeSplice_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoSplicedKeys.h"
#include "vtkRelievoVolumesModule.h" // for the export macro
#include "vtkTimeStamp.h"

#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkVolume;
class vtkVolumeMapper;

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoVolumeSplice : public vtkOpenGLRenderPass
{
public:
  static vtkRelievoVolumeSplice* New();
  vtkTypeMacro(vtkRelievoVolumeSplice, vtkOpenGLRenderPass);

  ///@{
  // The text: Mark marks its places in the fragment shader before VTK replaces its own tags
  // (shaders/raycasterfs.glsl of VTK). Fill fills the marks afterwards, and returns an error
  // message, or an empty string. The mapper is the one that draws, which may be inside the
  // volume's own.
  std::function<void(std::string& fragment)> Mark;
  std::function<std::string(std::string& fragment, vtkVolumeMapper* mapper, vtkVolume* volume)>
    Fill;
  ///@}

  // Sets uniforms of the text, before each draw; VTK sets its own afterwards.
  std::function<void(vtkShaderProgram* program, vtkVolumeMapper* mapper, vtkVolume* volume)> Set;

  // Reports an error of the splice, once for each class of mappers.
  std::function<void(const std::string& message)> Report;

  ///@{
  // Between Begin and End, shaders of these props have the text.
  void Begin(const std::vector<vtkProp*>& props, vtkOpenGLRenderWindow* window);
  void End();
  ///@}

  // Call when the text changes: triggers a rebuild of all shaders.
  void ModifyShaders() { this->ShaderTime.Modified(); }

  // Definitions of names that differ between VTK's versions (shaders/volumes/names.glsl), for this
  // fragment shader; before the text's functions.
  static std::string GetNames(const std::string& fragment);

  // Whether the mapper draws its image in several blocks (SetPartitions), each with texture
  // coordinates of its own.
  static bool HasPartitions(vtkVolumeMapper* mapper);

  void Render(const vtkRenderState*) override {}
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  // Called by VTK's mapper.
  bool PreReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkRelievoVolumeSplice();
  ~vtkRelievoVolumeSplice() override;

private:
  vtkRelievoVolumeSplice(const vtkRelievoVolumeSplice&) = delete;
  void operator=(const vtkRelievoVolumeSplice&) = delete;

  vtkRelievoSplicedKeys Keys;
  vtkOpenGLRenderWindow* Window = nullptr; // between Begin and End
  vtkTimeStamp ShaderTime;
  vtkRelievoReportOnce Reported;
};

#endif
