// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Calibration files in other forms than YAML and JSON, converted to JSON objects.
#ifndef vtkRelievoCalibrationForms_h
#define vtkRelievoCalibrationForms_h

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace vtkRelievoCalibrationForms
{
constexpr int MostDepth = 8; // of nested lists and objects

// Unpacks gzip data. False if the data are invalid or incomplete, or have more than `most` bytes.
bool Unpack(std::string& bytes, std::size_t most);

// The entries of OpenCV's cv::FileStorage in XML; null if the text is no such file.
nlohmann::json ReadXML(const std::string& text);

// The only camera of COLMAP's cameras.txt, whose first pixel has its centre at (0.5, 0.5), in
// OpenCV's terms. `error` receives an error message, or remains empty.
nlohmann::json ReadCOLMAP(const std::string& text, std::string& error);
}

#endif
