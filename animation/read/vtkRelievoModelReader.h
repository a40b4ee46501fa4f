// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoModelReader
 * @brief Reads models with bones and plays their animations.
 *
 * Reads glTF 2 (.gltf, .glb; Khronos, glTF 2.0 specification, 2021) and, through Assimp, Collada,
 * FBX, BVH, X, MS3D, SMD, MD5, IQM and more. It offers the times of the chosen animation
 * (TIME_STEPS: its keys, irregular as they are; TIME_RANGE) and answers the time that is asked for,
 * so that the time controls of VTK and ParaView play it.
 *
 * Port 0 is a vtkMultiBlockDataSet with a polydata block for each mesh of each node, named as in
 * the file, in world coordinates. Point arrays: `joints` (int; places in the mesh's list of bones,
 * the strongest first, -1 for none), `weights` (float, sum 1), `Normals`, `TextureCoordinates` and
 * `RGBA` where the file has them. Field data: `base_color`, `base_color_texture`, `normal_texture`
 * (names as in the file; GetEmbeddedTexture() has those that are in it), `normal_strength` (glTF's
 * scale of the normal map), and, at rest only, the bones for vtkRelievoSkin. A mesh without bones
 * follows its node: one bone, weight 1. Of glTF also `Tangents`, the active ones; `RGBA` there has
 * the material's base colour in it, and `TextureCoordinates` are those that the material's textures
 * lie on, with their transform, v upwards. Faces are turned where a node mirrors them, so that the
 * outside stays outside.
 *
 * For glTF, GetProperty(), GetTexture() and ApplyMaterial() give a block's material as VTK draws
 * it, and GetLight() and GetCamera() the lights and cameras of the scene.
 *
 * Port 1 is the skeleton: a point for each node of the file's tree, with the point arrays `pose`,
 * `pose_before`, `pose_after` (16 components, by rows: node to world), `parent`, `is_bone`, `name`,
 * the field data `key_share`, and lines between joints.
 *
 * Between keys, positions and scales are linear, rotations take the shorter arc; glTF's STEP holds
 * the key before, its CUBICSPLINE follows the splines. Before the first key and after the last
 * these hold. GetNote() lists repairs and omissions.
 *
 * Morph targets of glTF are played; at POSE_REST, too, for vtkRelievoSkin to move their result.
 *
 * Limits: the up axis and unit are those that Assimp gives; its morph targets are not played. Of
 * glTF 33 554 432 points and 134 217 728 corners are read, each counted at every node that shows
 * it, 4 GB of files, 2000 nodes below each other. Textures of a material that lie elsewhere than
 * its first one are left out, with a note. A light has no range, and between its cones it falls
 * off by a power of the cosine, the nearest one.
 *
 * Errors: one error event names the file, the error and its place in the file; GetErrorCode() is
 * set and the output is empty. A file is read again only when it, a file that it names, or its name
 * has changed, not when the time has.
 */
#ifndef vtkRelievoModelReader_h
#define vtkRelievoModelReader_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkRelievoAnimationModule.h" // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

#include <memory> // for std::unique_ptr
#include <string> // for descriptions of the contents
#include <vector> // for folders

class vtkActor;
class vtkCamera;
class vtkImageData;
class vtkLight;
class vtkPolyData;
class vtkProperty;
class vtkStringArray;
class vtkTexture;

