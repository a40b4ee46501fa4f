// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoMaterial
 * @brief The material of one of ParaView's surface representations, on one process.
 *
 * Puts a vtkRelievoMaterial on the actors of a vtkGeometryRepresentation, front and back, while it
 * is on and has something to show: a map that could be read, or the view's environment to mirror.
 * Off it takes it away again, and ParaView's picture is its own.
 *
 * Every process reads the maps' files itself, so they must be found by the same name on all that
 * draw. A file that cannot be read gives one error, and the surface is drawn without it.
 *
 * Every setting is a property of the representation's proxy (material.xml), where the values of the
 * material come from its own description. A value out of its range is brought into it by the
 * property, with a warning that says so.
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
   * The representation to work on, a vtkGeometryRepresentation. Given once, when its proxy is made.
   */
  void SetRepresentation(vtkPVDataRepresentation* representation);

  ///@{
  /** Whether the surface wears the material; its files are not read before. Default off. */
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
   * The representation's own setting, which it shares: whether scalars or their colours are
   * interpolated. Scalars take the place of the texture coordinates, so while the surface wears
   * maps colours are, whatever this says. Default on.
   */
  void SetInterpolateScalarsBeforeMapping(bool on);

  ///@{
  /**
   * A value of vtkRelievoMaterial by its name there, in the numbers of vtkRelievoParameter: a
   * choice by its place, a switch as 0 or 1. What it does not take is left, with a warning.
   */
  void SetValue(const char* parameter, double value);
  void SetValue(const char* parameter, double first, double second);
  ///@}

  /** Whether any material in the view mirrors its environment; `rough`: and is rough. */
  static bool IsMirrored(vtkPVView* view, bool rough = false);

  /** Before each picture: gives materials in the view that mirror its environment, or nullptr. */
  static void Prepare(vtkPVView* view, vtkRelievoEnvironment* environment);

  /** An environment that goes: no material keeps it. Touches no representation. */
  static void Forget(vtkRelievoEnvironment* environment);

  /** What the actors wear while the material is on. */
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
