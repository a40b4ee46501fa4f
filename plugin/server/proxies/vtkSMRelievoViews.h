// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoViews
 * @brief Adds Relievo's properties to render views and surfaces created before the plugin was
 * loaded.
 *
 * A proxy is built from its XML once. Views created before the plugin was loaded (ParaView's window
 * always has one) lack the sub-proxy and the properties of view.xml, representations those of
 * material.xml. This class adds them from the XML, in the process with the proxies, as soon as that
 * process and its server have loaded the plugin: when it is loaded on either, and when definitions
 * are read again. Proxies that have them stay unchanged.
 *
 * With a Python interpreter, its proxy classes get the properties too.
 *
 * Events: vtkCommand::UpdateEvent after Upgrade() has changed any.
 */
#ifndef vtkSMRelievoViews_h
#define vtkSMRelievoViews_h

#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

class vtkSMProxy;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoViews : public vtkObject
{
public:
  static vtkSMRelievoViews* New();
  vtkTypeMacro(vtkSMRelievoViews, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The plugin's initializer: from now on, views in this process are upgraded. */
  static void Start();

  /** The instance made by Start(); nullptr before, and in processes without proxies (servers). */
  static vtkSMRelievoViews* GetInstance();

  /**
   * Upgrades all views and representations of every session; returns the number of changed ones.
   */
  int Upgrade();

  /** Upgrades one view's proxy. Returns whether anything was missing. */
  static bool UpgradeView(vtkSMProxy* view);

  /** The sub-proxy with Relievo's settings of a view, or nullptr. */
  static vtkSMProxy* GetSettings(vtkSMProxy* view);

protected:
  vtkSMRelievoViews() = default;
  ~vtkSMRelievoViews() override = default;

  bool Upgrading = false;

private:
  vtkSMRelievoViews(const vtkSMRelievoViews&) = delete;
  void operator=(const vtkSMRelievoViews&) = delete;

  void OnChange();
};

#endif
