// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoShaderLibrary
 * @brief The GLSL sources of Relievo, by their path below shaders/.
 *
 * A line `//RELIEVO::Include(formulas/formats/depth.glsl)` in a source is replaced by that file,
 * once per source even if several lines name it.
 */
#ifndef vtkRelievoShaderLibrary_h
#define vtkRelievoShaderLibrary_h

#include "vtkObject.h"
#include "vtkRelievoShadersModule.h" // for the export macro

#include <string> // for the sources

class VTKRELIEVOSHADERS_EXPORT vtkRelievoShaderLibrary : public vtkObject
{
public:
  static vtkRelievoShaderLibrary* New();
  vtkTypeMacro(vtkRelievoShaderLibrary, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Number of sources. */
  static int GetNumberOfSources();

  /** Path of source i, in [0, GetNumberOfSources()); nullptr outside. */
  static const char* GetName(int i);

  /**
   * The source with its includes resolved; empty, with an error, if the name or an include is
   * unknown.
   */
  static std::string Get(const std::string& name);

  /**
   * The part of a source from its line `//RELIEVO::Section(section)` to the next such line, with
   * its includes resolved; empty, with an error, if the source or the section is unknown.
   */
  static std::string GetSection(const std::string& name, const std::string& section);

  /**
   * Adds a source of another library, which may include existing ones. False, with an error, if the
   * name is taken.
   */
  static bool Add(const std::string& name, const std::string& text);

protected:
  vtkRelievoShaderLibrary() = default;
  ~vtkRelievoShaderLibrary() override = default;

private:
  vtkRelievoShaderLibrary(const vtkRelievoShaderLibrary&) = delete;
  void operator=(const vtkRelievoShaderLibrary&) = delete;
};

#endif
