// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoViewProxy
 * @brief Proxy of vtkPVRelievoView, a sub-proxy of a render view's.
 *
 * Passes to its object, on every process, the view and the names of the view's added lights. Gets
 * the frame report from the server if that draws the view's pictures, otherwise from this process.
 * After each picture the property DisplayLayer offers the lights that cast.
 */
#ifndef vtkSMRelievoViewProxy_h
#define vtkSMRelievoViewProxy_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMProxy.h"

#include <map>    // for lights
#include <string> // for names

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoViewProxy : public vtkSMProxy
{
public:
  static vtkSMRelievoViewProxy* New();
  vtkTypeMacro(vtkSMRelievoViewProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMRelievoViewProxy() = default;
  ~vtkSMRelievoViewProxy() override = default;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

  bool KnowsView = false;

private:
  void NameLights(vtkSMProxy* view);
  void OfferLights();

  std::map<vtkTypeUInt32, std::string> LightNames; // by global id, as last sent
  vtkSMRelievoViewProxy(const vtkSMRelievoViewProxy&) = delete;
  void operator=(const vtkSMRelievoViewProxy&) = delete;
};

#endif
