// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MotionOptions.h"

#include "OptionRows.h"
#include "Readers.h"
#include "Values.h"
#include "VideoFile.h"

namespace scene
{
namespace
{
void TakeVideo(MotionChoice& motion, const std::string& word)
{
  const std::string extension = ExtensionOf(word);
  if (extension != VideoFile::H264 && extension != VideoFile::FFV1)
  {
    RefuseValue("--video", word,
      std::string("a name that ends in ") + VideoFile::H264 + " (H.264) or " + VideoFile::FFV1 +
        " (FFV1, lossless)");
  }
  motion.Video = word;
}
}

//------------------------------------------------------------------------------
void AddMotionOptions(OptionRows& rows, MotionChoice& motion)
{
  vtkRelievoOption& turn = rows.Add("--turntable", "N",
    "draws N frames while the camera goes once around the scene, about the up axis, "
    "counter-clockwise seen from above; the names of --png, --exr, --baseline and --report must "
    "contain %d or %04d, the frame number from 0. The fitted camera sees the scene in all frames",
    [&motion](
      const std::string& word) { motion.Turntable = ParseWhole("--turntable", word, 2, 1000000); });
  turn.OfOutputs = true;
  vtkRelievoOption& path = rows.AddText("--camera-path", "F",
    "draws frames of a camera that moves through the views of a JSON or CSV file, from the first "
    "one's time to the last one's by --fps, or at --times",
    motion.Path);
  path.OfOutputs = true;
  path.Files = "json|csv";
  vtkRelievoOption& video = rows.Add("--video", "F",
    "a film of the frames of --turntable, --camera-path or --times: .mp4 (H.264) or .mkv (FFV1, "
    "lossless). The program ffmpeg makes it; where it is missing, the frames are written as PNG "
    "files beside it",
    motion, TakeVideo);
  video.OfOutputs = true;
  video.Files = "mp4|mkv";
  rows.AddNumber("--fps", "N", "frames per second of --video and --camera-path, @bounds@ (25)",
    { 0.1, 1000.0 }, motion.FramesPerSecond);
  rows.Command.Options.back().OfOutputs = true;
  rows
    .AddFlag("--resume",
      "draws only the frames whose files do not exist, after an interrupted run; whether the "
      "existing files were drawn with the same options is not checked",
      motion.Resume)
    .OfOutputs = true;
}
}
