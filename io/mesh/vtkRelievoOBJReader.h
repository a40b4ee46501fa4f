// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoOBJReader
 * @brief Reads meshes in Wavefront's OBJ format (.obj) into one vtkPolyData.
 *
 * Points keep the numbers of the file, from 0. Where faces use a point with several normals or
 * texture coordinates, the first use has the point's number and the others get points at the end.
 * Cells are in VTK's order: those of `p`, then of `l`, then of `f`, each in the order of the file;
 * a face of two points is a line. The output has
 * - points in double precision (OutputPointsPrecision changes that);
 * - point arrays, each where the file has any: `Normals` (float, 3), `TextureCoordinates` (float,
 *   2; 0 0 at corners without), `RGBA` (unsigned char, 4; white at points without), as the active
 *   normals, texture coordinates and scalars. Colours of points, behind their coordinates, are 0 to
 *   255 if any of them is above 1, otherwise 0 to 1;
 * - where the file names materials, the cell array `MaterialIds` (int; -1: none), which counts the
 *   names in the field array `MaterialNames`; `MaterialLibraries` has the words after each
 *   `mtllib`. Libraries are not read;
 * - with Groups on, the cell arrays `GroupIds` and `ObjectIds` and the field arrays `GroupNames`
 *   and `ObjectNames`, alike.
 *
 * In a file with normals, a face that has a corner without one gets a normal there: its own, or, in
 * a smoothing group (`s`), the mean of such faces of the group at the point, weighted by area.
 * Points of no face then have normals away from the middle of the mesh.
 *
 * Points with a coordinate that is no finite number (`nan`, `1,5`) are left out with the cells that
 * use them: no cell uses them, their place is that of another point, and the cell array
 * `vtkOriginalCellIds` says which cells of the file are left. In a file of points alone, the others
 * are vertices then. Normals and texture coordinates that
 * are no numbers count as not given. GetNote() says how many of each, and where the first is. Also
 * left out, with a note, are free-form curves and surfaces.
 *
 * Text is ASCII or UTF-8, with or without a mark; UTF-16 is refused, as are an index of nothing and
 * a word that is no index. Numbers do not depend on the locale.
 *
 * Errors: one error event names the file, the line and what was expected; GetErrorCode() is set and
 * the output is empty.
 *
 * Format: Wavefront Technologies, Advanced Visualizer manual, appendix B1; colours of points as
 * MeshLab and others write them.
 */
#ifndef vtkRelievoOBJReader_h
#define vtkRelievoOBJReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoIOModule.h" // for the export macro

#include <string> // for the notes
#include <vector> // for the notes

class VTKRELIEVOIO_EXPORT vtkRelievoOBJReader : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoOBJReader* New();
  vtkTypeMacro(vtkRelievoOBJReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** SINGLE_PRECISION or DOUBLE_PRECISION of vtkAlgorithm. Default: DOUBLE_PRECISION. */
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /** Whether the output has the group (`g`) and object (`o`) of each cell. Default: off. */
  vtkSetMacro(Groups, bool);
  vtkGetMacro(Groups, bool);
  vtkBooleanMacro(Groups, bool);
  ///@}

  ///@{
  /** Parts of the last file that were left out, one line each. */
  int GetNumberOfNotes() { return static_cast<int>(this->Notes.size()); }
  const char* GetNote(int index); ///< null if there is none
  ///@}

protected:
  vtkRelievoOBJReader();
  ~vtkRelievoOBJReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoOBJReader(const vtkRelievoOBJReader&) = delete;
  void operator=(const vtkRelievoOBJReader&) = delete;

  // Throws the problem of the file, only inside the source file.
  void Parse(vtkPolyData* output);

  char* FileName = nullptr;
  int OutputPointsPrecision = vtkAlgorithm::DOUBLE_PRECISION;
  bool Groups = false;
  std::vector<std::string> Notes;
};

#endif
