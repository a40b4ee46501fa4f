// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoComparisonReport
 * @brief Shows comparisons of frames: as a page for browsers, and as Markdown for pull requests.
 *
 * Add() takes what a vtkRelievoFrameComparison found, with its frames; several may follow each
 * other, such as those of two folders. The page needs no other file and no network: it has both
 * pictures, with a slider or flickering, the pixels coloured by cause, a table whose rows highlight
 * their pixels, and the colours, the object and the depth under the mouse. Depths are rounded to
 * 17 bits, which are five digits; everything else is exact. A page of 800 x 600 pixels takes about
 * 1 MB.
 *
 * Names of files and objects are data in both: no HTML, and no Markdown.
 */
#ifndef vtkRelievoComparisonReport_h
#define vtkRelievoComparisonReport_h

#include "vtkObject.h"
#include "vtkRelievoCompareModule.h" // for the export macro

#include <memory> // for what is private
#include <string> // for texts

class vtkRelievoFrameComparison;

class VTKRELIEVOCOMPARE_EXPORT vtkRelievoComparisonReport : public vtkObject
{
public:
  static vtkRelievoComparisonReport* New();
  vtkTypeMacro(vtkRelievoComparisonReport, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds the result of the last Compare() of a comparison under a name, such as its files. Without
   * `withFrames` the page has its table only, which is small.
   */
  void Add(const char* name, vtkRelievoFrameComparison* comparison, bool withFrames = true);

  /** Adds a frame that one side lacks, which is a difference: `missingIn` is that side's name. */
  void AddMissing(const char* name, const char* missingIn);

  ///@{
  /** All that was added. */
  std::string GetHTML();
  std::string GetMarkdown();
  ///@}

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
