// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Access to protected members of VTK's classes that the frame needs. The members are named through
// derived classes that are never instantiated: pointers to members have the base's type, so that
// the compiler checks the access, and a change of VTK breaks the build, not the program.
#ifndef vtkRelievoAccess_h
#define vtkRelievoAccess_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkSmartPointer.h"
#include "vtkStateStorage.h"
#include "vtkTexture.h"

#include <map>
#include <vector>

#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
// VTK 9.1's header of the helper lacks this include.
#include "vtkColor.h"
#include "vtkOpenGLError.h" // for GLenum

#include "vtkCompositeMapperHelper2.h"
#include "vtkCompositePolyDataMapper2.h"
#else
#include "vtkOpenGLBatchedPolyDataMapper.h"
#endif

namespace vtkRelievoAccess
{
class State : public vtkOpenGLState
{
public:
  // The active textures, and their units.
  static const std::map<const vtkTextureObject*, int>& TextureUnits(vtkOpenGLState* state)
  {
    return state->*(&State::TextureResourceIds);
  }
};

class Renderer : public vtkOpenGLRenderer
{
public:
  // Bypasses SetActiveCamera, which would notify observers of a change that users never see.
  static vtkCamera*& CameraInUse(vtkRenderer* ren) { return ren->*(&Renderer::ActiveCamera); }

  // Moves camera lights and head lights to the camera.
  static void FollowCamera(vtkRenderer* ren) { (ren->*(&Renderer::UpdateLightGeometry))(); }

  // VTK's FXAA caches a texture in the format of the first colours.
  static void ForgetColorFormat(vtkOpenGLRenderer* ren)
  {
    if (ren->GetUseFXAA() && ren->*(&Renderer::FXAAFilter))
    {
      (ren->*(&Renderer::FXAAFilter))->ReleaseGraphicsResources();
    }
  }

  // The steps of vtkOpenGLRenderer::DeviceRender without a pass, with these props in place of the
  // renderer's visible, culled, ordered props of this frame.
  static void RenderOwnSteps(vtkOpenGLRenderer* ren, vtkProp** props, int count)
  {
    const Props inUse(ren, props, count);
    (ren->*(&Renderer::UpdateCamera))();
    (ren->*(&Renderer::UpdateLightGeometry))();
    ren->UpdateLights();
    (ren->*(&Renderer::UpdateGeometry))(nullptr);
  }

  // Replaces each of the renderer's props of this frame by what `work` returns for it.
  template <typename Work>
  static void ForProps(vtkRenderer* ren, Work&& work)
  {
#ifdef RELIEVO_VTK_PROP_VECTOR
    for (vtkProp*& prop : ren->*(&Renderer::PropArray))
    {
      prop = work(prop);
    }
#else
    for (int i = 0; i < ren->*(&Renderer::PropArrayCount); ++i)
    {
      (ren->*(&Renderer::PropArray))[i] = work((ren->*(&Renderer::PropArray))[i]);
    }
#endif
  }

  // Replaces the renderer's props of this frame during its lifetime.
  class Props
  {
  public:
    Props(vtkRenderer* ren, vtkProp** props, int count)
      : Owner(ren)
#ifdef RELIEVO_VTK_PROP_VECTOR
      , Previous(props, props + count)
    {
      (ren->*(&Renderer::PropArray)).swap(this->Previous);
    }
    ~Props()
    {
      (this->Owner->*(&Renderer::PropArray)).swap(this->Previous);
    }
#else
      , Previous(ren->*(&Renderer::PropArray))
      , PreviousCount(ren->*(&Renderer::PropArrayCount))
    {
      ren->*(&Renderer::PropArray) = props;
      ren->*(&Renderer::PropArrayCount) = count;
    }
    ~Props()
    {
      this->Owner->*(&Renderer::PropArray) = this->Previous;
      this->Owner->*(&Renderer::PropArrayCount) = this->PreviousCount;
    }
#endif
    Props(const Props&) = delete;
    Props& operator=(const Props&) = delete;

  private:
    vtkRenderer* Owner;
#ifdef RELIEVO_VTK_PROP_VECTOR
    std::vector<vtkProp*> Previous;
#else
    vtkProp** Previous;
    int PreviousCount;
#endif
  };
};

class Camera : public vtkCamera
{
public:
  // Sets the camera's stereo flag, as vtkOpenGLCamera::Render does, but before the first stage
  // reads matrices: VTK caches those until the camera is modified, and Render does not modify it.
  static void SetStereo(vtkCamera* camera, int stereo)
  {
    int& own = camera->*(&Camera::Stereo);
    if (own != stereo)
    {
      own = stereo;
      camera->Modified();
    }
  }

