// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPointValues
 * @brief Points with a few values each, from data: what lamps and fog spheres are made of.
 *
 * Input: any vtkDataSet (vtkPolyData usually) or composite dataset. Each point is one thing. A
 * value comes from a point array, by default the array of the value's name, or is one for all
 * points. Points whose place or values are not finite, and ghosts, are left out and counted.
 *
 * Errors, once each: an array that was named and does not exist, or is not of the right number of
 * components or length; the one value for all is taken instead.
 */
#ifndef vtkRelievoPointValues_h
#define vtkRelievoPointValues_h

#include "vtkAlgorithm.h"
#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkSmartPointer.h"       // for the matrix

#include <set>    // for what was said
#include <string> // for names
#include <vector> // for values

class vtkDataObject;
class vtkDataSet;
class vtkMatrix4x4;
class vtkMultiProcessController;

class VTKRELIEVOFRAME_EXPORT vtkRelievoPointValues : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkRelievoPointValues, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The points, as data that is not updated by a pipeline; nullptr for none. */
  void SetInputData(vtkDataObject* data);

  ///@{
  /**
   * The point array that a value, such as "radius", is taken from. Default: the array of that name,
   * if there is one. "" takes the one value for all points.
   */
  void SetArray(const std::string& value, const std::string& array);
  std::string GetArray(const std::string& value);
  ///@}

  ///@{
  /**
   * Where the data lies in the world, as of vtkProp3D: moves the points, but no other values.
   * Default nullptr: the data is in world coordinates.
   */
  virtual void SetUserMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetUserMatrix();
  ///@}

  /** Brings the points up to date; returns how many there are. */
  int GetNumberOfPoints();

  vtkMTimeType GetMTime() override;

  /** Brings the points up to date; when they, or a setting, have last changed. */
  vtkMTimeType GetUpdatedTime();

  /** Points that were left out, because their place or values are not finite, or have no effect. */
  vtkGetMacro(NumberLeftOut, int);

#ifndef __VTK_WRAP__
  // Row by row: x, y, z, and the values in their order. Up to date after GetNumberOfPoints.
  const std::vector<double>& GetRows() const
  {
    return this->Rows;
  }

  // Brings the points up to date, and joins those of all processes in their order; all of them call
  // it. nullptr: those of this one. Then the rows of all.
  void Share(vtkMultiProcessController* controller);
  const std::vector<double>& GetSharedRows() const
  {
    return this->Shared ? this->All : this->Rows;
  }
  int GetRowWidth() const
  {
    return this->Width;
  }
#endif

protected:
  vtkRelievoPointValues();
  ~vtkRelievoPointValues() override;

  struct Value
  {
    std::string Name;
    int Components;      // 1, or 3 of a colour, whose arrays may have a fourth and may be bytes
    std::string Expects; // in words: "one length per point"
    double ForAll[3];
    std::string Array;
  };

  // Adds a value; for constructors.
  void AddValue(const std::string& name, int components, const std::string& expects, double forAll);

  void SetForAll(int value, const double* forAll);
  const double* GetForAll(int value) const
  {
    return this->Values[value].ForAll;
  }

  // When the rows were made.
  vtkMTimeType GetRowsTime() const
  {
    return this->RowsTime.GetMTime();
  }

  // Whether the thing of this row does anything.
  virtual bool HasEffect(const double* row) const = 0;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoPointValues(const vtkRelievoPointValues&) = delete;
  void operator=(const vtkRelievoPointValues&) = delete;

  void Take(vtkDataSet* data);
  void Fill(vtkDataSet* data, const Value& value, double* column);
  void ReportOnce(const std::string& words);

  std::vector<Value> Values;
  vtkSmartPointer<vtkMatrix4x4> UserMatrix;
  std::vector<double> Rows;
  std::vector<double> All; // of all processes
  bool Shared = false;
  vtkMTimeType SharedTime = 0; // RowsTime of what All has
  std::set<std::string> Reported;
  vtkTimeStamp RowsTime;
  int Width = 3;
  int NumberLeftOut = 0;
};

#endif
