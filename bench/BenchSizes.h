// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchSizes.h
 * @brief Sizes of benches: those of the charts, and smaller ones for tests.
 */
#ifndef relievoBenchSizes_h
#define relievoBenchSizes_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace relievoBench
{
struct NormalSizes
{
  std::size_t Uniform = 10000000; // directions
  std::size_t Special = 600000;   // at and near axes and seams
};

struct PositionSizes
{
  int Rounds = 25;
};

struct EnvironmentSizes
{
  int Looks = 100000;
  int Turns = 4; // random rotations of the environment against the map
  std::vector<int> Sides = { 8, 16, 32, 64, 128 }; // of a cube's face; the last but one by angle
  double Detail =
    1000.; // a texel is sampled Detail / sqrt(texels) times in each direction, 3 to 40
  bool RealWorlds = true;
  int Sky = 256; // texels: height of the equirectangular image of the timed frames
  int Width = 1280;
  int Height = 720;
  int Rounds = 31;
};

struct ReliefSizes
{
  int Texels = 512;
  int FullCells = 1024; // of the full geometry, in each direction
  int Width = 600;
  int Height = 450;
  int Rounds = 15;
  std::vector<double> Angles = { 0., 45., 60., 75., 80. }; // degrees; charts show 60
};

struct LightSizes
{
  std::vector<std::string> Scenes = { "bunny", "motorBike", "buildings" };
  std::vector<int> Lamps = { 1, 10, 100, 1000, 10000, 100000 };
  int MostAll = 1000; // lamps up to which every pixel also computes all of them
  int MostPeer = 100; // VTK lights: its shaders are compiled for their number
  std::vector<int> Casting = { 0, 1, 4, 8 }; // of eight lamps, in BenchLampShadows
  int Pixels = 600;
  int Rounds = 11;
};

struct DeferredSizes
{
  std::vector<int> Overdraw = { 1, 2, 4, 8, 16 };
  std::vector<int> Lights = { 1, 8, 32 };
  int Pixels = 600;
  int Rounds = 15;
};

struct ToneSizes
{
  int Side = 256;  // pixels of the picture with light of every kind
  int Rounds = 31; // of timed frames; 0: not timed
};

struct EffectSizes
{
  std::vector<std::string> Meshes = { "armadillo", "bunny" };
  int Width = 900;
  int Height = 600;
  int Rounds = 31;
};

struct FogSizes
{
  int Rays = 200000; // for each distance
  std::vector<double> Distances = { 2., 5., 10., 30., 100., 300., 1e3, 1e4, 1e5 }; // in radii
  std::vector<std::string> Meshes = { "bunny", "motorBike", "buildings" };
  int Width = 800;
  int Height = 600;
  int Rounds = 21;
};

struct BlockSizes
{
  std::vector<int> Sizes = { 32, 64, 128 }; // blocks each way; charts show the last
  int Rounds = 11;
  std::vector<std::string> Data = { "aal.nii.gz", "inia19-NeuroMaps.nii.gz", "liver.inr",
    "skull_2.9.inr" };
};

struct CaveSizes
{
  int Side = 192;                                             // samples
  std::vector<double> Scales = { 16., 32., 64., 128., 256. }; // samples across a cell of the noise
  std::vector<double> Widths = { 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5 }; // fractions of Scale
  double Across = 12.; // samples across tunnels whose width is measured
  int Rounds = 5;
  int Seeds = 24;
};

struct SoftShadowSizes
{
  // All but the first only under the sun.
  std::vector<std::string> Scenes = { "bunny", "motorBike", "buildings", "spheres", "horizon" };
  std::vector<int> Samples = { 1, 4, 16, 64, 256 };
  int Width = 240;
  int Height = 180;
};

struct EmptySpaceSizes
{
  std::vector<int> Sizes = { 128 }; // voxels along an axis
  std::vector<double> Shares = { 0.01, 0.03, 0.1, 0.3 };
  int Pixels = 400; // each side of a frame
  int Rounds = 3;
};

struct ExactHardSizes
{
  std::vector<std::string> Scenes = { "fins", "folds", "arrows", "tree", "bunny", "motorBike" };
  int Width = 1000;
  int Height = 800;
};

struct PlannerCaseSizes
{
  int Scenes = 54; // with 5 tolerances each
  unsigned int Seed = 1;
  int Width = 560;
  int Height = 420;
};

struct AmbientSizes
{
  std::vector<std::string> Scenes = { "bunny", "room" };
  std::vector<int> Samples = { 1, 4, 16, 64, 256 };
  int Width = 320;
  int Height = 240;
  int TruthSide = 32; // squared: rays per pixel
  int Rounds = 5;
};

struct PlannerSizes
{
  std::vector<std::string> Scenes; // none: all
  std::vector<int> Maps = { 1024, 2048, 4096, 8192 };
  std::vector<std::pair<int, int>> Windows = { { 600, 600 }, { 800, 450 }, { 400, 1000 },
    { 320, 240 } };
  int Lights = 4; // of sun, low sun, spot, point
  int Rounds = 5;
};

struct VoxelSizes
{
  std::vector<int> Sizes = { 25, 50, 100 }; // cells along the longest side
  int Slow = 25;                            // cells up to which slow peers are measured
  double Chord = 2e-4;                      // distance between triangles and the bodies
  int Rounds = 5;
  std::vector<std::string> Meshes = { "bunny" };
  int Large = 300; // cells each way for a sphere of 1.3 million triangles; 0: without
};

struct RaySizes
{
  int Rays = 20000;
  int Rounds = 25;
  std::vector<std::string> Meshes = { "bunny", "armadillo", "elephant" };
  int Divisions = 2; // of the bunny's triangles, into four each time
};

struct SunSizes
{
  int Side = 48;                                              // of the courtyard's floor, in cells
  std::vector<double> Steps = { 60., 30., 20., 10., 5., 2. }; // minutes
  std::vector<int> Samples = { 4, 16, 64, 256, 1024, 4096 };
  double TruthStep = 2.; // seconds
  int Rounds = 7;
};

struct ParticleSizes
{
  std::vector<int> Numbers = { 1000, 10000, 100000, 1000000 };
  int MostPeer = 100000; // particles up to which the closest point is measured
  int Rounds = 7;
  int Resolution = 256; // texels along the longest side
  double Chord = 2e-4;  // distance between triangles and the torus
  std::vector<std::string> Meshes = { "bunny" };
  int DriftNumber = 1000;
  std::vector<int> Steps = { 1, 10, 100, 1000 };
};

struct SkinSizes
{
  int Points = 1000000;
  int Rounds = 9;
  std::vector<int> Bones = { 4, 32, 100, 1000 };
};

/** Benches with other sizes; RelievoBenchEnvironment and so on use those of the charts. */
int BenchNormals(const std::string& outDir, const NormalSizes& sizes);
int BenchPosition(const std::string& outDir, const PositionSizes& sizes);
int BenchEnvironment(const std::string& outDir, const EnvironmentSizes& sizes);
int BenchRelief(const std::string& outDir, const ReliefSizes& sizes);
int BenchLights(const std::string& outDir, const LightSizes& sizes);
int BenchLightsPeer(const std::string& outDir, const LightSizes& sizes);
int BenchLampShadows(const std::string& outDir, const LightSizes& sizes);
int BenchDeferred(const std::string& outDir, const DeferredSizes& sizes);
int BenchTone(const std::string& outDir, const ToneSizes& sizes);
int BenchBlocks(const std::string& outDir, const BlockSizes& sizes);
int BenchCaves(const std::string& outDir, const CaveSizes& sizes);
int BenchVoxels(const std::string& outDir, const VoxelSizes& sizes);
int BenchRays(const std::string& outDir, const RaySizes& sizes);
int BenchSun(const std::string& outDir, const SunSizes& sizes);
int BenchSkin(const std::string& outDir, const SkinSizes& sizes);
int BenchParticles(const std::string& outDir, const ParticleSizes& sizes);
int BenchSoftShadows(const std::string& outDir, const SoftShadowSizes& sizes);
int BenchEmptySpace(const std::string& outDir, const EmptySpaceSizes& sizes);
int BenchExactHard(const std::string& outDir, const ExactHardSizes& sizes);
int BenchAmbient(const std::string& outDir, const AmbientSizes& sizes);
int BenchPlanner(const std::string& outDir, const PlannerSizes& sizes);
int BenchEffects(const std::string& outDir, const EffectSizes& sizes);
int BenchPlannerCases(const std::string& outDir, const PlannerCaseSizes& sizes);
int BenchFog(const std::string& outDir, const FogSizes& sizes);

/** Times the frames of BenchEnvironment; false if the file could not be written. */
bool BenchEnvironmentFrames(const std::string& outDir, const EnvironmentSizes& sizes);

/** Times BenchBlocks by threads; false if the file could not be written. */
bool BenchBlockThreads(const std::string& outDir, const BlockSizes& sizes);
}

#endif
