// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoComparisonReport
 * @brief Reports comparisons of frames: as a page for browsers, and as Markdown for pull requests.
 *
 * Add() adds the result and the frames of a vtkRelievoFrameComparison; a report can hold several,
 * such as those of two folders. The page needs no other file and no network. It shows both
 * pictures, with a slider or flickering, the pixels coloured by cause, a table whose rows highlight
 * their pixels, and the colours, the object and the depth under the mouse. Depths are rounded to
 * 17 bits, which are five digits; everything else is exact. A page of 800 x 600 pixels takes about
 * 1 MB.
 *
 * Names of files and objects are escaped in both formats.
 */
#ifndef vtkRelievoComparisonReport_h
#define vtkRelievoComparisonReport_h

#include "vtkObject.h"
#include "vtkRelievoCompareModule.h" // for the export macro

#include <memory> // for private data
#include <string> // for texts

class vtkRelievoFrameComparison;

class VTKRELIEVOCOMPARE_EXPORT vtkRelievoComparisonReport : public vtkObject
{
public:
  static vtkRelievoComparisonReport* New();
  vtkTypeMacro(vtkRelievoComparisonReport, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds the result of a comparison's last Compare() under a name, such as its files. Without
   * `withFrames` the page has only the table, and is small.
   */
  void Add(const char* name, vtkRelievoFrameComparison* comparison, bool withFrames = true);

  /** Adds a pair that was not compared, as a difference, with a reason like "missing in base". */
  void AddNotCompared(const char* name, const char* reason);

  ///@{
  /** Returns the report on all added comparisons. */
  std::string GetHTML();
  std::string GetMarkdown();
  ///@}

#ifndef __VTK_WRAP__
  ///@{
  /**
   * Shares of light and colour, 0 to 1, for pages and other views: what remains of the grey picture
   * behind coloured causes, and of the picture around a chosen cause; and how much of the chosen
   * cause's colour is mixed into its pixels.
   */
  static constexpr double BehindCauses = 0.4;
  static constexpr double AroundChosen = 0.5;
  static constexpr double OfChosen = 0.7;
  ///@}
#endif

protected:
  vtkRelievoComparisonReport();
  ~vtkRelievoComparisonReport() override;

private:
  vtkRelievoComparisonReport(const vtkRelievoComparisonReport&) = delete;
  void operator=(const vtkRelievoComparisonReport&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
