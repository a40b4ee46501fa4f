// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPointValues
 * @brief Points with a few values each, from data: the base class of lamps and fog spheres.
 *
 * Input: any vtkDataSet (usually vtkPolyData) or composite dataset. Each point is one object. A
 * value comes from a point array, by default the array of the value's name, or is constant for all
 * points. Ghosts, and points whose position or values are not finite, or whose colour is negative,
 * are left out and counted.
 *
 * A subclass describes its values once, in its constructor; the command line, Python, ParaView and
 * the viewer use this description.
 *
 * Errors, once each: a named array that does not exist, or has a wrong number of components or a
 * wrong length; the constant value is used instead.
 */
#ifndef vtkRelievoPointValues_h
#define vtkRelievoPointValues_h

#include "vtkAlgorithm.h"
#include "vtkRelievoFrameModule.h"   // for the export macro
#include "vtkRelievoParameterList.h" // for the description
#include "vtkRelievoReportOnce.h"    // for errors
#include "vtkRelievoText.h"          // for names that are given
#include "vtkSmartPointer.h"         // for the matrix

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

  /** The points, as data without a pipeline; nullptr for none. */
  void SetInputData(vtkDataObject* data);

  ///@{
  /**
   * The point array for a value, such as "radius". Default: the array of that name, if there is
   * one. "" selects the constant value.
   */
  void SetArray(RELIEVO_TEXT value, RELIEVO_TEXT array);
  std::string GetArray(RELIEVO_TEXT value);
  ///@}

  ///@{
  /**
   * Parameters by name: values of points, and others that all points share. Words are numbers
   * ("0.5", "1,0.5,0"), a choice, or for a value of points the name of a point array. Set returns
   * false, with an error, and changes nothing if there is no such parameter or the words are
   * invalid. The default is that of new points without an array of the value's name.
   */
  int GetNumberOfParameters() { return this->Description.GetNumber(); }
  std::string GetParameterName(int i) { return this->Description.GetName(i); }
  std::string GetParameterHelp(RELIEVO_TEXT name) { return this->Description.GetHelp(name); }
  std::string GetParameterDefault(RELIEVO_TEXT name) { return this->Description.GetDefault(name); }
  std::string GetParameter(RELIEVO_TEXT name);
  bool SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);
  ///@}

  /** Sets a parameter, and returns an error message instead of reporting it; "" on success. */
  std::string TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);

  /** Whether the parameter accepts a point array's name. */
  bool IsPerPoint(RELIEVO_TEXT name);

  /** For a parameter that depends on another one, the condition: "falloff=vtk"; else "". */
  std::string GetParameterCondition(RELIEVO_TEXT name)
  {
    return this->Description.GetCondition(name);
  }

  /** Name of the objects: "lamps". */
  std::string GetThings() { return this->Things; }

  /** Requirements for a point to have an effect: "places must be finite, radii above 0". */
  std::string GetNeeds() { return this->Needs; }

  ///@{
  /**
   * Position of the data in the world, see vtkProp3D: moves the points, but changes no other
   * values. Default nullptr: the data is in world coordinates.
   */
  virtual void SetUserMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetUserMatrix();
  ///@}

  /** Updates the points; returns their number. */
  int GetNumberOfPoints();

  vtkMTimeType GetMTime() override;

  /** Updates the points; returns the time of the last change of points or settings. */
  vtkMTimeType GetUpdatedTime();

  /** Number of points left out: position or value not finite, negative colour, or no effect. */
  vtkGetMacro(NumberLeftOut, int);

#ifndef __VTK_WRAP__
  // The description of the parameters.
  const vtkRelievoParameterList& GetDescription() const
  {
    return this->Description;
  }

  // Row by row: x, y, z, and the values in order. Up to date after GetNumberOfPoints.
  const std::vector<double>& GetRows() const
  {
    return this->Rows;
  }

  // Updates the points, and joins those of all processes in order; a collective call. With nullptr
  // only this process's points. GetSharedRows() returns the joined rows.
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

  ///@{
  // For constructors: the name of the objects, and their values in the order of the rows. A value
  // has one component, or the three of a colour, whose arrays may have a fourth and may hold bytes.
  // A choice is stored as the number of its first option, or the following numbers.
  void SetThings(const std::string& things, const std::string& needs);
  vtkRelievoParameter& AddValue(const std::string& name, double forAll, double least, double most,
    const std::string& unit, const std::string& help);
  void AddColorValue(const std::string& name, const double forAll[3], const std::string& help);
  void AddChoiceValue(const std::string& name, const std::vector<std::string>& choices, int first,
    int forAll, const std::string& help);
  ///@}

  // Values, and parameters that all points share.
  vtkRelievoParameterList Description;

  void SetForAll(int value, const double* forAll);
  const double* GetForAll(int value) const
  {
    return this->Values[value].ForAll;
  }

  // Time at which the rows were made.
  vtkMTimeType GetRowsTime() const
  {
    return this->RowsTime.GetMTime();
  }

  // Whether the object of this row has any effect.
  virtual bool HasEffect(const double* row) const = 0;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoPointValues(const vtkRelievoPointValues&) = delete;
  void operator=(const vtkRelievoPointValues&) = delete;

  struct Value
  {
    std::string Name;
    int Components;
    double ForAll[3];
    std::string Array;
  };

  vtkRelievoParameter& AddPerPoint(
    const vtkRelievoParameter& parameter, const double* forAll, double first);
  const Value* FindValue(const std::string& name) const;
  void Take(vtkDataSet* data);
  bool HasColors(const double* row) const;
  void Fill(vtkDataSet* data, const Value& value, double* column);

  std::vector<Value> Values;
  std::string Things;
  std::string Needs;
  vtkSmartPointer<vtkMatrix4x4> UserMatrix;
  std::vector<double> Rows;
  std::vector<double> All; // of all processes
  bool Shared = false;
  vtkMTimeType SharedTime = 0; // RowsTime of the rows in All
  vtkRelievoReportOnce Reported;
  vtkTimeStamp RowsTime;
  int Width = 3;
  int NumberLeftOut = 0;
};

#endif
