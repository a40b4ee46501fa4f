// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A camera that moves through views at given times, as a file of keys.
 */
#ifndef CameraPath_h
#define CameraPath_h

#include "CameraOptions.h"
#include "SceneNames.h"

#include <string>
#include <vector>

namespace scene
{
struct CameraKey
{
  double Time; ///< seconds
  CameraPlace Place;
};

/// Between keys the focal point and the direction of view follow smooth curves (cubic, with
/// continuous velocity); the distance and the up direction never leave the range between two keys.
/// A path whose last view equals its first one is closed: the velocity there is continuous as well.
class CameraPath
{
public:
  /// Throws UsageError for fewer than two keys, for times that do not grow, and for views between
  /// which the camera or its up direction would have to turn by 180 degrees. `name` begins errors.
  CameraPath(const std::vector<CameraKey>& keys, const std::string& name);

  /// Reads JSON or CSV, by the file's extension; throws UsageError or FileError.
  static CameraPath Read(const std::string& file);

  const std::vector<CameraKey>& GetKeys() const { return this->Keys; }
  bool IsClosed() const;

  /// The view at a time; before the first key and behind the last one, theirs.
  CameraPlace Find(double time) const;

  /// Times of frames at this rate from the first key to the last one; a closed path ends before it
  /// repeats its first view.
  std::vector<double> GetTimes(double framesPerSecond) const;

private:
  std::vector<CameraKey> Keys;
};

/// The keys as the CSV that CameraPath::Read takes.
std::string WriteTable(const std::vector<CameraKey>& keys);
}

#endif
