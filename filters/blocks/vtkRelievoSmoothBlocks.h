// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSmoothBlocks
 * @brief The surface of labelled blocks, with each vertex moved by its 2 x 2 x 2 neighbours alone.
 *
 * Input: a vtkImageData with an array of labels, any integer type, one component, on cells or on
 * points (each point is then the middle of a block). One label is air. By default the array is the
 * active scalars of the cells, or else of the points; SetInputArrayToProcess(0, ...) chooses
 * another. Blanked blocks are air: cells and points that are hidden, cells with a hidden point, and
 * cells that a finer level of an AMR replaces.
 *
 * Output 0: triangles, or quads, that face outwards, with the blocks' own topology: one face (two
 * triangles) where a block meets air, and by choice where two labels meet. Each vertex moves along
 * each axis by at most 3/8 of a block, by a rule that treats all axes alike and is symmetric under
 * the 48 symmetries of the cube (vtkRelievoBlockRule.h); no triangle is inverted or without area.
 * Cell arrays: "material", the label of the block that a face belongs to, and, between labels,
 * "neighbor", the label on its other side (of the labels' type, or of 64 bits where that cannot
 * hold the label of air; unsigned bytes, which mappers take for colours, become short).
 *
 * Output 1: lines along the seams, the edges that are not used by exactly two faces: where blocks
 * touch along an edge only, where three or four labels meet, and at open borders. Cell array
 * "uses".
 *
 * A piece asks its input for two more layers of ghost cells and is then, bit for bit, equal to
 * that part of the whole; an input that does not give them gets one warning. Results do not
 * depend on the number of threads.
 *
 * The rule is in the spirit of L. Pensjo's smooth worlds from block data (2012), made anew. Memory
 * grows with the surface. With an array of floats, or with none, the filter reports one error, sets
 * vtkErrorCode::UserError, and its output is empty.
 */
#ifndef vtkRelievoSmoothBlocks_h
#define vtkRelievoSmoothBlocks_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

#include <memory> // for the lists of labels

