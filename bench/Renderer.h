// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Renderer.h
 * @brief What has drawn what a folder of tables measures: summaries and charts.py name it.
 */
#ifndef relievoBenchRenderer_h
#define relievoBenchRenderer_h

#include <string>

namespace relievoBench
{
/**
 * Writes into FOLDER/renderer.txt the name that OpenGL gives its renderer, or "software OpenGL"
 * where the processor draws. Needs a display. False, with a message on the standard error, if that
 * cannot be written.
 */
bool WriteRenderer(const std::string& folder);

/** What FOLDER/renderer.txt says; "software OpenGL" if there is none. */
std::string ReadRenderer(const std::string& folder);

/** The name in a report of VTK's (vtkRenderWindow::ReportCapabilities); empty: it has none. */
std::string FindRenderer(const std::string& report);
}

#endif
