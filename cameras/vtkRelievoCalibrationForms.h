// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Forms of calibrations' files beside YAML and JSON, as the objects that those hold.
#ifndef vtkRelievoCalibrationForms_h
#define vtkRelievoCalibrationForms_h

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace vtkRelievoCalibrationForms
{
constexpr int MostDepth = 8; // of lists in lists, and objects in objects

std::string Trim(const std::string& text);

// Unpacks data of gzip. False if they are none, end early, or have more bytes than these.
bool Unpack(std::string& bytes, std::size_t most);

// The entries of OpenCV's cv::FileStorage in XML; null if it is none.
nlohmann::json ReadXML(const std::string& text);

// The one camera of a cameras.txt by COLMAP, whose first pixel has its centre at (0.5, 0.5), in
// OpenCV's terms. Faults are added in words; empty: none.
nlohmann::json ReadCOLMAP(const std::string& text, std::string& wrong);
}

#endif
