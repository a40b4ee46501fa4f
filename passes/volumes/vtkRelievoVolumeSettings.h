// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mappers of volumes as in a still picture of full quality, during the object's lifetime: with
// the step that does not depend on the time of former draws, for every pixel, to the bound
// framebuffer. Sets VTK's members without Modified(), which would rebuild the mappers' shaders.
#ifndef vtkRelievoVolumeSettings_h
#define vtkRelievoVolumeSettings_h

#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkRenderWindow.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"

#include <functional>
#include <vector>

class vtkRelievoVolumeSettings
{
public:
  vtkRelievoVolumeSettings(const std::vector<vtkVolume*>& volumes, vtkRenderWindow* window)
  {
    // From a rate of 1 on, vtkSmartVolumeMapper lets the time of former draws decide on the step.
    this->Set(Window::Rate(window), 0.0001);
    for (vtkVolume* volume : volumes)
    {
      this->Change(volume->GetMapper());
    }
  }
  ~vtkRelievoVolumeSettings()
  {
    for (auto restore = this->Restores.rbegin(); restore != this->Restores.rend(); ++restore)
    {
      (*restore)();
    }
  }
  vtkRelievoVolumeSettings(const vtkRelievoVolumeSettings&) = delete;
  void operator=(const vtkRelievoVolumeSettings&) = delete;

private:
  void Change(vtkAbstractVolumeMapper* mapper)
  {
    auto* gpu = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper);
    if (auto* smart = vtkSmartVolumeMapper::SafeDownCast(mapper))
    {
      this->Set(Smart::Interactive(smart), 0);
      this->Set(Smart::AutoAdjust(smart), 0);
      gpu = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(Smart::OnGpu(smart));
    }
    if (gpu)
    {
      // Without a measured time, a mapper that adjusts its step takes the one of full quality.
      this->Set(Gpu::Time(gpu), 0.0);
      this->Set(Gpu::Reduction(gpu), 1.0);
      this->Keep(Gpu::BigTime(gpu));
      this->Keep(Gpu::SmallTime(gpu));
      this->Set(Gpu::ImageStep(gpu), 1.0f);
      this->Set(Gpu::ToImage(gpu), 0);
      this->Set(Gpu::DepthPass(gpu), 0);
    }
  }

  struct Window : public vtkRenderWindow
  {
    static double& Rate(vtkRenderWindow* window) { return window->*(&Window::DesiredUpdateRate); }
  };
  struct Smart : public vtkSmartVolumeMapper
  {
    static vtkTypeBool& Interactive(vtkSmartVolumeMapper* mapper)
    {
      return mapper->*(&Smart::InteractiveAdjustSampleDistances);
    }
    static vtkTypeBool& AutoAdjust(vtkSmartVolumeMapper* mapper)
    {
      return mapper->*(&Smart::AutoAdjustSampleDistances);
    }
    static vtkGPUVolumeRayCastMapper* OnGpu(vtkSmartVolumeMapper* mapper)
    {
      return mapper->*(&Smart::GPUMapper);
    }
  };
  struct Gpu : public vtkOpenGLGPUVolumeRayCastMapper
  {
    using Mapper = vtkOpenGLGPUVolumeRayCastMapper;
    static double& Time(Mapper* mapper) { return mapper->*(&Gpu::TimeToDraw); }
    static double& BigTime(Mapper* mapper) { return mapper->*(&Gpu::BigTimeToDraw); }
    static double& SmallTime(Mapper* mapper) { return mapper->*(&Gpu::SmallTimeToDraw); }
    static double& Reduction(Mapper* mapper) { return mapper->*(&Gpu::ReductionFactor); }
    static float& ImageStep(Mapper* mapper) { return mapper->*(&Gpu::ImageSampleDistance); }
    static vtkTypeBool& ToImage(Mapper* mapper) { return mapper->*(&Gpu::RenderToImage); }
    static vtkTypeBool& DepthPass(Mapper* mapper) { return mapper->*(&Gpu::UseDepthPass); }
  };

  template <typename Value>
  void Keep(Value& member)
  {
    this->Restores.push_back([&member, former = member]() { member = former; });
  }
  template <typename Value>
  void Set(Value& member, Value value)
  {
    this->Keep(member);
    member = value;
  }

  std::vector<std::function<void()>> Restores;
};

#endif
