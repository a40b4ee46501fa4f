// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoGltfWriter
 * @brief Writes a renderer's scene as a glTF 2 file (.glb), and compares the file with the scene.
 *
 * The file has the visible actors: meshes, composite data, assemblies and glyphs as triangles,
 * lines and points with their normals; colours mapped from arrays; textures; materials; the lights
 * that are on; the camera. It shows the scene as it is when Write() is called. AddKey(), called
 * before for some moments of the scene, adds an animation: places of actors and of the camera, and
 * points (as morph targets, one for each key), all linear between the keys.
 *
 * Colours: those of points are written as linear colours of 16 bits, those of cells with points of
 * their own for each cell, and colour maps of a mapper that interpolates values
 * (InterpolateScalarsBeforeMapping) as a texture. PBR materials keep their values; others get the
 * diffuse colour, metal 0, and a roughness that makes highlights as wide as the specular power's.
 * Surfaces without light, lines and points are unlit (KHR_materials_unlit).
 *
 * Lights (KHR_lights_punctual): a light that does not fall off with the square of the distance is
 * as bright as VTK's at the middle of the scene. Where no actor is PBR, intensities are multiplied
 * by pi, because VTK's other materials do not divide by it.
 *
 * Coordinates: glTF has y up; UpAxis turns the scene. Meshes far from the origin are stored
 * relative to their middle, which their node places in double.
 *
 * Left out, with a note: volumes, environments, edges of surfaces, sizes of points and widths of
 * lines, textures with floats, clipped glyphs, other actors with unknown meshes, projective
 * matrices; without a note: texts, bars, and annotations such as grids and the ground of presets.
 *
 * Unless Check is off, the written file is read again and drawn from the same camera: depth,
 * normals and colours of the opaque surfaces must agree with the scene's, otherwise the file is not
 * kept. Actors of which something is left out are not compared.
 *
 * Errors: no renderer or file name, nothing visible, a file larger than 4 GiB, a file that cannot
 * be written, a file that shows another scene.
 */
#ifndef vtkRelievoGltfWriter_h
#define vtkRelievoGltfWriter_h

#include "vtkObject.h"
#include "vtkRelievoSceneModule.h" // for the export macro
#include "vtkRelievoText.h"        // for names
#include "vtkSmartPointer.h"       // for the renderer

#include <map>    // for names
#include <memory> // for the keys
#include <string> // for names
#include <vector> // for notes

class vtkRenderer;

class VTKRELIEVOSCENE_EXPORT vtkRelievoGltfWriter : public vtkObject
{
public:
  static vtkRelievoGltfWriter* New();
  vtkTypeMacro(vtkRelievoGltfWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The renderer, which must be in a render window. Default: none. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** The file, .glb; replaced when the new one is whole. Default: none. */
  void SetFileName(RELIEVO_TEXT name);
  std::string GetFileName() { return this->FileName; }
  ///@}

  ///@{
  /** The scene's upward axis, 0 to 2 for x, y, z. Default: 1. */
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /** Whether the file is read again and compared with the scene. Default: yes. */
  vtkSetMacro(Check, bool);
  vtkGetMacro(Check, bool);
  vtkBooleanMacro(Check, bool);
  ///@}

  ///@{
  /** The name of an actor, by its index in vtkRenderer::GetActors(). Default: none. */
  void SetObjectName(int actor, RELIEVO_TEXT name);
  std::string GetObjectName(int actor);
  ///@}

  ///@{
  /**
   * Adds the scene as it is now to the animation, at a time in seconds, later than those before.
   * Actors whose meshes do not keep their cells rest, with a note. False after an error.
   */
  bool AddKey(double seconds);
  void RemoveAllKeys();
  ///@}

  /** Writes the file. False after an error. */
  bool Write();

  ///@{
  /** The parts that Write() left out or changed, a sentence each. */
  int GetNumberOfNotes() { return static_cast<int>(this->Notes.size()); }
  std::string GetNote(int i);
  ///@}

  /** The operating system's number of the error that kept the file from being written; 0: none. */
  vtkGetMacro(SystemError, int);

protected:
  vtkRelievoGltfWriter();
  ~vtkRelievoGltfWriter() override;

private:
  vtkRelievoGltfWriter(const vtkRelievoGltfWriter&) = delete;
  void operator=(const vtkRelievoGltfWriter&) = delete;

  class Internals;
  const std::unique_ptr<Internals> Internal;
  vtkSmartPointer<vtkRenderer> Renderer;
  std::string FileName;
  std::map<int, std::string> Names;
  std::vector<std::string> Notes;
  int UpAxis = 1;
  int SystemError = 0;
  bool Check = true;
};

#endif
