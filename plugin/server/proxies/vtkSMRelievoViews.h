// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoViews
 * @brief Gives render views and surfaces that are older than the plugin what later ones are made
 * with.
 *
 * A proxy is built from its XML once. Views made before the plugin came (ParaView's window always
 * holds one) lack the sub-proxy and the properties of view.xml, representations those of
 * material.xml. This adds them from the same XML, in the process that holds the proxies, as soon as
 * that process and its server know the plugin: when it is loaded on either, and when definitions
 * are read again. Those that have them stay as they are.
 *
 * Where a Python interpreter runs, its classes learn the properties too.
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

  /** The plugin's initializer: from now on views are upgraded in this process. */
  static void Start();

  /** The one that Start() made; nullptr before, and in processes without proxies (servers). */
  static vtkSMRelievoViews* GetInstance();

  /** Upgrades all views and representations of every session; returns how many it changed. */
  int Upgrade();

  /** Upgrades one view's proxy. True if it was changed, false if there was nothing to do. */
  static bool UpgradeView(vtkSMProxy* view);

  /** The sub-proxy that holds Relievo's settings of a view, or nullptr. */
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
