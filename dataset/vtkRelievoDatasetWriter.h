// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDatasetWriter
 * @brief Writes what cameras see of a renderer as a data set to learn from, or to judge by.
 *
 * For each view: the picture, depth, masks of each object, its boxes and its pose, K, R and t, in a
 * folder of one of the formats. Masks and depth are one sample at each pixel's centre, whatever
 * smooths the picture: an object's visible mask is where the layer `actor` (or `block`) is its own,
 * its amodal mask where it would be without the others. So visible masks are disjoint, and each
 * lies within its amodal mask. What is translucent, and volumes, are in the picture alone; cut-outs
 * have the shape that is left.
 *
 * Pinholes are drawn in the renderer's window (one of its own, off screen, if it has none), which
 * afterwards is as before. Of other cameras masks and layers are by rays (vtkRelievoRayScene says
 * what these do not meet), and the picture is that of vtkRelievoLensPicture. BOP and NERF need a K,
 * NERF a lens without skew that k1, k2, p1, p2, k3 or a fisheye's k1 to k4 say; what has no picture
 * (vtkRelievoLidar, vtkRelievoPushbroomCamera) is for NPZ only.
 *
 * The folder has dataset.json, the settings; views/NUMBER.json, a record of each view, which is
 * written when all else of the view is there; and the format's own files. Write() goes on where an
 * earlier one ended: views that have a record are left as they are. Several processes may share the
 * work by ranges; each writes the indices of the views that are there.
 *
 * Errors: one error event, with GetFailure() and GetFailureText(), as of vtkRelievoScene. Progress:
 * progress events of 0 to 1; SetAbort() ends the work behind a view.
 */
#ifndef vtkRelievoDatasetWriter_h
#define vtkRelievoDatasetWriter_h

#include "vtkObject.h"
#include "vtkRelievoDatasetModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for names that are given

#include <functional> // for work that may fail
#include <memory>     // for what is private
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
  /** What is seen: visible props of a renderer that fills its window. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** The folder, which is made; it must be empty, or one that was begun so. */
  void SetDirectory(RELIEVO_TEXT directory);
  std::string GetDirectory();
  ///@}

  enum Formats
  {
    BOP = 0,  ///< a scene of the Benchmark for 6D Object Pose Estimation, with the models that its
              ///< poses place; how much of an object is seen is judged by its silhouette up to a
              ///< picture's size beyond the picture
    COCO = 1, ///< instances.json, with runs of pixels
    NERF = 2, ///< transforms.json
    NPZ = 3   ///< arrays that numpy.load() reads
  };
  ///@{
  /** Default BOP. Those besides are words of the parameter `format`. */
  void SetFormat(int format);
  vtkGetMacro(Format, int);
  ///@}

  ///@{
  /**
   * The cameras. AddView() copies one. AddViews() takes words, and makes copies of a camera that
   * has the size and the intrinsics; the renderer, names, UpAxis and Seed are set before:
   *
   * - "orbit:N[,elevation=30][,distance=1]": N places around what is shown, in degrees above the
   *   horizon and in distances from which it is all seen
   * - "random:N[,lowest=0][,highest=90][,nearest=1][,farthest=1.5]": N places by the seed, evenly
   *   over the sphere between two elevations, and between two such distances
   * - a file of JSON: a list of {"R", "t"} or {"position", "target"[, "up"]}, each with "K" and
   *   "size" by choice, or a transforms.json, which may say the lens of a camera that is a pinhole
   */
  void AddView(vtkRelievoCameraModel* camera);
  bool AddViews(RELIEVO_TEXT words, vtkRelievoCameraModel* like);
  void RemoveAllViews();
  int GetNumberOfViews();
  vtkRelievoCameraModel* GetView(int i);
  ///@}

  ///@{
  /**
   * Layers that are written as floats: in NPZ as arrays, else in layers/NUMBER.exr. Those of
   * vtkRelievoFlow go from each view to the one before; the first has none.
   */
  void AddLayer(RELIEVO_TEXT name);
  void RemoveAllLayers();
  ///@}

  ///@{
  /**
   * Whether each block of composite data is an object, rather than each actor. Default off. The
   * name of an object, by the actor's number in vtkRenderer::GetActors(): default `actor_NUMBER`;
   * actors of one name are one object, those of an empty one only hide others.
   */
  vtkSetMacro(ObjectsByBlock, bool);
  vtkGetMacro(ObjectsByBlock, bool);
  vtkBooleanMacro(ObjectsByBlock, bool);
  void SetObjectName(int actor, RELIEVO_TEXT name);
  ///@}

  ///@{
  /**
   * World units of a step of 16-bit depth; default 0: such that the farthest of what is shown has
   * 65535 in the view that is farthest from it. What is beyond the last step is 0, as where nothing
   * is.
   */
  vtkSetClampMacro(DepthStep, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DepthStep, double);
  ///@}

  ///@{
  /** Of BOP, whose lengths are millimetres. Default 1000: world units are metres. */
  vtkSetClampMacro(MillimetersPerUnit, double, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(MillimetersPerUnit, double);
  ///@}

  ///@{
  /**
   * Whether the scene's first sun stands elsewhere in each view, 15 to 75 degrees above the
   * horizon; a sun is the only light of a scene without one. Default off.
   */
  vtkSetMacro(RandomSun, bool);
  vtkGetMacro(RandomSun, bool);
  vtkBooleanMacro(RandomSun, bool);
  ///@}

  ///@{
  /** Of all that is random: the same seed, the same data set. Default 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** The world's, 0, 1, 2 for x, y, z. Default 1. */
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /** The views that Write() draws: from one to before another. Default all, as (0, -1). */
  vtkSetVector2Macro(Range, int);
  vtkGetVector2Macro(Range, int);
  ///@}

  ///@{
  /** What the data set is of, in words: one that was begun with others is refused. */
  void SetDescription(RELIEVO_TEXT text);
  std::string GetDescription();
  ///@}

  ///@{
  /** Parameters by name, with values in words, as of vtkRelievoStage. */
  vtkRelievoParametersMacro();
  ///@}

  /** Writes what is not there yet. */
  bool Write();

  ///@{
  /** Of the last Write(): views that were written, and that were there already. */
  vtkGetMacro(NumberOfViewsWritten, int);
  vtkGetMacro(NumberOfViewsKept, int);
  ///@}

  ///@{
  /** Why the last function that may fail did; as of vtkRelievoScene. */
  int GetFailure() { return this->Failure; }
  std::string GetFailureText() { return this->FailureText; }
  ///@}

  /** Ends the work that goes on, from an observer of its progress. */
  void SetAbort() { this->Abort = true; }

protected:
  vtkRelievoDatasetWriter();
  ~vtkRelievoDatasetWriter() override;

private:
  vtkRelievoDatasetWriter(const vtkRelievoDatasetWriter&) = delete;
  void operator=(const vtkRelievoDatasetWriter&) = delete;

  bool Try(const std::function<void()>& work);
  void WriteViews();

  vtkRelievoParameterList Parameters;
  int Format = BOP;
  bool ObjectsByBlock = false;
  double DepthStep = 0.0;
  double MillimetersPerUnit = 1000.0;
  bool RandomSun = false;
  int Seed = 0;
  int UpAxis = 1;
  int Range[2] = { 0, -1 };
  int NumberOfViewsWritten = 0;
  int NumberOfViewsKept = 0;
  int Failure = 0;
  std::string FailureText;
  bool Abort = false;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
