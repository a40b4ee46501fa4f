// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLayerCatalogue
 * @brief All layers: names, types, backgrounds, help.
 *
 * The only such list: readers, files, displays, lists of names and ParaView's properties query it
 * or are generated from it, and a new layer is one entry of its table (vtkRelievoLayer).
 */
#ifndef vtkRelievoLayerCatalogue_h
#define vtkRelievoLayerCatalogue_h

#include "vtkObject.h"
#include "vtkRelievoLayersModule.h" // for the export macro

#include <string> // for names

#ifndef __VTK_WRAP__
#include "vtkRelievoLayer.h" // for the entries
#include <vector>            // for the table
#endif

class VTKRELIEVOLAYERS_EXPORT vtkRelievoLayerCatalogue : public vtkObject
{
public:
  static vtkRelievoLayerCatalogue* New();
  vtkTypeMacro(vtkRelievoLayerCatalogue, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The layers in the order shown to users, from 0: the name ("shadow_N" for the layers of lights),
   * one line of help, the type of a component ("float", "unsigned char"), the number of components,
   * and the background value: NaN for `volume_value`, and for `color`, whose background is the
   * renderer's. For any other index: empty, 0, NaN.
   */
  static int GetNumberOfLayers();
  static std::string GetLayerName(int layer);
  static std::string GetLayerHelp(int layer);
  static std::string GetLayerType(int layer);
  static int GetLayerComponents(int layer);
  static double GetLayerBackground(int layer);
  ///@}

  /** All names, separated by commas. */
  static std::string GetLayerNames();

  // A std::string parameter would let VTK's wrapping end the program for text that is not Unicode.
  /** Whether the name is that of a layer: one of the table, or shadow_N with a number. */
  static bool GetIsLayer(const char* name) { return GetIsLayer(std::string(name ? name : "")); }

  /** The light's number of a layer shadow_N, or -1. */
  static int GetLight(const char* name) { return GetLight(std::string(name ? name : "")); }

  /** Whether the name starts like those of lights' layers: shadow_0, shadow_key_light. */
  static bool GetIsOfLight(const char* name) { return GetIsOfLight(std::string(name ? name : "")); }

#ifndef __VTK_WRAP__
  static bool GetIsLayer(const std::string& name);
  static int GetLight(const std::string& name);
  static bool GetIsOfLight(const std::string& name);

  static const std::vector<vtkRelievoLayer>& GetAll();

  // The layer of this name; of kind ARRAY if the table has no such name. Lights are known only by
  // their number: a frame resolves their names.
  static const vtkRelievoLayer& Find(const std::string& name);

  // The name of a layer in plain words: "Shadow of light 0" for shadow_0; an array's own name.
  static std::string GetTitle(const std::string& layer);

  // The entry for the layers of lights.
  static const vtkRelievoLayer& GetOfLight();

  // The entry for the picture itself.
  static const vtkRelievoLayer& GetPicture();
#endif

protected:
  vtkRelievoLayerCatalogue() = default;
  ~vtkRelievoLayerCatalogue() override = default;

private:
  vtkRelievoLayerCatalogue(const vtkRelievoLayerCatalogue&) = delete;
  void operator=(const vtkRelievoLayerCatalogue&) = delete;
};

#endif
