// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPointStage
 * @brief A stage that draws points with values (vtkRelievoPointValues): lamps, fog, markers.
 *
 * The stage stores the sets of points, joins those of processes that draw together, and reports
 * each error once. Subclasses define the class of the points, and draw them.
 */
#ifndef vtkRelievoPointStage_h
#define vtkRelievoPointStage_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoPointValues.h" // for the sets
#include "vtkRelievoStage.h"
#include "vtkSmartPointer.h" // for the sets

#include <string> // for errors
#include <vector> // for the sets

class vtkMultiProcessController;

class VTKRELIEVOFRAME_EXPORT vtkRelievoPointStage : public vtkRelievoStage
{
public:
  vtkTypeMacro(vtkRelievoPointStage, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sets of points, any number, each once; overlapping points are drawn in the sets' order. Adding
   * nullptr, a set that was added before, or a set of another class than NewPoints() is an error.
   */
  void AddPoints(vtkRelievoPointValues* points);
  void RemovePoints(vtkRelievoPointValues* points);
  void RemoveAllPoints();
  int GetNumberOfPointSets();
  vtkRelievoPointValues* GetPoints(int i);
  ///@}

  /** Makes points of the stage's class; they are not yet among its sets. */
  VTK_NEWINSTANCE virtual vtkRelievoPointValues* NewPoints() = 0;

  ///@{
  /**
   * Processes that each draw a part of the scene, in step (ParaView's ranks): each process draws
   * the points of all. All need the same number of sets, which may be empty. Default nullptr.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** Number of points in view that the last frame drew. */
  vtkGetMacro(NumberDrawn, int);

  vtkMTimeType GetDataTime() override;

protected:
  vtkRelievoPointStage();
  ~vtkRelievoPointStage() override;

  /** Start of error messages: "There is no fog". */
  virtual const char* GetFailure() const = 0;

  /** Updates the points, and joins those of all processes. */
  void Synchronize(vtkRelievoFrameContext& context) override;

  /**
   * Whether other processes may have points, even if this one has none: collective steps must be
   * done by all.
   */
  bool IsTogether() const;

  /**
   * Sets the error as the stage's reason, and reports it unless the frame before had the same one.
   */
  void ReportFault(const std::string& fault);

#ifndef __VTK_WRAP__
  /** The sets, cast to the class of NewPoints(). */
  template <typename Points>
  std::vector<Points*> GetSets() const
  {
    std::vector<Points*> sets;
    for (const auto& each : this->Sets)
    {
      sets.push_back(static_cast<Points*>(each.GetPointer()));
    }
    return sets;
  }
#endif

  int NumberDrawn = 0;

private:
  vtkRelievoPointStage(const vtkRelievoPointStage&) = delete;
  void operator=(const vtkRelievoPointStage&) = delete;

  std::vector<vtkSmartPointer<vtkRelievoPointValues>> Sets;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::string Fault; // of the last frame
};

#endif
