// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Help.h"

#include "Options.h"

#include <sstream>

namespace cli
{
namespace
{
constexpr std::size_t Indent = 26; // of what options mean
constexpr std::size_t Columns = 98;

const char* const Page = R"(relievo - pictures and measurable layers of meshes and grids

  relievo render FILE... [options] --png F | --exr F | --report F
  relievo dataset FILE... --poses POSES --out DIR [options]
  relievo visible FILE... --poses POSES -o FILE.vtp [options]
  relievo sun FILE... --place LATITUDE,LONGITUDE --dates DATES -o FILE.vtp [options]
  relievo cave [options] -o FILE.vti
  relievo stages
  relievo bench NAME... [--out DIR] [--beside DIR] [--quick]
  relievo --help | --version

render draws the FILEs off screen and writes the outputs that you request.
  FILE  .vtp .vtu .vti .vtr .vts .vtm .vtmb .pvtp .pvtu .pvti .pvtr .pvts .vtk
        .stl .ply .obj .off .gltf .glb and models with bones: .bvh .dae .fbx .iqm .ms3d
        .x
        Grids and images are drawn by their outer surface. Active scalars give the colour. OBJ
        and glTF bring their materials and textures.

@options@

dataset writes what many cameras see of the FILEs as a data set, to learn from or to judge by:
  pictures, depth, masks of each object, its boxes and poses, and the cameras. It takes the options
  of render that shape the scene and its look; --size, --view-angle and --lens are the cameras'.
  The same call goes on where an earlier one ended.

  --poses POSES           orbit:N[,elevation=30][,distance=1], places around the scene;
                          random:N[,lowest=0][,highest=90][,nearest=1][,farthest=1.5], anywhere
                          between two elevations and two distances, of which 1 shows everything; or
                          a FILE.json, a list of {"R", "t"} or {"position", "target"}, or a
                          transforms.json
  --out DIR               the folder: new, empty, or begun by the same call
  --format FORMAT         bop, coco, nerf or npz (bop)
  --layers A,B...         layers that are written as floats: in layers/NUMBER.exr, of npz as arrays;
                          flow, motion and flow_valid go to the view before
  --objects KIND          what an object is: file, actor (of a file with several materials or parts)
                          or block (file)
  --depth-step S          world units of a step of 16-bit depth (to reach what is farthest)
  --mm-per-unit M         of bop: millimetres in a world unit (1000)
  --seed N                of all that is random (0)
  --random-sun            the sun stands elsewhere in each view
  --views A:B             from view A to before view B, as one of several processes (all)

visible finds by rays which cells of a mesh cameras see, in how many pixels and under which solid
  angle, and writes the mesh with the arrays seen, pixels and solid_angle. The first FILE is the
  mesh, the others hide it.

  --poses POSES           orbit:N, random:N or a FILE.json, as of dataset
  -o FILE.vtp             the mesh
  --allow-folder DIR      a folder that files may name pieces in, besides their own; repeatable
  --cloud FILE.vtp        what the pixels show of the mesh, as points
  --size WxH              pixels of each camera (1024x768)
  --view-angle DEG        full vertical angle of each camera (30)
  --lens LENS             pinhole, brown:..., fisheye, division:..., equirectangular, cube,
                          orthographic:PIXELS or a file, as of render (pinhole)
  --up AXIS               the axis that points up, x, y or z (by the first FILE)
  --seed N                of random poses (0)

sun finds by rays how long the sun shines on a mesh, and writes it with the arrays sun_hours and
  insolation (each hour times the cosine between the sun and the normal). The first FILE is the
  mesh, the others shade it. North is z, -z or y where x, y or z points up.

  --place LAT,LON         degrees; north and east are positive
  --dates DATES           FIRST[:LAST[:EVERY]], days such as 2026-01-01:2026-12-31:7, which both
                          count; of every so many days one stands for all
  -o FILE.vtp             the mesh
  --allow-folder DIR      a folder that files may name pieces in, besides their own; repeatable
  --step MINUTES          from one place of the sun to the next, 0.1 to 240 (20)
  --points                points are judged, rather than cells
  --sky N                 also the array sky_view, the share of the sky that is seen, by N rays (0)
  --up AXIS               the axis that points up, x, y or z (by the first FILE)

cave makes winding caves from a seed and writes them as an image.

