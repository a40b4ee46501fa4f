// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tone operators: error of the picture against the formula in double, changes of hue and
// saturation, width of bands in a gradient with and without dithering, and the cost of the stage
// per frame.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "FrameBench.h"
#include "Table.h"
#include "ToneScene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::PaintStage;
using relievoTest::ToneScene;

constexpr double White = 4.;
constexpr int Columns = 512; // of the gradient
constexpr int Rows = 64;
constexpr int Block = 16;
constexpr double FirstStep = 120.;
constexpr double Steps = 4.;

const char* const Operators[] = { "clamp", "simple", "reinhard", "reinhard_rgb", "neutral" };
const char* const Ditherings[] = { "none", "ordered", "blue_noise" };

// Hue of a colour in linear light, degrees, and its saturation: the share that is not grey.
std::pair<double, double> GetHue(const glm::dvec3& c)
{
  const double across = 0.5 * std::sqrt(3.) * (c.y - c.z);
  const double along = c.x - 0.5 * (c.y + c.z);
  const double most = std::max({ c.x, c.y, c.z });
  const double least = std::min({ c.x, c.y, c.z });
  return { std::atan2(across, along) * 180. / std::acos(-1.),
    most > 0. ? (most - least) / most : 0. };
}

bool MeasureOperators(const std::string& outDir, const ToneSizes& sizes)
{
  ToneScene scene(sizes.Side, sizes.Side);
  scene.PaintLight();
  scene.Tone->SetWhite(White);
  Table table({ "operator", "white", "picture, largest error, steps of 255",
    "formula in float, largest error", "hue turned, mean degrees", "hue turned, most degrees",
    "saturation kept, mean %" });
  for (int which = 0; which < static_cast<int>(std::size(Operators)); ++which)
  {
    scene.Tone->SetOperator(which);
    const double picture = scene.GetError(scene.Picture());
    double rounding = 0.;
    double turned = 0.;
    double most = 0.;
    double kept = 0.;
    int hues = 0;
    int colours = 0;
    for (const glm::vec4& pixel : scene.Paint->Pixels)
    {
      const glm::dvec3 light(
        PaintStage::GetHalf(pixel.r), PaintStage::GetHalf(pixel.g), PaintStage::GetHalf(pixel.b));
      const glm::dvec3 shown = relievo::f64::relievoTone(which, light, White);
      const glm::dvec3 rounded(
        relievo::f32::relievoTone(which, glm::vec3(light), static_cast<float>(White)));
      const glm::dvec3 off = glm::abs(rounded - shown);
      rounding = std::max({ rounding, off.x, off.y, off.z });
      if (relievo::f64::relievoLuminance(light) > White)
      {
        continue; // white, for any colour
      }
      ++colours;
      const auto before = GetHue(light);
      const auto after = GetHue(shown);
      kept += after.second / before.second;
      if (after.second > 0.01) // greys have no hue
      {
        const double apart = std::abs(std::remainder(after.first - before.first, 360.));
        turned += apart;
        most = std::max(most, apart);
        ++hues;
      }
    }
    table.AddRow({ Operators[which], which == 2 || which == 3 ? Number(White) : std::string(),
      Number(picture), Number(rounding, 2), Number(turned / std::max(1, hues), 2), Number(most, 2),
      Number(100. * kept / std::max(1, colours), 3) });
    std::cout << Operators[which] << ": picture within " << Number(picture)
              << " steps of 255, hue turned by " << Number(most, 2) << " degrees at most"
              << std::endl;
  }
  return table.WriteCsv(outDir + "/tone.csv");
}

// Grey light, and red, from 6 stops below 1 to 6 above.
bool MeasureCurves(const std::string& outDir)
{
  constexpr int count = 25;
  ToneScene scene(count, 2);
  scene.Tone->SetWhite(White);
  const auto getStops = [](int i) { return -6. + 12. * i / (count - 1); };
  for (int i = 0; i < count; ++i)
  {
    const auto light = static_cast<float>(std::exp2(getStops(i)));
    scene.Paint->Pixels[i] = glm::vec4(light, light, light, 1.f);
    scene.Paint->Pixels[count + i] = glm::vec4(light, 0.f, 0.f, 1.f);
  }
  Table table({ "operator", "stops", "grey, steps of 255", "red, steps of 255",
    "red's green, steps of 255" });
  for (int which = 0; which < static_cast<int>(std::size(Operators)); ++which)
  {
    scene.Tone->SetOperator(which);
    const auto picture = scene.Picture();
    const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
    for (int i = 0; i < count; ++i)
    {
      const unsigned char* red = bytes + 4 * (count + i);
      table.AddRow({ Operators[which], Number(getStops(i)), std::to_string(bytes[4 * i]),
        std::to_string(red[0]), std::to_string(red[1]) });
    }
  }
  return table.WriteCsv(outDir + "/tone-curves.csv");
}

