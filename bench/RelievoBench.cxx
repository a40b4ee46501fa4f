// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RelievoBench.h"

#include "Charts.h"
#include "Renderer.h"
#include "Table.h"

#include <iostream>

namespace
{
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
    { "gbuffer", "what layers cost a frame, against VTK's plain frame", RelievoBenchGBuffer },
    { "effects", "what the first of each effect costs a frame, alone and in pairs",
      RelievoBenchEffects },
    { "capture", "capture of depth, normal and cell against VTK's own means", RelievoBenchCapture },
    { "shadow-frames", "what shadows cost a frame, still and moving, against a peer",
      RelievoBenchShadowFrames },
    { "shadows", "wrong shadows against map size and frame time, every method and light",
      RelievoBenchShadows },
    { "soft-shadows", "error of soft shadows against samples of the lights' shapes",
      RelievoBenchSoftShadows },
    { "exact-hard", "wrong exact shadows where edges lie densely, against what is expected",
      RelievoBenchExactHard },
    { "ambient", "error of ambient occlusion against time of a frame, beside VTK's own",
      RelievoBenchAmbient },
    { "planner", "what the planner of shadows expects and chooses against what there is",
      RelievoBenchPlanner },
    { "planner-cases", "how often shadows that are chosen for a tolerance meet it, by lot",
      RelievoBenchPlannerCases },
    { "bias", "false shadow against leak as the shadows' bias grows", RelievoBenchBias },
    { "lights", "what lamps cost a frame, 1 to 100 000, by the way they are found",
      RelievoBenchLights },
    { "lights-peer",
      "lamps against 100 and 300 lights of VTK's, and what their shaders' compiler takes",
      RelievoBenchLightsPeer },
    { "lamp-shadows", "what shadows of 1 to 8 lamps cost a frame, still and moving",
      RelievoBenchLampShadows },
    { "deferred", "deferred shading against VTK's own, by overdraw and number of lights",
      RelievoBenchDeferred },
    { "relief", "what relief methods miss, against looks, time and full geometry",
      RelievoBenchRelief },
    { "normal-maps", "what a normal map costs a frame, against VTK's own textures",
      RelievoBenchNormalMaps },
    { "environment", "error of environments against texels and angle; what a mirror costs",
      RelievoBenchEnvironment },
    { "tone", "error and hue of tone operators, bands with and without dithering, frames",
      RelievoBenchTone },
    { "fog", "error of a fog sphere's chord against distance; what fog costs a frame",
      RelievoBenchFog },
    { "blocks", "error of surfaces of labels against time, beside VTK's own", RelievoBenchBlocks },
    { "caves", "evaluations of noise and time for caves; width of tunnels against what was asked",
      RelievoBenchCaves },
    { "voxels", "cells inside bodies: excess and missed against time, beside VTK's own",
      RelievoBenchVoxels },
    { "rays", "rays a second of a core past meshes, and bytes, beside Embree's", RelievoBenchRays },
    { "sun", "error of hours of sun by step, and of the sky's share by rays", RelievoBenchSun },
    { "skin", "error of bones by keys per second; volume of twist and bend; time of points",
      RelievoBenchSkin },
    { "particles", "particles on surfaces: time of a step by number, and drift by steps",
      RelievoBenchParticles },
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
      return status == 0 && !relievoBench::DrawCharts(name, outDir) ? 1 : status;
    }
  }
  return RefuseName(name);
}
