// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPointValues
 * @brief Points with a few values each, from data: what lamps and fog spheres are made of.
 *
 * Input: any vtkDataSet (vtkPolyData usually) or composite dataset. Each point is one thing. A
 * value comes from a point array, by default the array of the value's name, or is one for all
 * points. Points whose place or values are not finite, or whose colour is negative, and ghosts, are
 * left out and counted.
 *
 * A class that derives from it describes its values once, in its constructor; the command line,
 * Python, ParaView and the viewer take them from there.
 *
 * Errors, once each: an array that was named and does not exist, or is not of the right number of
 * components or length; the one value for all is taken instead.
 */
#ifndef vtkRelievoPointValues_h
#define vtkRelievoPointValues_h

#include "vtkAlgorithm.h"
#include "vtkRelievoFrameModule.h"   // for the export macro
#include "vtkRelievoParameterList.h" // for the description
#include "vtkRelievoText.h"          // for names that are given
#include "vtkSmartPointer.h"         // for the matrix

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
  void SetArray(RELIEVO_TEXT value, RELIEVO_TEXT array);
  std::string GetArray(RELIEVO_TEXT value);
  ///@}

  ///@{
  /**
   * Parameters by name: values of points, and others that all points share. Words are numbers
   * ("0.5", "1,0.5,0"), a choice, or for a value of points the name of a point array. Set returns
   * false, with an error, and changes nothing if there is no such parameter or it does not take the
   * words. The default is that of new points, where they have no array of the value's name.
   */
  int GetNumberOfParameters() { return this->Description.GetNumber(); }
  std::string GetParameterName(int i) { return this->Description.GetName(i); }
  std::string GetParameterHelp(RELIEVO_TEXT name) { return this->Description.GetHelp(name); }
  std::string GetParameterDefault(RELIEVO_TEXT name) { return this->Description.GetDefault(name); }
  std::string GetParameter(RELIEVO_TEXT name);
  bool SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);
  ///@}

  /** Sets a parameter, and returns what is wrong instead of reporting it; "" if it was set. */
  std::string TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);

  /** Whether the name of a point array gives each point its own value. */
  bool IsPerPoint(RELIEVO_TEXT name);

  /** "falloff=vtk" of a parameter that has no effect where falloff is another; "" of others. */
  std::string GetParameterCondition(RELIEVO_TEXT name)
  {
    return this->Description.GetCondition(name);
  }

  /** What the points are: "lamps". */
  std::string GetThings() { return this->Things; }

  /** What a point must be so that it has an effect: "places must be finite, radii above 0". */
  std::string GetNeeds() { return this->Needs; }

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

  /** Points left out: the place or a value is not finite, a colour negative, or has no effect. */
  vtkGetMacro(NumberLeftOut, int);

#ifndef __VTK_WRAP__
  // What the points say of their parameters.
  const vtkRelievoParameterList& GetDescription() const
  {
    return this->Description;
  }

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

  ///@{
  // For constructors: what the points are, and their values in the order of the rows. A value has
  // one component, or three of a colour, whose arrays may have a fourth and may be bytes. A choice
  // of points is the number of its first choice, or the next ones.
  void SetThings(const std::string& things, const std::string& needs);
  vtkRelievoParameter& AddValue(const std::string& name, double forAll, double least, double most,
    const std::string& unit, const std::string& help);
  void AddColorValue(const std::string& name, const double forAll[3], const std::string& help);
  void AddChoiceValue(const std::string& name, const std::vector<std::string>& choices, int first,
    int forAll, const std::string& help);
  ///@}

  // Of the values, and of parameters that all points share.
  vtkRelievoParameterList Description;

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
  void ReportOnce(const std::string& words);

  std::vector<Value> Values;
  std::string Things;
  std::string Needs;
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
