// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoMaterial
 * @brief The material of one of ParaView's surface representations, on one process.
 *
 * Sets a vtkRelievoMaterial on the actors of a vtkGeometryRepresentation, front and back, while it
 * is on and has an effect: a readable map, or the view's environment to mirror. Switched off, it is
 * removed, and the picture is ParaView's own.
 *
 * Every process reads the maps' files itself, so they must exist under equal names on all processes
 * that draw. An unreadable file gives one error, and the surface is drawn without it.
 *
 * Every setting is a property of the representation's proxy (material.xml); the material's values
 * come from its own description. The property clamps a value outside its range, with a warning.
 */
#ifndef vtkPVRelievoMaterial_h
#define vtkPVRelievoMaterial_h

#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

#include <memory> // for the internals

class vtkPVDataRepresentation;
class vtkPVView;
class vtkRelievoEnvironment;
class vtkRelievoMaterial;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoMaterial : public vtkObject
{
public:
  static vtkPVRelievoMaterial* New();
  vtkTypeMacro(vtkPVRelievoMaterial, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The representation to work on, a vtkGeometryRepresentation. Set once, when its proxy is made.
   */
  void SetRepresentation(vtkPVDataRepresentation* representation);

  ///@{
  /** Whether the surface has the material; its files are not read before. Default off. */
  void SetEnabled(bool on);
  vtkGetMacro(Enabled, bool);
  ///@}

  ///@{
  /** Files of the maps; empty (default): none. */
  void SetNormalMap(const char* file);
  void SetHeightMap(const char* file);
  ///@}

  ///@{
  /** Whether the surface mirrors the environment of its view, and is lit by it. Default off. */
  void SetMirror(bool on);
  vtkGetMacro(Mirror, bool);
  ///@}

  /**
   * The representation's own setting, shared with this class: whether scalars or their colours are
   * interpolated. Interpolated scalars use the texture coordinates, so a surface with maps
   * interpolates colours, whatever this setting. Default on.
   */
  void SetInterpolateScalarsBeforeMapping(bool on);

  ///@{
  /**
   * A value of vtkRelievoMaterial by its name, in the numbers of vtkRelievoParameter: a choice by
   * its index, a switch as 0 or 1. A refused value leaves the old one, with a warning.
   */
  void SetValue(const char* parameter, double value);
  void SetValue(const char* parameter, double first, double second);
  ///@}

  /**
   * Whether any material in the view mirrors its environment; `rough`: whether any is also rough.
   */
  static bool IsMirrored(vtkPVView* view, bool rough = false);

  /** Before each picture: passes the view's environment, or nullptr, to its mirroring materials. */
  static void Prepare(vtkPVView* view, vtkRelievoEnvironment* environment);

  /**
   * Before an environment is deleted: removes it from all materials, without changing
   * representations.
   */
  static void Forget(vtkRelievoEnvironment* environment);

  /** The material that the actors have while this is on. */
  vtkRelievoMaterial* GetMaterial();

protected:
  vtkPVRelievoMaterial();
  ~vtkPVRelievoMaterial() override;

  bool Enabled = false;
  bool Mirror = false;
  bool InterpolateScalars = true;

private:
  vtkPVRelievoMaterial(const vtkPVRelievoMaterial&) = delete;
  void operator=(const vtkPVRelievoMaterial&) = delete;

  bool IsMirroring(vtkPVView* view);
  void Apply();
  void KeepCoordinates();
  void Say(vtkObject* material, unsigned long event, void* text);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