class VTKRELIEVOANIMATION_EXPORT vtkRelievoModelReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkRelievoModelReader* New();
  vtkTypeMacro(vtkRelievoModelReader, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Folders of files that the model may name, such as buffers, images and materials; those in its
   * own folder and below are read always. Links count as their targets. A buffer elsewhere is
   * an error, all else is left out with a note. Default: none.
   */
  void AddAllowedFolder(VTK_FILEPATH const char* folder);
  void RemoveAllAllowedFolders();
  ///@}

  ///@{
  /**
   * Whether the file exists and its extension is glTF's or one that Assimp reads. Of these the
   * extensions of formats that have bones, with blanks between them, are opened as models without
   * being asked for.
   */
  static bool CanReadFile(VTK_FILEPATH const char* fileName);
  static std::string GetExtensions() { return "gltf glb bvh dae fbx iqm ms3d x"; }
  ///@}

  ///@{
  /** Name of the animation to play; empty plays the first. Default: empty. */
  vtkSetStringMacro(Animation);
  vtkGetStringMacro(Animation);
  ///@}

  ///@{
  /** Name of an animation to blend in, BlendWeight of the way; empty: none. Default: empty. */
  vtkSetStringMacro(BlendAnimation);
  vtkGetStringMacro(BlendAnimation);
  ///@}

  ///@{
  /**
   * 0 shows only Animation, 1 only BlendAnimation. Positions and scales are mixed, rotations take
   * the shorter arc; each animation is at the same pipeline time, and loops or stops by its own
   * range. KEY_MATRIX takes the keys of Animation. 0 to 1. Default: 0.5.
   */
  vtkSetClampMacro(BlendWeight, double, 0., 1.);
  vtkGetMacro(BlendWeight, double);
  ///@}

  enum Poses
  {
    POSE_REST = 0,      ///< meshes as in the file, transformed by their nodes if these move them
    POSE_NODES = 1,     ///< bones transformed by the nodes' own matrices, without an animation
    POSE_ANIMATION = 2, ///< bones transformed by the animation
    POSE_BIND = 3,      ///< meshes as at POSE_REST, and bones in their bind pose
  };

  ///@{
  /**
   * The pose of the bones. Without an animation, POSE_ANIMATION equals POSE_NODES. The skeleton at
   * POSE_REST is that of POSE_ANIMATION, which vtkRelievoSkin then applies. Default:
   * POSE_ANIMATION.
   */
  vtkSetClampMacro(Pose, int, POSE_REST, POSE_BIND);
  vtkGetMacro(Pose, int);
  ///@}

  ///@{
  /** The blending of bones: a method of vtkRelievoSkin. Default: vtkRelievoSkin::LINEAR. */
  vtkSetClampMacro(Method, int, 0, 2);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /** Most bones per point; the strongest are kept and rescaled. 1 to 8. Default: 8. */
  vtkSetClampMacro(WeightsPerPoint, int, 1, 8);
  vtkGetMacro(WeightsPerPoint, int);
  ///@}

  ///@{
  /** Whether rotations have constant speed between keys (slerp); otherwise nlerp. Default: on. */
  vtkSetMacro(Slerp, bool);
  vtkGetMacro(Slerp, bool);
  vtkBooleanMacro(Slerp, bool);
  ///@}

  ///@{
  /**
   * Whole keys per second that method KEY_MATRIX blends, from the animation's start; 0 takes every
   * time at which any node has a key. Default: 0.
   */
  vtkSetClampMacro(KeyRate, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(KeyRate, double);
  ///@}

  ///@{
  /** Whether times after the end restart; otherwise the pose stays at the end. Default: off. */
  vtkSetMacro(Loop, bool);
  vtkGetMacro(Loop, bool);
  vtkBooleanMacro(Loop, bool);
  ///@}

  ///@{
  /** Seconds of the animation per unit of pipeline time, above 0. Default: 1. */
  vtkSetClampMacro(Speed, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Speed, double);
  ///@}

  ///@{
  /**
   * Whether the skeleton includes the axes of its joints: lines with the cell arrays `axis` (0
   * between joints, 1 to 3 along x, y, z) and `axis_color` (red, green, blue). Default: off.
   */
  vtkSetMacro(SkeletonAxes, bool);
  vtkGetMacro(SkeletonAxes, bool);
  vtkBooleanMacro(SkeletonAxes, bool);
  ///@}

  ///@{
  /** Length of these axes in world units; 0: 3 % of the model's diagonal at rest. Default: 0. */
  vtkSetClampMacro(AxisLength, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(AxisLength, double);
  ///@}

  ///@{
  /**
   * Whether points have the array `first_bone`, as scalars: the index of the strongest bone in the
   * skeleton, -1 without one. Default: off.
   */
  vtkSetMacro(FirstBone, bool);
  vtkGetMacro(FirstBone, bool);
  vtkBooleanMacro(FirstBone, bool);
  ///@}

  ///@{
  /**
   * Name of a bone whose weights the points get as the array `bone_weight`, as scalars; empty:
   * none. GetBoneNames lists the names. Default: empty.
   */
  vtkSetStringMacro(WeightsOf);
  vtkGetStringMacro(WeightsOf);
  ///@}

  /** The bones of all meshes, after UpdateInformation(). */
  vtkStringArray* GetBoneNames();

  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();

  ///@{
  /** The animations of the file, after UpdateInformation(). */
  int GetNumberOfAnimations();
  const char* GetAnimationName(int index); ///< null if there is none
  vtkStringArray* GetAnimationNames();     ///< all of them
  ///@}

  ///@{
  /**
   * An image inside the file, by its name in a mesh (`base_color_texture`, `normal_texture`), the
   * lowest row first; nullptr if there is none of this name, or if it is damaged, or neither PNG,
   * JPEG nor bare texels, which is reported once. After Update().
   */
  vtkImageData* GetEmbeddedTexture(const char* name);
  bool HasEmbeddedTexture(const char* name);
  ///@}

  ///@{
  /**
   * The files looked for to read the model, including its own, whether they exist or not: buffers,
   * images, materials. After Update().
   */
  int GetNumberOfFiles();
  const char* GetFile(int index); ///< null if there is none
  ///@}

  ///@{
  /**
   * The material of a block of port 0 as VTK's shaders take it: shading by PBR with its factors,
   * and textures for base colour (sRGB), occlusion, roughness and metal, normals, and emission
   * (sRGB); without lighting where the file says so. Blocks have properties of their own, with
   * shared textures. nullptr if there is no such block, or the file is no glTF. After Update().
   */
  vtkProperty* GetProperty(int block);

  /** The texture of an unlit block, for vtkActor::SetTexture; otherwise nullptr. */
  vtkTexture* GetTexture(int block);

  enum AlphaModes
  {
    ALPHA_OPAQUE = 0, ///< alpha is ignored
    ALPHA_MASK = 1,   ///< not drawn where alpha is below the cutoff
    ALPHA_BLEND = 2
  };

  /** The use of alpha in a block: one of AlphaModes. */
  int GetAlphaMode(int block);

  /** The cutoff of a block with ALPHA_MASK; otherwise 0. */
  double GetAlphaCutoff(int block);

  /**
   * Sets the property, texture and point colours of an actor whose mapper draws the block, and
   * whether it is opaque. Does nothing if GetProperty() is nullptr.
   */
  void ApplyMaterial(int block, vtkActor* actor);
  ///@}

  ///@{
  /**
   * The lights of the scene (KHR_lights_punctual), each where its node is at the time of the last
   * Update(), shining along -z; before VTK 9.5, whose PBR takes suns beside lamps for lamps, these
   * stand far behind it. Intensity is in candela, of suns in lux, with the attenuation of inverse
   * squares: a white diffuse surface shaded by PBR, a metre in front of a candela, has the radiance
   * 1 / pi. nullptr when there is none.
   */
  int GetNumberOfLights();
  vtkLight* GetLight(int index);
  ///@}

  ///@{
  /**
   * The cameras of the scene, each at its node's position at the time of the last Update(). The
   * clipping range is set if the file has both of its ends. nullptr if there is none.
   */
  int GetNumberOfCameras();
  vtkCamera* GetCamera(int index);
  ///@}

  ///@{
  /** Parts repaired or left out while reading, a sentence each. */
  int GetNumberOfNotes();
  const char* GetNote(int index); ///< null if there is none
  ///@}

protected:
  vtkRelievoModelReader();
  ~vtkRelievoModelReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoModelReader(const vtkRelievoModelReader&) = delete;
  void operator=(const vtkRelievoModelReader&) = delete;

  // Whether there is a model; reads it if the file or the settings have changed.
  bool Read();
  // The index of the animation of this name, or -1, which is reported once.
  int FindAnimation(const char* name);
  // The node of the bone of WeightsOf, or -1.
  int FindBone();
  // The model at a pipeline time.
  struct Moment;
  Moment MakeMoment(double time);
  void MakeSkeleton(const Moment& moment, vtkPolyData* skeleton);
  void MakeMesh(std::size_t place, const Moment& moment, vtkPolyData* skeleton, vtkPolyData* mesh);

  char* FileName = nullptr;
  std::vector<std::string> AllowedFolders;
  char* Animation = nullptr;
  char* BlendAnimation = nullptr;
  double BlendWeight = 0.5;
  char* WeightsOf = nullptr;
  bool FirstBone = false;
  bool SkeletonAxes = false;
  double AxisLength = 0.;
  int Pose = POSE_ANIMATION;
  int Method = 0;
  int WeightsPerPoint = 8;
  bool Slerp = true;
  double KeyRate = 0.;
  bool Loop = false;
  double Speed = 1.;

  struct Internals;
  std::unique_ptr<Internals> Internal;
  vtkRelievoParameterList Parameters;
};

#endif
