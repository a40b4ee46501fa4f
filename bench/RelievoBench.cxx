// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RelievoBench.h"

#include "VolumeSizes.h"

#include "Charts.h"
#include "Renderer.h"
#include "Scripts.h"
#include "Table.h"

#include <iostream>

namespace
{
using relievoBench::RunScript;
using relievoBench::ScriptPlace;

int RunCompare(const std::string& outDir)
{
  return RunScript("compare.py", { "--out", outDir }, "", { "--quick" });
}

int RunScale(const std::string& outDir)
{
  return RunScript(
    "scale.py", { ScriptPlace::Relievo, "--out", outDir + "/scale.csv" }, "", { "--small" });
}

int RunScalingOut(const std::string& outDir)
{
  return RunScript("scaling_out.py", {}, outDir + "/scaling-out.csv", { "--small" });
}

int RunIrradiation(const std::string& outDir)
{
  return RunScript("irradiation.py", {}, outDir + "/irradiation.csv", { "--small" });
}

const std::vector<std::string> FewRounds = { "--rounds", "3" };

int RunCommandStart(const std::string& outDir)
{
  return RunScript("command_start.py", { ScriptPlace::Relievo, ScriptPlace::Data },
    outDir + "/command-start.csv", FewRounds);
}

int RunF3D(const std::string& outDir)
{
  return RunScript("f3d_frames.py", { ScriptPlace::Data }, outDir + "/f3d.csv", FewRounds);
}

int RunStudio(const std::string& outDir)
{
  return RunScript("studio_samples.py", { ScriptPlace::Relievo, ScriptPlace::Data },
    outDir + "/studio.csv", FewRounds);
}

int RunReadable(const std::string& outDir)
{
  return RunScript("readable_colors.py", { ScriptPlace::Relievo, ScriptPlace::Data },
    outDir + "/readable.csv", {});
}

int RefuseName(const std::string& name)
{
  std::cerr << "relievo: bench: no bench '" << name << "'; there are:";
  for (const RelievoBenchEntry& entry : RelievoBenchEntries())
  {
    std::cerr << ' ' << entry.Name;
  }
  std::cerr << '\n';
  return 2;
}
}

//------------------------------------------------------------------------------
const std::vector<RelievoBenchEntry>& RelievoBenchEntries()
{
  static const std::vector<RelievoBenchEntry> entries = {
    { "normals", "error of the normal formats against bits and time", RelievoBenchNormals },
    { "depth", "error of the depth formats against bytes and far / near", RelievoBenchDepth },
    { "position", "error of positions against bytes and frame time", RelievoBenchPosition },
    { "gbuffer", "cost of layers per frame, against VTK's plain frame", RelievoBenchGBuffer },
    { "effects", "cost of the first of each effect per frame, alone and in pairs",
      RelievoBenchEffects },
    { "capture", "capture of depth, normal and cell against VTK's own means", RelievoBenchCapture },
    { "shadow-frames", "cost of shadows per frame, still and moving, against a peer",
      RelievoBenchShadowFrames },
    { "shadows", "wrong shadows against map size and frame time, every method and light",
      RelievoBenchShadows },
    { "soft-shadows", "error of soft shadows against samples of the lights' shapes",
      RelievoBenchSoftShadows },
    { "volumes", "light through volumes: error against time by method, frames beside VTK's",
      RelievoBenchVolumes },
    { "empty-space", "frames of volumes whose transparent parts are skipped, beside VTK's",
      RelievoBenchEmptySpace },
    { "exact-hard", "wrong exact shadows where edges lie densely, against expected errors",
      RelievoBenchExactHard },
    { "ambient", "error of ambient occlusion against time of a frame, beside VTK's own",
      RelievoBenchAmbient },
    { "planner", "expected and measured errors and times of the shadow planner, its choices",
      RelievoBenchPlanner },
    { "planner-cases", "how often shadows chosen for a tolerance meet it, in random cases",
      RelievoBenchPlannerCases },
    { "bias", "false shadow against leak as the shadows' bias grows", RelievoBenchBias },
    { "lights", "cost of 1 to 100 000 lamps per frame, by method of finding them",
      RelievoBenchLights },
    { "lights-peer", "lamps against 100 and 300 VTK lights, and compile time of their shaders",
      RelievoBenchLightsPeer },
    { "lamp-shadows", "cost of shadows of 1 to 8 lamps per frame, still and moving",
      RelievoBenchLampShadows },
    { "deferred", "deferred shading against VTK's own, by overdraw and number of lights",
      RelievoBenchDeferred },
    { "relief", "errors of relief methods against reads, time and full geometry",
      RelievoBenchRelief },
    { "normal-maps", "cost of a normal map per frame, against VTK's own textures",
      RelievoBenchNormalMaps },
    { "environment", "error of environments against texels and angle; cost of a mirror",
      RelievoBenchEnvironment },
    { "tone", "error and hue of tone operators, bands with and without dithering, frames",
      RelievoBenchTone },
    { "fog", "error of a fog sphere's chord against distance; cost of fog per frame",
      RelievoBenchFog },
    { "blocks", "error of surfaces of labels against time, beside VTK's own", RelievoBenchBlocks },
    { "caves", "evaluations of noise and time for caves; width of tunnels against the request",
      RelievoBenchCaves },
    { "voxels", "cells inside bodies: excess and missed against time, beside VTK's own",
      RelievoBenchVoxels },
    { "rays", "rays per second and core at meshes, and bytes, beside Embree's", RelievoBenchRays },
    { "sun", "error of hours of sun by step, and of the sky's share by rays", RelievoBenchSun },
    { "skin", "error of bones by keys per second; volume of twist and bend; time of points",
      RelievoBenchSkin },
    { "particles", "particles on surfaces: time of a step by number, and drift by steps",
      RelievoBenchParticles },
    { "compare", "faults in scenes that comparisons find and explain, beside other methods",
      RunCompare, "compare.py" },
    { "scale", "time and memory of whole commands by the size of the scene", RunScale, "scale.py" },
    { "scaling-out", "time of starts with files of ray trees, of many views, of camera places",
      RunScalingOut, "scaling_out.py" },
    { "irradiation", "error and time of irradiation, beside closed forms and pvlib", RunIrradiation,
      "irradiation.py" },
    { "command-start", "time of a command from its start to the picture", RunCommandStart,
      "command_start.py" },
    { "f3d", "time to load, to the first picture and per frame, beside F3D", RunF3D,
      "f3d_frames.py" },
    { "studio", "cost and error of the samples of the default preset", RunStudio,
      "studio_samples.py" },
    { "readable", "how far the colours of values in pictures are from the colour bar's",
      RunReadable, "readable_colors.py" },
  };
  return entries;
}

//------------------------------------------------------------------------------
int RelievoBench(const std::string& name, const std::string& outDir)
{
  for (const RelievoBenchEntry& entry : RelievoBenchEntries())
  {
    if (name == entry.Name)
    {
      if (!relievoBench::MakeFolder(outDir) || !relievoBench::WriteRenderer(outDir))
      {
        return 1;
      }
      const int status = entry.Run(outDir);
      const bool isMeasured = status == 0 && !relievoBench::IsScriptHelp();
      return isMeasured && !relievoBench::DrawCharts(name, outDir) ? 1 : status;
    }
  }
  return RefuseName(name);
}
