// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFillLight.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRelievoFormulas.h"

namespace
{
vtkInformationIntegerKey* GetFillKey()
{
  static auto* const key = vtkInformationIntegerKey::MakeKey("FILL_LIGHT", "vtkRelievoFillLight");
  return key;
}
}

//------------------------------------------------------------------------------
void vtkRelievoFillLight::Make(vtkLight* light)
{
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> made;
    light->SetInformation(made);
  }
  light->GetInformation()->Set(GetFillKey(), 1);
  light->Modified(); // keys do not change its time
}

//------------------------------------------------------------------------------
void vtkRelievoFillLight::Clear(vtkLight* light)
{
  if (light->GetInformation())
  {
    light->GetInformation()->Remove(GetFillKey());
    light->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoFillLight::Is(vtkLight* light)
{
  return !light->GetPositional() && light->GetInformation() &&
    light->GetInformation()->Has(GetFillKey());
}

//------------------------------------------------------------------------------
std::array<glm::vec3, 9> vtkRelievoFillLight::GetCoefficients(
  const std::vector<glm::dvec3>& towards, const std::vector<glm::dvec3>& colors)
{
  std::array<glm::vec3, 9> coefficients{};
  for (std::size_t i = 0; i < towards.size(); ++i)
  {
    for (int k = 0; k < 9; ++k)
    {
      coefficients[k] += glm::vec3(colors[i] * relievo::f64::relievoShBasis(k, towards[i]));
    }
  }
  return coefficients;
}
