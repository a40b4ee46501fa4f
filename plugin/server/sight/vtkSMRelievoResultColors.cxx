// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoResultColors.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkProcessModule.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

vtkStandardNewMacro(vtkSMRelievoResultColors);

namespace
{
// Results that are not negative, and whose 0 means nothing.
constexpr const char* Results[] = { "sun_hours", "insolation", "irradiation", "direct_irradiation",
  "diffuse_irradiation", "reflected_irradiation", "pixels", "solid_angle", "covered",
  "candidates" };

// ParaView widens the range of a constant array by about 1e-4 of its value.
constexpr double LeastWidth = 2e-4;

// ParaView's name of the colours of one representation is Separate_NUMBER_ARRAY.
const std::string Separate = "Separate_";

// Whether colours of this name, ARRAY.PVLookupTable, are those of a result.
bool IsOfResult(const std::string& name)
{
  const std::string array = name.substr(0, name.find('.'));
  std::string own = array;
  if (array.rfind(Separate, 0) == 0)
  {
    const std::size_t end = array.find_first_not_of("0123456789", Separate.size());
    const bool isNumbered = end != std::string::npos && end > Separate.size() && array[end] == '_';
    own = isNumbered ? array.substr(end + 1) : array;
  }
  return std::find(std::begin(Results), std::end(Results), own) != std::end(Results);
}

void OnUpdated(vtkObject* colors, unsigned long, void*, void*)
{
  constexpr int never = -1; // set by ParaView for a range that the user sets
  auto* proxy = vtkSMProxy::SafeDownCast(colors);
  double range[2];
  if (vtkSMPropertyHelper(proxy, "AutomaticRescaleRangeMode", true).GetAsInt() != never &&
    vtkSMTransferFunctionProxy::GetRange(proxy, range) && range[0] >= 0.0 &&
    range[1] - range[0] < LeastWidth * range[1])
  {
    vtkSMTransferFunctionProxy::RescaleTransferFunction(proxy, 0.0, range[1]);
  }
}
}

//------------------------------------------------------------------------------
vtkSMRelievoResultColors::vtkSMRelievoResultColors()
{
  this->Updated->SetCallback(OnUpdated);
}

//------------------------------------------------------------------------------
void vtkSMRelievoResultColors::Start()
{
  static vtkSmartPointer<vtkSMRelievoResultColors> instance;
  const auto type = vtkProcessModule::GetProcessType();
  if (instance ||
    (type != vtkProcessModule::PROCESS_CLIENT && type != vtkProcessModule::PROCESS_BATCH))
  {
    return;
  }
  instance = vtkSmartPointer<vtkSMRelievoResultColors>::New();
  constexpr double belowUsers = 0.5;
  vtkSMSettings::GetInstance()->AddCollectionFromString(R"({"array_lookup_tables": {
      "seen": {"PVLookupTable": {"AutomaticRescaleRangeMode": -1, "ScalarRangeInitialized": 1}},
      "sky_view": {"PVLookupTable": {"AutomaticRescaleRangeMode": -1, "ScalarRangeInitialized": 1}}
    }})",
    belowUsers);
  vtkSMProxyManager::GetProxyManager()->AddObserver(
    vtkCommand::RegisterEvent, instance.Get(), &vtkSMRelievoResultColors::OnRegistered);
}

//------------------------------------------------------------------------------
void vtkSMRelievoResultColors::OnRegistered(vtkObject*, unsigned long, void* registered)
{
  const auto& known = *static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(registered);
  if (known.Type == vtkSMProxyManager::RegisteredProxyInformation::PROXY &&
    std::strcmp(known.GroupName, "lookup_tables") == 0 && IsOfResult(known.ProxyName) &&
    !known.Proxy->HasObserver(vtkCommand::UpdateEvent, this->Updated)) // of another name
  {
    known.Proxy->AddObserver(vtkCommand::UpdateEvent, this->Updated);
    OnUpdated(known.Proxy, vtkCommand::UpdateEvent, nullptr, nullptr);
  }
}
