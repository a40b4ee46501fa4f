// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCutoff.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkRelievoCutSurface.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"

using namespace vtkRelievoSpliceText;

namespace
{
const char* const Defines = "//RELIEVO::Cutoff::Defines";
const char* const Dec = "//RELIEVO::Cutoff::Dec";
const char* const Impl = "//RELIEVO::Cutoff::Impl";

std::string Section(const char* section)
{
  return vtkRelievoShaderLibrary::GetSection("material/cutoff.glsl", section);
}

// Whether the actor was forced to be opaque before it got a cutoff.
vtkInformationIntegerKey* Before()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("BEFORE", "vtkRelievoCutoff");
  return key;
}
}

//------------------------------------------------------------------------------
void vtkRelievoCutoff::Mark(std::string& fragment)
{
  MarkBehind(fragment, "//VTK::System::Dec", Defines);
  MarkBehind(fragment, "//VTK::Light::Dec", Dec);
  FillMark(
    fragment, "//VTK::DepthPeeling::Impl", std::string(Impl) + "\n  //VTK::DepthPeeling::Impl");
}

//------------------------------------------------------------------------------
std::string vtkRelievoCutoff::Fill(std::string& fragment)
{
  for (const char* mark : { Defines, Dec, Impl })
  {
    if (!Has(fragment, mark))
    {
      return std::string("its fragment shader lacks VTK's tag for ") + mark +
        "; use VTK's templates, with their tags";
    }
  }
  FillMark(fragment, Defines, GetContract() + Section("Defines"));
  FillMark(fragment, Dec, Section("FragmentDec"));
  FillMark(fragment, Impl, Section("FragmentImpl"));
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoCutoff::Tell(vtkActor* actor, double cutoff)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  const bool had = keys && keys->Has(vtkRelievoCutSurface::CUTOFF());
  if (cutoff > 0.0)
  {
    if (!keys)
    {
      vtkNew<vtkInformation> made;
      actor->SetPropertyKeys(made);
      keys = actor->GetPropertyKeys();
    }
    if (!had)
    {
      keys->Set(Before(), actor->GetForceOpaque() ? 1 : 0);
    }
    keys->Set(vtkRelievoCutSurface::CUTOFF(), cutoff);
    actor->ForceOpaqueOn();
  }
  else if (had)
  {
    actor->SetForceOpaque(keys->Get(Before()) != 0);
    keys->Remove(Before());
    keys->Remove(vtkRelievoCutSurface::CUTOFF());
  }
}
