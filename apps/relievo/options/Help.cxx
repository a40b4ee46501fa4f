// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Help.h"

#include "vtkRelievoLayerCatalogue.h"

#include <sstream>

namespace cli
{
namespace
{
constexpr std::size_t Indent = 26; // of what options mean
constexpr std::size_t Columns = 98;

const char* const Page = R"(relievo - pictures and measurable layers of meshes and grids

  relievo render FILE... [options] --png F | --exr F | --report F
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

  --size WxH              size of the picture in pixels, 1 to 16384 (1024x768)
  --camera PX,PY,PZ,FX,FY,FZ,UX,UY,UZ
                          position, focal point, up (fitted to the scene, looking along -z, y up,
                          or as --up says)
  --view-angle DEG        full vertical angle of the perspective, above 0 and below 180 (30)
  --parallel-scale S      parallel projection; S is half the picture's height in world units
  --clip NEAR,FAR         clipping distances, 0 < NEAR < FAR (around the scene)
  --shading KIND          flat, gouraud, phong or pbr (phong; glTF keeps its own materials)
  --preset NAME           studio, town or print: lights, shadows and background, where no other
                          option says them
  --color-by NAME[,COMPONENT]
                          colours by a point or cell array, point:NAME or cell:NAME where two
                          share a name; COMPONENT a number from 0, or magnitude (the magnitude;
                          bytes of 3 or 4 components are colours)
  --range MIN,MAX         values of the first and the last colour (those of all files together)
  --colormap NAME         viridis, cool-warm, grey, hot or rainbow (viridis)
  --scalar-bar            shows the colours and their values at the right
  --color COLOR           one colour for all meshes; COLOR is R/G/B from 0 to 1 as displays show
                          it, #rrggbb, or a name such as slategray
  --opacity A             of all meshes, 0 to 1 (1)
  --edges                 draws the edges of cells
  --background COLOR[,COLOR]
                          one colour, or the bottom's and the top's (black)
  --light LIGHT           may be repeated (the file's lights, else the environment alone, else a
                          headlight); LIGHT is
                            sun:DX,DY,DZ                    direction towards the sun
                            spot:PX,PY,PZ,FX,FY,FZ,CONE     CONE: half the opening, degrees
                            point:PX,PY,PZ
                          and may end with ,size=S for --soft-shadows: a sun's angle in degrees
                          (0.53), the radius of others in world units (0)
  --time T                the time of models with bones, in seconds (the animation's start)
  --times START:END:STEP  a frame for each of these times, the end included; the names of --png,
                          --exr and --report hold %d or %04d, the frame's number from 0. The
                          fitted camera sees all of them, and each frame's files are written
                          whole before the next frame
  --animation NAME        which of their animations (the first)
  --blend NAME=W          blends in another animation, W of the way, 0 to 1
  --loop                  times after an animation's end start anew (the end holds)
  --skin METHOD           how their bones move points: linear, dual-quaternion, key-matrix, or off
                          for the mesh at rest (linear)
  --skeleton              draws the bones, and the axes of their joints in red, green and blue;
                          --opacity makes the mesh see-through, not them
  --bone-weight BONE      colours by the weight of one bone; --color-by first_bone by the
                          strongest. With any of these from --time on, glTF is read as a model
                          with bones, without lights
  --lamps FILE[,radius=R][,intensity=I][,color=R/G/B][,falloff=F][,casts=C][,casting=N]
                          each point of the file is a lamp that shines up to its radius; may be
                          repeated. Values are numbers for all, or names of point arrays (the
                          arrays radius, intensity and color, else 1, 1 and white); F is linear
                          (linear), inverse-square, or vtk with attenuation=A/B/C. Lamps
                          shine through walls: casts=always (or never, or an array of 1 and 0)
                          gives these shadows, casting=N the N largest of all lamps (0); at
                          most eight cast
  --shadows METHOD        shadows of the lights in the picture: off, map, forward, warped or
                          exact (off)
  --shadow-size N         side of each shadow map in texels, 16 to 16384 (2048)
  --soft-shadows N        shadows of lights with a size: the mean of N samples of each light's
                          shape, 1 to 4096
  --colored-shadows       translucent meshes cast as well, and colour the light that passes
                          them, as stained glass does; needs --shadows exact
  --shadow-tolerance S    shadows by the cheapest method that is expected to get at most this
                          share of the pixels wrong, such as 0.05% or 0.0005
  --time-budget MS        shadows by the most accurate method whose frames are expected to take
                          at most so many milliseconds
  --certify N             judges N verdicts of the shadows, chosen at random, by rays in double
                          precision, and prints the share that is wrong, with its 95 % bound
  --normal-map F          normals from an image (.png .jpg .tif .bmp .hdr .exr; OpenGL's green),
                          placed by the meshes' texture coordinates; linear values, not sRGB
  --height-map F[,SCALE]  heights from an image; the ground lies SCALE below the mesh, in world
                          units (0.02 of the scene's longest side)
  --relief METHOD         how heights are drawn: off (as normals only), parallax, steep,
                          occlusion or relief (relief)
  --texture-coordinates METHOD
                          for meshes without them, to place maps: box, plane or sphere (box,
                          with a note)
  --environment F[,DEG]   light from all directions, which surfaces mirror and are lit by, from
                          an image (.exr .hdr .png .jpg) that is twice as wide as high, or from
                          a square one of a mirror ball; rotated by DEG about the up axis (0).
                          8 and 16 bits are sRGB, floats linear light
  --reflectivity R[,ROUGHNESS]
                          share of the environment that is mirrored at normal incidence, and
                          roughness of the mirror, each 0 to 1 (0.04,0.2)
  --skybox                shows the environment behind everything
  --up AXIS               the up axis, x, y or z, of --environment, the fitted camera, shadows of
                          --markers and --texture-coordinates (y)
  --fog F[,radius=R][,density=D][,color=R/G/B][,mode=MODE]
                          spheres of fog at the points of F; numbers, linear colours or names of
                          point arrays (the arrays radius, density and color, else 1, 1 and white);
                          MODE beer (e^-density length passes) or chord (what is held back grows
                          in a line, to density at the diameter) (beer); may be repeated
  --markers F[,shape=SHAPE][,radius=R][,width=W][,reach=H][,opacity=A][,color=R/G/B][,up=X/Y/Z]
                          marks surfaces within R of each point of F; SHAPE ring (W of the radius
                          wide), glow, disc, or shadow, a blob below the point, up to H radii
                          along the up axis, or X/Y/Z; numbers, linear colours or names of point
                          arrays (the arrays radius, width, reach, opacity and color, else 1,
                          0.2, 4, 0.8 and orange) (ring); may be repeated
  --deferred              shades opaque surfaces once for each pixel, after they are drawn: the
                          same picture, sooner where much is drawn over each other
  --stage NAME[:PARAMETER=VALUE,...]
                          runs a stage of the frame with these parameters; may be repeated;
                          `relievo stages` lists them
  --tone OPERATOR[,white=W]
                          how light above 1 is shown in the picture: clamp, simple, reinhard or
                          reinhard-rgb; W is the light that becomes white (reinhard,white=4, if
                          --exposure is given). The EXR's colour is the light before
  --exposure STOPS        multiplies the light by 2 to this power, -20 to 20, or auto (0)
  --layers A,B,...        layers in the EXR besides its colour (depth), of
@layers@
                          (shadow_N: visibility of the Nth --light, from 0: 1 lit, 0 dark), or the
                          name of a point or cell array
  --png F                 the picture
  --exr F                 OpenEXR: the colour as R G B A, then the layers as depth.Z normal.X ...
  --hdr                   the colour of the EXR as the lights give it, unclamped, half floats
  --report F              frame report, JSON: what ran and why, GPU ms, bytes held

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
  relievo cave --size 256x128x256 --seed 7 -o cave.vti
  relievo bench normals --out charts
  relievo bench all --out here --beside docs/charts
)";
}

//------------------------------------------------------------------------------
std::string GetHelpPage()
{
  std::istringstream names(vtkRelievoLayerCatalogue::GetLayerNames());
  std::string layers;
  std::string line(Indent - 1, ' ');
  for (std::string name; names >> name;)
  {
    if (line.size() + 1 + name.size() > Columns)
    {
      layers += line + "\n";
      line.assign(Indent - 1, ' ');
    }
    line += " " + name;
  }
  layers += line;
  const std::string mark = "@layers@";
  std::string page = Page;
  return page.replace(page.find(mark), mark.size(), layers);
}
}