  // Another projection during its lifetime, without notifying observers, which would take it for a
  // moving camera.
  class Projection
  {
  public:
    Projection(vtkCamera* camera, vtkMatrix4x4* matrix)
      : Owner(camera)
      , Matrix(matrix)
      , Previous(camera->*(&Camera::ExplicitProjectionTransformMatrix))
      , Used(camera->GetUseExplicitProjectionTransformMatrix())
    {
      this->Set(matrix, true);
    }
    ~Projection() { this->Set(this->Previous, this->Used); }
    Projection(const Projection&) = delete;
    Projection& operator=(const Projection&) = delete;

  private:
    // VTK caches matrices for the last renderer that asked.
    class Keys : public vtkOpenGLCamera
    {
    public:
      static void Forget(vtkOpenGLCamera* camera) { camera->*(&Keys::LastRenderer) = nullptr; }
    };

    void Set(vtkMatrix4x4* matrix, bool use)
    {
      this->Owner->*(&Camera::ExplicitProjectionTransformMatrix) = matrix;
      this->Owner->*(&Camera::UseExplicitProjectionTransformMatrix) = use;
      if (auto* camera = vtkOpenGLCamera::SafeDownCast(this->Owner))
      {
        Keys::Forget(camera);
      }
    }

    vtkCamera* Owner;
    vtkSmartPointer<vtkMatrix4x4> Matrix;
    vtkMatrix4x4* Previous;
    bool Used;
  };
};

class Mapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkOpenGLCellToVTKCellMap* CellMap(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&Mapper::CellCellMap);
  }

  // Number of the first primitive of the kind drawn now.
  static vtkIdType PrimitiveOffset(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&Mapper::PrimitiveIDOffset);
  }

  static vtkOpenGLVertexBufferObjectGroup* Buffers(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&Mapper::VBOs);
  }
  static vtkMTimeType BuildTime(vtkOpenGLPolyDataMapper* mapper)
  {
    return (mapper->*(&Mapper::VBOBuildTime)).GetMTime();
  }
  // Whether the buffers were built for this actor's present property, input and texture: the check
  // of GetNeedToRebuildBufferObjects, without its side effect of marking them as rebuilt.
  static bool AreBuffersOf(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
  {
    vtkStateStorage state;
    state.Append(actor->GetProperty()->GetMTime(), "actor mtime");
    state.Append(mapper->CurrentInput ? mapper->CurrentInput->GetMTime() : 0, "input mtime");
    state.Append(actor->GetTexture() ? actor->GetTexture()->GetMTime() : 0, "texture mtime");
    return !(mapper->*(&Mapper::VBOBuildState) != state);
  }
  // Fills the buffers as drawing does, without drawing. The mapper's input must be up to date, and
  // drawing must follow: it has the window release the buffers.
  static void Build(vtkOpenGLPolyDataMapper* mapper, vtkRenderer* ren, vtkActor* actor)
  {
    mapper->CurrentInput = mapper->GetInput();
    (mapper->*(&Mapper::UpdateCameraShiftScale))(ren, actor);
    (mapper->*(&Mapper::UpdateBufferObjects))(ren, actor);
  }
  // Transform of the coordinates in the buffer, transposed.
  static vtkMatrix4x4* ShiftScale(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&Mapper::VBOShiftScale);
  }
  static vtkOpenGLIndexBufferObject* Indices(vtkOpenGLPolyDataMapper* mapper, int type)
  {
    return (mapper->*(&Mapper::Primitives))[type].IBO;
  }
  // May be replaced for a time; must be restored.
  static vtkOpenGLIndexBufferObject*& IndicesInUse(vtkOpenGLPolyDataMapper* mapper, int type)
  {
    return (mapper->*(&Mapper::Primitives))[type].IBO;
  }
  // Of the last drawing; nullptr before the first.
  static vtkShaderProgram* Program(vtkOpenGLPolyDataMapper* mapper, int type)
  {
    return (mapper->*(&Mapper::Primitives))[type].Program;
  }
  static int IndexCount(vtkOpenGLPolyDataMapper* mapper, int type)
  {
    return static_cast<int>(Indices(mapper, type)->IndexCount);
  }

  // Whether cells have their own colours, which VTK looks up by a primitive's number.
  static bool HasCellColors(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&Mapper::HaveCellScalars);
  }

  // One of the mapper's PrimitiveTypes; PrimitiveEnd if none is bound.
  static int BoundPrimitiveType(vtkOpenGLPolyDataMapper* mapper)
  {
    vtkOpenGLHelper* bound = mapper->*(&Mapper::LastBoundBO);
    return bound ? bound->PrimitiveType : static_cast<int>(PrimitiveEnd);
  }
  // Whether triangles are drawn now, not points or lines.
  static bool DrawsTriangles(vtkOpenGLPolyDataMapper* mapper)
  {
    const int type = BoundPrimitiveType(mapper);
    return type == PrimitiveTris || type == PrimitiveTriStrips;
  }
};

