// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RelievoBench.h
 * @brief The benches by name: each measures and writes CSV, from which charts are drawn (Charts.h).
 * Some are Python scripts (Scripts.h).
 */
#ifndef RelievoBench_h
#define RelievoBench_h

#include <string>
#include <vector>

/** A bench: its name on the command line, a line that describes it, and its function. */
struct RelievoBenchEntry
{
  const char* Name;
  const char* What;
  int (*Run)(const std::string& outDir);
  const char* Script = nullptr; // a Python bench: its file
};

/** All benches, in the order of their list. */
const std::vector<RelievoBenchEntry>& RelievoBenchEntries();

/**
 * Runs one bench. Its files, and the renderer's name (Renderer.h), are written into outDir, which
 * is made if missing. Progress and measured values go to the standard output, errors to the
 * standard error. Most benches need a display. Returns 0 when done, 1 if the work failed, 2 if
 * there is no bench of that name.
 */
int RelievoBench(const std::string& name, const std::string& outDir);

/** Chart 1: error of the normal formats against bits and time. About half a minute. */
int RelievoBenchNormals(const std::string& outDir);

/** Chart 2: error of the depth formats against bytes and far / near. A few seconds. */
int RelievoBenchDepth(const std::string& outDir);

/** Chart 3: error of positions against bytes and frame time, by stored format. Under a minute. */
int RelievoBenchPosition(const std::string& outDir);

/** Cost of layers per frame, against a plain frame and a peer. A few minutes. */
int RelievoBenchGBuffer(const std::string& outDir);

/** Capture of depth, normal and cell against z and cells by VTK's own means. About a minute. */
int RelievoBenchCapture(const std::string& outDir);

/** Cost of shadows per frame, still and moving, against a plain frame and a peer. Minutes. */
int RelievoBenchShadowFrames(const std::string& outDir);

/** Chart 4: wrong shadow verdicts against map size and frame time. A few minutes. */
int RelievoBenchShadows(const std::string& outDir);

/**
 * Expected and measured errors and times of the shadow planner, and its choices. A quarter of an
 * hour.
 */
int RelievoBenchPlanner(const std::string& outDir);

/** How often shadows chosen for a tolerance meet it, in random cases. Two minutes. */
int RelievoBenchPlannerCases(const std::string& outDir);

/** Chart 5: false shadow against leak as the bias grows, three heights of the sun. Minutes. */
int RelievoBenchBias(const std::string& outDir);

/** Chart 11: error of soft shadows against samples. Some minutes. */
int RelievoBenchSoftShadows(const std::string& outDir);

/** Frames of volumes whose transparent parts are skipped, beside VTK's. Three minutes. */
int RelievoBenchEmptySpace(const std::string& outDir);

/** Errors of exact shadows where edges lie densely, against expected errors. A minute. */
int RelievoBenchExactHard(const std::string& outDir);

/** Error of ambient occlusion against time, by rays, beside VTK's own. Two minutes. */
int RelievoBenchAmbient(const std::string& outDir);

/** Chart 8: error of environments against texels and angle, by the map; frames. Three minutes. */
int RelievoBenchEnvironment(const std::string& outDir);

/** Chart 6: frames with 1 to 100 000 lamps, by the method of finding them. Ten minutes. */
int RelievoBenchLights(const std::string& outDir);

/** Lamps against 100 and 300 VTK lights. Five minutes, because of its shaders' compilation. */
int RelievoBenchLightsPeer(const std::string& outDir);

/** Frames in which 1 to 8 lamps cast shadows, against frames without shadows. A minute. */
int RelievoBenchLampShadows(const std::string& outDir);

/** Frames with deferred shading against VTK's own, by overdraw and lights. Two minutes. */
int RelievoBenchDeferred(const std::string& outDir);

/** Chart 7: errors of relief methods against reads and time, and full geometry. Minutes. */
int RelievoBenchRelief(const std::string& outDir);

/** Error of a fog sphere's chord against distance, and cost of fog per frame. A minute. */
int RelievoBenchFog(const std::string& outDir);

/** Chart 9: surfaces of labels: distance and normals against time, with peers. Two minutes. */
int RelievoBenchBlocks(const std::string& outDir);

/** Caves: evaluations of noise, time, shape, width of tunnels. A minute. */
int RelievoBenchCaves(const std::string& outDir);

/** Chart 10: cells inside bodies: excess and missed against time, with peers. A minute. */
int RelievoBenchVoxels(const std::string& outDir);

/** Rays per second and core at meshes of many sizes, and bytes, beside Embree's. A minute. */
int RelievoBenchRays(const std::string& outDir);

/** Hours of sun and sky of a courtyard: error and time by step and rays. A minute. */
int RelievoBenchSun(const std::string& outDir);

/** Bones: error by keys, volume of twist and bend, time of a million points. Half a minute. */
int RelievoBenchSkin(const std::string& outDir);

/** Particles on surfaces: time of a step, distance by steps, with a peer. Two minutes. */
int RelievoBenchParticles(const std::string& outDir);

/** Cost of a normal map in a full-screen frame, against VTK's own textures. Half a minute. */
int RelievoBenchNormalMaps(const std::string& outDir);

/** Cost of the first of each effect per frame, alone and in pairs, beside VTK's. A minute. */
int RelievoBenchEffects(const std::string& outDir);

/** Error and hue of tone operators, bands with and without dithering, frames. Half a minute. */
int RelievoBenchTone(const std::string& outDir);

#endif
