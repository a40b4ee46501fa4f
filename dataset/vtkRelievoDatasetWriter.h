// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDatasetWriter
 * @brief Writes views of a renderer as a data set for training or evaluation.
 *
 * For each view: the picture, depth, masks of each object, its boxes and its pose, K, R and t, in a
 * folder of one of the formats. Masks and depth have one sample at each pixel's centre, without
 * antialiasing: an object's visible mask covers the pixels where the layer `actor` (or `block`) is
 * its own, its amodal mask those where the object alone would be visible. So visible masks are
 * disjoint, and each lies within its amodal mask. Translucent surfaces and volumes appear only in
 * the picture; cut-outs have their cut shape.
 *
 * Pinholes are drawn in the renderer's window (one of its own, off screen, if it has none), which
 * is restored afterwards. For other cameras, masks and layers come from rays (vtkRelievoRayScene
 * lists the props that rays miss), and the picture is that of vtkRelievoLensPicture. BOP and NERF
 * need a K; NERF needs a lens without skew, described by k1, k2, p1, p2, k3 or a fisheye's k1 to
 * k4. Cameras without a picture (vtkRelievoLidar, vtkRelievoPushbroomCamera) need NPZ.
 *
 * The folder has dataset.json, the settings; views/NUMBER.json, a record of each view, written
 * after all other files of the view; and the format's own files. Write() continues an earlier,
 * interrupted one: views with a record stay unchanged. Several processes can share the work: by
 * parts, whose indices Merge() writes, or by ranges, after which each writes the indices of all
 * views present.
 *
 * Errors: one error event, with GetFailure() and GetFailureText(), like vtkRelievoScene. Progress:
 * progress events of 0 to 1; SetAbort() ends the work after the current view.
 */
#ifndef vtkRelievoDatasetWriter_h
#define vtkRelievoDatasetWriter_h

#include "vtkObject.h"
#include "vtkRelievoDatasetModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for names that are given

#include <functional> // for fallible work
#include <memory>     // for private data
#include <string>     // for texts

class vtkRelievoCameraModel;
class vtkRenderer;

