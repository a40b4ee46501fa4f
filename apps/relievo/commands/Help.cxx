// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Help.h"

#include "Options.h"

namespace cli
{
namespace
{
const char* const Notes =
  R"(Options are written --name value or --name=value, those without a value alone; -- ends them.
Either all requested files are written, or none; of a sequence, those of each frame.
VTK before 9.4 needs an X display, which xvfb-run provides.
Exit status: 0 done, 1 the work failed, 2 the arguments were invalid; of compare 3, different.

Examples
  relievo render bunny.off --png bunny.png
  relievo render bunny.off --size 1920x1080 --light sun:3,5,2 --layers depth,normal,cell \
    --exr bunny.exr --report bunny.json
  relievo render wing.vtu --color-by Pressure --scalar-bar --preset print --png wing.png
  relievo render wing.vtu --parallel-scale 2 --layers depth,Pressure --exr wing.exr
  relievo render buildings.obj --light sun:3,2,5 --light point:120,90,99 --shadows map \
    --png town.png --layers shadow_0,shadow_1 --exr town.exr
  relievo render bunny.off --environment forest.exr,90 --skybox --png bunny.png
  relievo render buildings.obj --fog mist.vtp,density=0.01 --layers depth,fog --exr mist.exr
  relievo render buildings.obj --up z --markers sites.vtp,radius=30,shape=glow --png sites.png
  relievo render bike.obj --baseline bike.exr
  relievo compare bike.exr --render bike.obj
  relievo render walk.fbx --times 0:2:0.04 --shadows map --png walk_%03d.png
  relievo dataset mug.obj table.stl --poses random:500 --seed 7 --random-sun --out train/000000
  relievo visible bunny.off --poses orbit:24 -o seen.vtp
  relievo viewshed terrain.tif --observer 689300,5337200,2 -o seen.tif
  relievo sun town.obj --place 48.2,16.4 --dates 2026-06-21 --sky 256 -o sun.vtp
  relievo sun town.obj --place 48.2,16.4 --dates 2026-06-21 -o sun.vtp --part 3/8
  relievo merge sun.vtp.parts
  relievo cover site.obj --candidates masts.ply --places 6 -o covered.vtp --chosen cameras.vtp
  relievo view-factors floor.stl wall.stl roof.stl --tolerance 0.002 -o factors.csv
  relievo render sun.vtp --color-by sun_hours --scalar-bar --png sun.png
  relievo cave --size 256x128x256 --seed 7 -o cave.vti
  relievo bench normals --out charts
  relievo bench all --out here --beside docs/charts
)";
}

//------------------------------------------------------------------------------
Commands MakeCommands(const std::string& last)
{
  Commands made;
  for (const auto& make :
    { MakeRender, MakeCompare, MakeDataset, MakeVisible, MakeViewshed, MakeSun, MakeCover,
      MakeViewFactors, MakeMerge, MakeVerify, MakeStatus, MakeCave, MakeStages, MakeBench })
  {
    made.push_back(make());
    if (made.back()->Describe().Name == last)
    {
      break;
    }
  }
  return made;
}

//------------------------------------------------------------------------------
std::string GetHelpPage(const Commands& commands)
{
  std::string page = "relievo - pictures and measurable layers of meshes and grids\n\n";
  for (const auto& command : commands)
  {
    page += "  relievo " + command->Describe().GetUse() + "\n";
  }
  page += "  relievo [COMMAND] --help | --version\n\n";
  for (const auto& command : commands)
  {
    page += command->Describe().GetHelp() + "\n";
  }
  return page + Notes;
}

//------------------------------------------------------------------------------
std::string GetHelpPage(const Command& command)
{
  const vtkRelievoCommand& about = command.Describe();
  return "relievo " + about.GetUse() + "\n\n" + about.GetHelp() +
    "\nrelievo --help describes all commands, with examples.\n";
}

//------------------------------------------------------------------------------
std::string GetWords(const Commands& commands)
{
  std::string lines;
  for (const auto& command : commands)
  {
    lines += command->DescribeAll().GetWords();
  }
  vtkRelievoCommand viewer;
  viewer.Name = "relievo-viewer";
  viewer.Files = scene::GetRenderCommand().Files;
  for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
  {
    if (!option.OfOutputs)
    {
      viewer.Options.push_back(option);
    }
  }
  for (const char* own : { "--once", "--help", "--version" })
  {
    viewer.Options.emplace_back().Name = own;
  }
  return lines + viewer.GetWords();
}
}