bool MeasureBands(const std::string& outDir)
{
  ToneScene scene(Columns, Rows);
  scene.Tone->SetOperatorToClamp();
  scene.Tone->SetExposure(1.0);
  for (std::size_t i = 0; i < scene.Paint->Pixels.size(); ++i)
  {
    const double value = FirstStep + Steps * (static_cast<double>(i % Columns) + 0.5) / Columns;
    const auto light = static_cast<float>(0.5 * relievo::f64::relievoLinearFromSrgb(value / 255.));
    scene.Paint->Pixels[i] = glm::vec4(light, light, light, 1.f);
  }
  Table table({ "dither", "mean of 16 x 16, largest error, steps of 255", "pixel, RMS error",
    "pixel, largest error", "longest run of one value, pixels" });
  Table curve({ "dither", "value, steps of 255", "mean error, steps of 255" });
  for (int dither = 0; dither < 3; ++dither)
  {
    scene.Tone->SetDither(dither);
    const auto picture = scene.Picture();
    const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
    std::vector<double> expected(Columns);
    for (int x = 0; x < Columns; ++x)
    {
      expected[x] = scene.GetExpected(scene.Paint->Pixels[x]).x;
    }
    double squares = 0.;
    double pixel = 0.;
    double block = 0.;
    int longest = 0;
    std::vector<double> means(Columns / Block, 0.);
    std::vector<double> values(Columns / Block, 0.);
    for (int y0 = 0; y0 < Rows; y0 += Block)
    {
      for (int x0 = 0; x0 < Columns; x0 += Block)
      {
        double sum = 0.;
        for (int y = y0; y < y0 + Block; ++y)
        {
          for (int x = x0; x < x0 + Block; ++x)
          {
            const double off = bytes[4 * (Columns * y + x)] - expected[x];
            sum += off;
            squares += off * off;
            pixel = std::max(pixel, std::abs(off));
            values[x0 / Block] += expected[x] / (Block * Rows);
          }
        }
        means[x0 / Block] += sum / (Block * Rows);
        block = std::max(block, std::abs(sum) / (Block * Block));
      }
    }
    for (int y = 0; y < Rows; ++y)
    {
      for (int x = 1, run = 1; x < Columns; ++x)
      {
        const bool same = bytes[4 * (Columns * y + x)] == bytes[4 * (Columns * y + x - 1)];
        run = same ? run + 1 : 1;
        longest = std::max(longest, run);
      }
    }
    table.AddRow({ Ditherings[dither], Number(block, 3),
      Number(std::sqrt(squares / Columns / Rows), 3), Number(pixel, 3), std::to_string(longest) });
    for (int i = 0; i < Columns / Block; ++i)
    {
      curve.AddRow({ Ditherings[dither], Number(values[i], 6), Number(means[i], 3) });
    }
    std::cout << "dithering " << Ditherings[dither] << ": means within " << Number(block, 3)
              << " steps, runs of " << longest << " pixels" << std::endl;
  }
  return table.WriteCsv(outDir + "/tone-dither.csv") && curve.WriteCsv(outDir + "/tone-bands.csv");
}

bool MeasureFrames(const std::string& outDir, const ToneSizes& sizes)
{
  struct Way
  {
    const char* Name;
    std::function<void(vtkRelievoPass*)> Set;
  };
  const auto on = [](vtkRelievoPass* frame) {
    vtkRelievoToneStage* tone = frame->GetToneStage();
    tone->EnabledOn();
    tone->SetOperatorToReinhard();
    return tone;
  };
  const Way ways[] = {
    { "plain", nullptr },
    { "stage idle", [&](vtkRelievoPass* f) { on(f)->SetOperatorToClamp(); } },
    { "linear colour, sRGB curve alone", [](vtkRelievoPass* f) { f->RequestLayer("color"); } },
    { "reinhard", [&](vtkRelievoPass* f) { on(f); } },
    { "reinhard, blue noise", [&](vtkRelievoPass* f) { on(f)->SetDitherToBlueNoise(); } },
    { "reinhard, automatic exposure", [&](vtkRelievoPass* f) { on(f)->AutoExposureOn(); } },
  };
  const vtkSmartPointer<vtkPolyData> mesh = SceneMesh("bunny");
  if (!mesh)
  {
    return false;
  }
  std::vector<std::unique_ptr<SceneWindow>> windows;
  std::vector<relievoTest::Timed> frames;
  for (const Way& way : ways)
  {
    windows.emplace_back(new SceneWindow(mesh, 1920, 1080));
    if (way.Set)
    {
      way.Set(vtkRelievoPass::Attach(windows.back()->Scene.Renderer));
    }
    frames.push_back(windows.back()->Frame());
  }
  const auto times = TimeInTurn(frames, sizes.Rounds);
  Table table({ "frame", "ms", "times a plain frame", "+-" });
  for (std::size_t i = 0; i < std::size(ways); ++i)
  {
    const relievoTest::TimingPair pair = PairOf(times[i], times[0]);
    std::cout << ways[i].Name << ": " << pair.ToString("frame", "plain") << std::endl;
    table.AddRow({ ways[i].Name, Number(1000. * times[i].Median(), 4), Number(pair.Ratio(), 3),
      Number(pair.RatioSpread(), 1) });
  }
  return table.WriteCsv(outDir + "/tone-frames.csv");
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchTone(const std::string& outDir, const ToneSizes& sizes)
{
  const bool written = MakeFolder(outDir) && MeasureOperators(outDir, sizes) &&
    MeasureCurves(outDir) && MeasureBands(outDir) &&
    (sizes.Rounds == 0 || MeasureFrames(outDir, sizes));
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchTone(const std::string& outDir)
{
  return BenchTone(outDir, ToneSizes());
}