class VTKRELIEVODATASET_EXPORT vtkRelievoDatasetWriter : public vtkObject
{
public:
  static vtkRelievoDatasetWriter* New();
  vtkTypeMacro(vtkRelievoDatasetWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The renderer, which must fill its window; its visible props are drawn. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** The folder, made if missing; it must be empty, or begun by the same settings. */
  void SetDirectory(RELIEVO_TEXT directory);
  std::string GetDirectory();
  ///@}

  enum Formats
  {
    BOP = 0,   ///< a scene of the Benchmark for 6D Object Pose Estimation, with the models to which
               ///< its poses refer; visible fractions are relative to silhouettes up to a picture's
               ///< size beyond the picture
    COCO = 1,  ///< instances.json, with run-length masks
    NERF = 2,  ///< transforms.json
    NPZ = 3,   ///< arrays that numpy.load() reads
    YOLO = 4,  ///< boxes as lines of text for Ultralytics' detectors, and data.yaml
    KITTI = 5, ///< boxes as lines of text as in KITTI's object benchmark
    WEBDATASET = 6 ///< tar archives of samples for the package webdataset, and index.json
  };
  ///@{
  /** The data set's format. Default BOP. The parameter `format` accepts further formats by name. */
  void SetFormat(int format);
  vtkGetMacro(Format, int);
  ///@}

  ///@{
  /**
   * The cameras. AddView() copies one. AddViews() parses words, and makes copies of a camera that
   * gives the size and the intrinsics; set the renderer, names, UpAxis and Seed before:
   *
   * - "orbit:N[,elevation=30][,distance=1]": N places around the objects; elevation in degrees
   *   above the horizon, distance as a multiple of the one from which all objects are visible
   * - "random:N[,lowest=0][,highest=90][,nearest=1][,farthest=1.5]": N places by the seed, uniform
   *   on the sphere between two elevations, and between two such distances
   * - a JSON file: a list of {"R", "t"} or {"position", "target"[, "up"]}, each with optional "K"
   *   and "size", or a transforms.json, which may give the lens of a pinhole camera
   */
  void AddView(vtkRelievoCameraModel* camera);
  bool AddViews(RELIEVO_TEXT words, vtkRelievoCameraModel* like);
  void RemoveAllViews();
  int GetNumberOfViews();
  vtkRelievoCameraModel* GetView(int i);
  ///@}

  ///@{
  /**
   * Layers to write as floats: arrays in NPZ, otherwise in layers/NUMBER.exr. Those of
   * vtkRelievoFlow go from each view to the previous one; the first view has none.
   */
  void AddLayer(RELIEVO_TEXT name);
  void RemoveAllLayers();
  ///@}

  ///@{
  /**
   * Whether each block of composite data is an object, rather than each actor. Default off. The
   * name of an object, by the actor's number in vtkRenderer::GetActors(): default `actor_NUMBER`;
   * actors of one name form one object, and actors with an empty name only hide others.
   */
  vtkSetMacro(ObjectsByBlock, bool);
  vtkGetMacro(ObjectsByBlock, bool);
  vtkBooleanMacro(ObjectsByBlock, bool);
  void SetObjectName(int actor, RELIEVO_TEXT name);
  ///@}

  ///@{
  /**
   * The category of objects whose names match a pattern with * and ?, for the formats COCO, YOLO
   * and KITTI; a later pattern replaces earlier ones. Default: each object is a category with its
   * own name. Patterns without an object are an error of Write().
   */
  void SetCategory(RELIEVO_TEXT pattern, RELIEVO_TEXT category);
  void RemoveAllCategories();
  ///@}

  ///@{
  /**
   * Share of the views for validation, 0 to 1, spread evenly, for the formats COCO, NERF, YOLO and
   * KITTI. Default 0: no view.
   */
  vtkSetClampMacro(Validation, double, 0.0, 1.0);
  vtkGetMacro(Validation, double);
  ///@}

  ///@{
  /**
   * The largest size of an archive of several views, megabytes, 0.001 to 1e6, for the format
   * WEBDATASET; a larger view has an archive of its own. Default 256.
   */
  vtkSetClampMacro(ShardSize, double, 0.001, 1e6);
  vtkGetMacro(ShardSize, double);
  ///@}

  ///@{
  /**
   * World units per step of 16-bit depth; default 0: the farthest visible corner has 65535 in the
   * view farthest from it. Depth beyond the last step is 0, like empty pixels.
   */
  vtkSetClampMacro(DepthStep, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DepthStep, double);
  ///@}

  ///@{
  /** Millimetres per world unit, for BOP. Default 1000: world units are metres. */
  vtkSetClampMacro(MillimetersPerUnit, double, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(MillimetersPerUnit, double);
  ///@}

  ///@{
  /**
   * Whether each view moves the scene's first sun, to 15 to 75 degrees above the horizon; in a
   * scene without a sun it is the only light. Default off.
   */
  vtkSetMacro(RandomSun, bool);
  vtkGetMacro(RandomSun, bool);
  vtkBooleanMacro(RandomSun, bool);
  ///@}

  ///@{
  /** Seed of all random numbers: equal seeds give equal data sets. Default 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** The world's up axis, 0, 1, 2 for x, y, z. Default 1. */
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /** The range of views that Write() draws, its end excluded. Default all, as (0, -1). */
  vtkSetVector2Macro(Range, int);
  vtkGetVector2Macro(Range, int);
  ///@}

  ///@{
  /**
   * Which part of the work, from 1, Write() does, and the number of parts: so many equal shares of
   * the views. Each part draws its views and writes no index. Default 1 of 1: all views of Range,
   * and the indices.
   */
  void SetPart(int part, int parts);
  vtkGetMacro(Part, int);
  vtkGetMacro(NumberOfParts, int);
  ///@}

  ///@{
  /** A description of the contents; a folder begun with another description is refused. */
  void SetDescription(RELIEVO_TEXT text);
  std::string GetDescription();
  ///@}

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

  ///@{
  /**
   * Whether the scene differs between views; default off. Each view then begins with a StartEvent,
   * whose data is the view's number (int). An observer changes the scene as a function of this
   * number alone, because views are drawn in any order and again after an interruption, and may
   * describe the view in JSON, for its record. Actors may move and change, but not appear or
   * vanish. Layers of flow are refused.
   */
  vtkSetMacro(SceneVaries, bool);
  vtkGetMacro(SceneVaries, bool);
  vtkBooleanMacro(SceneVaries, bool);
  void SetVariation(RELIEVO_TEXT json);
  ///@}

  /** Writes the missing views. */
  bool Write();

  /**
   * Writes the indices of a folder whose parts are all complete, which makes it the folder that a
   * single call of Write() makes. Needs only the folder. False, with a failure, if views are
   * missing or damaged.
   */
  bool Merge(RELIEVO_TEXT directory);

  /**
   * Checks a folder without changing it: 0 if it is whole; 3 if views or indices are missing, files
   * damaged, or views of another version, which GetVerdict() then lists; -1, with a failure, if it
   * is no data set.
   */
  int Verify(RELIEVO_TEXT directory);
  std::string GetVerdict() { return this->Verdict; }

  ///@{
  /** Views written by the last Write(), and views that it found complete. */
  vtkGetMacro(NumberOfViewsWritten, int);
  vtkGetMacro(NumberOfViewsKept, int);
  ///@}

  ///@{
  /** Error of the last function that can fail, like vtkRelievoScene's. */
  int GetFailure() { return this->Failure; }
  std::string GetFailureText() { return this->FailureText; }
  ///@}

  /** Stops the work in progress; call it from an observer of the progress. */
  void SetAbort() { this->Abort = true; }

protected:
  vtkRelievoDatasetWriter();
  ~vtkRelievoDatasetWriter() override;

private:
  vtkRelievoDatasetWriter(const vtkRelievoDatasetWriter&) = delete;
  void operator=(const vtkRelievoDatasetWriter&) = delete;

  bool Try(const std::function<void()>& work);
  void WriteViews();
  void Vary(int view);

  vtkRelievoParameterList Parameters;
  int Format = BOP;
  bool ObjectsByBlock = false;
  double DepthStep = 0.0;
  double MillimetersPerUnit = 1000.0;
  double Validation = 0.0;
  double ShardSize = 256.0;
  bool RandomSun = false;
  bool SceneVaries = false;
  int Seed = 0;
  int UpAxis = 1;
  int Range[2] = { 0, -1 };
  int Part = 1;
  int NumberOfParts = 1;
  std::string Verdict;
  int NumberOfViewsWritten = 0;
  int NumberOfViewsKept = 0;
  int Failure = 0;
  std::string FailureText;
  bool Abort = false;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
