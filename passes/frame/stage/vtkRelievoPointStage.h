// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPointStage
 * @brief A stage that draws points with values (vtkRelievoPointValues): lamps, fog, markers.
 *
 * It keeps the sets of points, joins those of processes that draw together, and reports once what
 * is wrong. Classes that derive from it say which points they draw, and draw them.
 */
#ifndef vtkRelievoPointStage_h
#define vtkRelievoPointStage_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoPointValues.h" // for the sets
#include "vtkRelievoStage.h"
#include "vtkSmartPointer.h" // for the sets

#include <string> // for what is wrong
#include <vector> // for the sets

class vtkMultiProcessController;

class VTKRELIEVOFRAME_EXPORT vtkRelievoPointStage : public vtkRelievoStage
{
public:
  vtkTypeMacro(vtkRelievoPointStage, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sets of points, any number, each once; where they overlap, in their order. Adding none, a set
   * that is there already, or one of another class than the stage draws is an error.
   */
  void AddPoints(vtkRelievoPointValues* points);
  void RemovePoints(vtkRelievoPointValues* points);
  void RemoveAllPoints();
  int GetNumberOfPointSets();
  vtkRelievoPointValues* GetPoints(int i);
  ///@}

  /** New points of the class that the stage draws; not yet among its sets. */
  VTK_NEWINSTANCE virtual vtkRelievoPointValues* NewPoints() = 0;

  ///@{
  /**
   * Processes that each draw a part of the scene, all in step (ParaView's ranks): the points of
   * each count for all. All have the same number of sets, which may be empty. Default nullptr.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** Points that the last frame drew: those of which anything is in view. */
  vtkGetMacro(NumberDrawn, int);

  vtkMTimeType GetDataTime() override;

protected:
  vtkRelievoPointStage();
  ~vtkRelievoPointStage() override;

  /** What an error begins with: "There is no fog". */
  virtual const char* GetFailure() const = 0;

  /** Brings the points up to date, and joins those of all processes. */
  void Synchronize(vtkRelievoFrameContext& context) override;

  /**
   * Whether other processes may have points, also where this one has none: what is done together
   * must be done by all.
   */
  bool IsTogether() const;

  /** Makes what is wrong the reason of the frame, and an error if the frame before had another. */
  void ReportFault(const std::string& fault);

#ifndef __VTK_WRAP__
  /** The sets, of the class that NewPoints makes. */
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