class VTKRELIEVOFILTERS_EXPORT vtkRelievoSmoothBlocks : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoSmoothBlocks* New();
  vtkTypeMacro(vtkRelievoSmoothBlocks, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The label of air. Default is 0. */
  vtkSetMacro(AirLabel, vtkTypeInt64);
  vtkGetMacro(AirLabel, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * How far vertices move, in blocks: 0 leaves cubes, 0.125 makes a step a slope of 45 degrees,
   * more rounds edges further. Default is 0.125; from 0 to 0.25.
   */
  vtkSetClampMacro(Strength, double, 0., 0.25);
  vtkGetMacro(Strength, double);
  ///@}

  enum SurfaceType
  {
    OUTSIDE = 0,
    BETWEEN_LABELS = 1
  };

  ///@{
  /**
   * Which faces are made: those between a block and air (OUTSIDE, the default), or also those
   * between blocks of two labels, once each (BETWEEN_LABELS). A face between two labels belongs to
   * the block with the lower indices.
   */
  vtkSetClampMacro(Surface, int, OUTSIDE, BETWEEN_LABELS);
  vtkGetMacro(Surface, int);
  ///@}

  ///@{
  /** Whether the outside of the image is air, which closes the surface. Default is on. */
  vtkSetMacro(CloseBorders, bool);
  vtkGetMacro(CloseBorders, bool);
  vtkBooleanMacro(CloseBorders, bool);
  ///@}

  ///@{
  /** Whether faces are cut into triangles along the shorter diagonal. Default is on. */
  vtkSetMacro(Triangles, bool);
  vtkGetMacro(Triangles, bool);
  vtkBooleanMacro(Triangles, bool);
  ///@}

  enum NormalsType
  {
    NO_NORMALS = 0,
    ACROSS_MATERIALS = 1,
    WITHIN_MATERIALS = 2
  };

  ///@{
  /**
   * Point normals: the area-weighted mean over all faces at a point (ACROSS_MATERIALS, the
   * default), or over those of one material, with one point per material (WITHIN_MATERIALS). Where
   * normals cancel out, each face gets a point with its own normal.
   */
  vtkSetClampMacro(Normals, int, NO_NORMALS, WITHIN_MATERIALS);
  vtkGetMacro(Normals, int);
  ///@}

  ///@{
  /** Labels whose blocks stay cubes: their vertices do not move. None by default. */
  void AddRigidLabel(vtkTypeInt64 label);
  void ClearRigidLabels();
  int GetNumberOfRigidLabels();
  ///@}

  ///@{
  /**
   * Labels whose blocks stay level, for liquids: their vertices do not move up or down, without
   * noise, and sideways half as far. None by default.
   */
  void AddLevelLabel(vtkTypeInt64 label);
  void ClearLevelLabels();
  int GetNumberOfLevelLabels();
  ///@}

  ///@{
  /** The axis of the image that points up: 0, 1, or 2 (the default). For levels and noise. */
  vtkSetClampMacro(Up, int, 0, 2);
  vtkGetMacro(Up, int);
  ///@}

  ///@{
  /**
   * Amplitude of the simplex noise added to heights, in blocks; 0, the default, adds none. Vertices
   * of rigid and level blocks get none. Above about a quarter of the scale, faces may fold.
   */
  vtkSetClampMacro(NoiseAmplitude, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseAmplitude, double);
  ///@}

  ///@{
  /** Size of the noise's cells in blocks. Default is 16; at least 0.1. */
  vtkSetClampMacro(NoiseScale, double, 0.1, VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseScale, double);
  ///@}

  ///@{
  /** Seed of the noise. Default is 0. */
  vtkSetMacro(NoiseSeed, int);
  vtkGetMacro(NoiseSeed, int);
  ///@}

  ///@{
  /**
   * 2, the default: noise over the ground plane, constant along the height; 3: noise that also
   * varies with height. Positions are counted in blocks, from index 0 of the image.
   */
  vtkSetClampMacro(NoiseDimensions, int, 2, 3);
  vtkGetMacro(NoiseDimensions, int);
  ///@}

  ///@{
  /**
   * Whether points have texture coordinates that keep all lengths: each triangle is as large in the
   * texture as in space. Each face then has its own points. Flat ground has one continuous texture;
   * up on side faces is up in the texture. Default is off.
   */
  vtkSetMacro(TextureCoordinates, bool);
  vtkGetMacro(TextureCoordinates, bool);
  vtkBooleanMacro(TextureCoordinates, bool);
  ///@}

  ///@{
  /**
   * Size of one copy of the texture, or of a tile of the atlas, in world units. 0, the default,
   * uses the longest side of a block, or twice that for an atlas, so that every face fits.
   */
  vtkSetClampMacro(TileSize, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(TileSize, double);
  ///@}

  ///@{
  /**
   * Columns and rows of an atlas, a texture with a tile for each material: label 1 has the tile in
   * the lower left corner, label 2 the next to its right. Faces lie in the middle of their tile;
   * faces larger than TileSize, for example because of noise, are stretched at the tile's border,
   * with a warning. 0 0, the default: no atlas, textures repeat.
   */
  vtkSetVector2Macro(Atlas, int);
  vtkGetVector2Macro(Atlas, int);
  ///@}

  ///@{
  /**
   * Whether points have the array "weights", for soft borders between materials: one component per
   * label, named after it, with the label's share of the faces at the point. A face between two
   * labels counts half for each. Weights sum to 1 if all labels are weighted. Default is off.
   */
  vtkSetMacro(MaterialWeights, bool);
  vtkGetMacro(MaterialWeights, bool);
  vtkBooleanMacro(MaterialWeights, bool);
  ///@}

  ///@{
  /**
   * Labels with weights; if none are added, all labels that have faces. Add them if pieces must
   * have the same components. At most 64.
   */
  void AddWeightedLabel(vtkTypeInt64 label);
  void ClearWeightedLabels();
  int GetNumberOfWeightedLabels();
  ///@}

  ///@{
  /** Whether output 1 is made. Default is on. */
  vtkSetMacro(Seams, bool);
  vtkGetMacro(Seams, bool);
  vtkBooleanMacro(Seams, bool);
  ///@}

  ///@{
  /**
   * Type of the points' coordinates, as in vtkAlgorithm. DEFAULT_PRECISION, the default, is double
   * if float would move points of the whole image by more than a thousandth of a block's shortest
   * side, otherwise float.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Upper bound of the bytes needed to make the surface; 0, the default: all free memory. A surface
   * that needs more is refused before it is made; the message gives the bytes needed.
   */
  vtkSetClampMacro(MemoryLimit, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoSmoothBlocks();
  ~vtkRelievoSmoothBlocks() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
  vtkTypeInt64 AirLabel = 0;
  double Strength = 0.125;
  int Surface = OUTSIDE;
  bool CloseBorders = true;
  bool Triangles = true;
  int Normals = ACROSS_MATERIALS;
  int Up = 2;
  double NoiseAmplitude = 0.;
  double NoiseScale = 16.;
  int NoiseSeed = 0;
  int NoiseDimensions = 2;
  bool TextureCoordinates = false;
  double TileSize = 0.;
  int Atlas[2] = { 0, 0 };
  bool MaterialWeights = false;
  bool Seams = true;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  double MemoryLimit = 0.;
  vtkRelievoParameterList Parameters;

  vtkRelievoSmoothBlocks(const vtkRelievoSmoothBlocks&) = delete;
  void operator=(const vtkRelievoSmoothBlocks&) = delete;
};

#endif