  -o FILE.vti             the image
  --size WxHxD            samples along x, y and z (128x64x128)
  --seed N                another seed, other caves; the same seed, the same caves (0)
  --width W               width of tunnels in world units, at most half of --scale (6)
  --scale S               how far apart the bends of tunnels are, in world units (64)
  --vertical-scale V      how much lower than wide caves are (2)
  --up AXIS               the axis that points up, x, y or z (y)
  --origin X,Y,Z          place of the first sample (0,0,0)
  --spacing X,Y,Z         distance between samples (1,1,1)
  --content KIND          of the samples: mask (1 in the air, 0 in the rock), density (-1 in the
                          middle of tunnels, 0 at their walls, 1 in the rock) or labels (0 and 1,
                          for smooth blocks) (mask)

stages lists the stages of the frame, and the values that their parameters take.

bench measures, prints what it found, and writes CSV to a folder, and charts where Python has
  matplotlib; elsewhere bench/charts.py draws them. Without a known NAME it lists them. Several
  NAMEs, or all, run in processes of their own: none stops another, what they print is in DIR/logs,
  and DIR/summary.md says how they ended and how long they took. The same call again runs those
  that are not done.

  --out DIR               where to write (the current folder)
  --beside DIR            writes the summary, also for one NAME, with figures beside those of the
                          CSV files in DIR, such as docs/charts
  --quick                 times everything three times instead of up to 31 times, for a first
                          look; the same call without it measures again

Options are written --name value or --name=value, those without a value alone; -- ends them.
Either all requested files are written, or none; of a sequence, those of each frame.
VTK before 9.4 needs an X display, which xvfb-run provides.
Exit status: 0 done, 1 the work failed, 2 the arguments were wrong.

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
  relievo render walk.fbx --times 0:2:0.04 --shadows map --png walk_%03d.png
  relievo dataset mug.obj table.stl --poses random:500 --seed 7 --random-sun --out train/000000
  relievo visible bunny.off --poses orbit:24 -o seen.vtp
  relievo sun town.obj --place 48.2,16.4 --dates 2026-06-21 --sky 256 -o sun.vtp
  relievo render sun.vtp --color-by sun_hours --scalar-bar --png sun.png
  relievo cave --size 256x128x256 --seed 7 -o cave.vti
  relievo bench normals --out charts
  relievo bench all --out here --beside docs/charts
)";
//------------------------------------------------------------------------------
// A paragraph, of which the first line goes on behind what is there, and the others are indented.
void AddParagraph(const std::string& text, std::size_t indent, std::string& page)
{
  std::istringstream words(text);
  std::size_t column = Indent;
  bool first = true;
  for (std::string word; words >> word; first = false)
  {
    if (!first && column + 1 + word.size() > Columns)
    {
      page += "\n" + std::string(indent, ' ');
      column = indent;
      first = true;
    }
    page += (first ? "" : " ") + word;
    column += (first ? 0 : 1) + word.size();
  }
  page += '\n';
}

// A line of a table, which keeps its blanks where it is short.
void AddTableLine(const std::string& line, std::string& page)
{
  if (Indent + line.size() <= Columns)
  {
    page += line + "\n";
    return;
  }
  page += "  ";
  AddParagraph(line, Indent + 6, page);
}

std::string DescribeOption(const scene::OptionHelp& option)
{
  std::string page = "  " + option.Name + (option.Value.empty() ? "" : " " + option.Value);
  page += page.size() + 2 > Indent ? "\n" + std::string(Indent, ' ')
                                   : std::string(Indent - page.size(), ' ');
  std::istringstream paragraphs(option.Help);
  bool first = true;
  for (std::string paragraph; std::getline(paragraphs, paragraph); first = false)
  {
    page += first ? "" : std::string(Indent, ' ');
    paragraph[0] == ' ' ? AddTableLine(paragraph, page) : AddParagraph(paragraph, Indent, page);
  }
  return page;
}
}

//------------------------------------------------------------------------------
std::string GetHelpPage()
{
  std::string options;
  for (const scene::OptionHelp& option : scene::GetRenderHelp())
  {
    options += DescribeOption(option);
  }
  const std::string mark = "@options@\n";
  std::string page = Page;
  return page.replace(page.find(mark), mark.size(), options);
}
}