// One block of composite data, and the numbering of its primitives.
struct Block
{
  vtkPolyData* Mesh;
  vtkOpenGLCellToVTKCellMap* Map;
  int FlatIndex;
};

#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
class CompositeHelper : public vtkCompositeMapperHelper2
{
public:
  static bool Draws(vtkOpenGLPolyDataMapper* mapper)
  {
    return vtkCompositeMapperHelper2::SafeDownCast(mapper) != nullptr;
  }
  static std::vector<Block> GetBlocks(vtkOpenGLPolyDataMapper* mapper)
  {
    std::vector<Block> blocks;
    for (const auto& block : Blocks(vtkCompositeMapperHelper2::SafeDownCast(mapper)))
    {
      blocks.push_back(
        { block.first, block.second->CellCellMap, static_cast<int>(block.second->FlatIndex) });
    }
    return blocks;
  }
  // Whether the primitives have VTK's own numbers, which its shaders use for look-ups: always.
  static bool NumbersPrimitives(vtkOpenGLPolyDataMapper*) { return true; }

  static const std::map<vtkPolyData*, vtkCompositeMapperHelperData*>& Blocks(
    vtkCompositeMapperHelper2* helper)
  {
    return helper->*(&CompositeHelper::Data);
  }
  // Whether the buffers were built for this actor's present property and texture, and for all
  // blocks.
  static bool AreBuffersOf(vtkCompositeMapperHelper2* helper, vtkActor* actor)
  {
    vtkStateStorage state;
    state.Append(actor->GetProperty()->GetMTime(), "actor mtime");
    for (const auto& block : Blocks(helper))
    {
      state.Append(block.first ? block.first->GetMTime() : 0, "input mtime");
    }
    state.Append(actor->GetTexture() ? actor->GetTexture()->GetMTime() : 0, "texture mtime");
    return !(helper->*(&CompositeHelper::VBOBuildState) != state);
  }
};

class CompositeMapper : public vtkCompositePolyDataMapper2
{
public:
  static const std::map<const std::string, vtkCompositeMapperHelper2*>& GetHelpers(
    vtkCompositePolyDataMapper2* mapper)
  {
    return mapper->*(&CompositeMapper::Helpers);
  }
  // Whether the helpers have this actor's present blocks and their attributes.
  static bool AreHelpersOf(vtkCompositePolyDataMapper2* mapper, vtkActor* actor)
  {
    const vtkTimeStamp& sorted = mapper->*(&CompositeMapper::HelperMTime);
    vtkDataObject* input = mapper->GetInputDataObject(0, 0);
    vtkStateStorage state;
    state.Append(actor->GetProperty()->GetMTime(), "actor mtime");
    state.Append(mapper->GetMTime(), "this mtime");
    state.Append(sorted, "helper mtime");
    state.Append(actor->GetTexture() ? actor->GetTexture()->GetMTime() : 0, "texture mtime");
    return input && sorted.GetMTime() >= input->GetMTime() &&
      sorted.GetMTime() >= mapper->GetMTime() &&
      !(mapper->*(&CompositeMapper::RenderValuesState) != state);
  }
};
#else
class CompositeHelper : public vtkOpenGLBatchedPolyDataMapper
{
public:
  static bool Draws(vtkOpenGLPolyDataMapper* mapper)
  {
    return vtkOpenGLBatchedPolyDataMapper::SafeDownCast(mapper) != nullptr;
  }
  static std::vector<Block> GetBlocks(vtkOpenGLPolyDataMapper* mapper)
  {
    std::vector<Block> blocks;
    auto* batch = vtkOpenGLBatchedPolyDataMapper::SafeDownCast(mapper);
    for (const auto& block : batch->*(&CompositeHelper::VTKPolyDataToGLBatchElement))
    {
      blocks.push_back({ block.second->Parent.PolyData, block.second->CellCellMap,
        static_cast<int>(block.second->Parent.FlatIndex) });
    }
    return blocks;
  }
  // Whether VTK's own shaders look up colours, normals or edges by a primitive's number.
  static bool NumbersPrimitives(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&CompositeHelper::HaveCellScalars) ||
      mapper->*(&CompositeHelper::HaveCellNormals) ||
      !(mapper->*(&CompositeHelper::EdgeValues)).empty();
  }
};
#endif
}

#endif
