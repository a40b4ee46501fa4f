// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Renderer.h
 * @brief The renderer of a folder of tables, named in summaries and by charts.py.
 */
#ifndef relievoBenchRenderer_h
#define relievoBenchRenderer_h

#include <string>

namespace relievoBench
{
/**
 * Writes the name of OpenGL's renderer, or "software OpenGL" if the processor draws, into
 * FOLDER/renderer.txt. Needs a display. False, with a message on the standard error, if that cannot
 * be written.
 */
bool WriteRenderer(const std::string& folder);

/** The content of FOLDER/renderer.txt; "software OpenGL" if it is missing. */
std::string ReadRenderer(const std::string& folder);

/** The name in a report by vtkRenderWindow::ReportCapabilities; empty if it has none. */
std::string FindRenderer(const std::string& report);
}

#endif
