// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The page of vtkRelievoComparisonReport, made from page/report.html.
#ifndef vtkRelievoReportPage_h
#define vtkRelievoReportPage_h

namespace relievo::compare
{
// The comparisons replace `@DATA@`, as JSON.
extern const char* const ReportPage;
}

#endif
