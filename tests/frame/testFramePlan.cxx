// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The frame's plan by itself, without OpenGL: the stages that are reached and their order, for any
// input order; and refusals, by name.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkRelievoFramePlan.h>
#include <vtkRelievoStageDescription.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace testFramePlan
{
namespace
{
using Plan = vtkRelievoFramePlan;
using D = vtkRelievoStageDescription;
using Names = std::vector<std::string>;

// No text becomes a resource's name by itself, so that a misspelt one does not compile.
using Resource = vtkRelievoResourceName;
static_assert(!std::is_convertible<const char*, Resource>::value, "");
static_assert(!std::is_constructible<Resource, const char*>::value, "");
static_assert(!std::is_constructible<Resource, std::string>::value, "");

std::vector<Resource> ToResources(const Names& names)
{
  std::vector<Resource> resources;
  std::transform(names.begin(), names.end(), std::back_inserter(resources), Resource::Of);
  return resources;
}

Plan::Node Make(const std::string& name, int slot, const Names& reads, const Names& writes)
{
  Plan::Node node;
  node.Name = name;
  node.Slot = slot;
  node.Declaration.Reads = ToResources(reads);
  node.Declaration.Writes = ToResources(writes);
  return node;
}

// The frame's own nodes: VTK's drawing, the layers, and shadow maps for both.
std::vector<Plan::Node> MakeOwn(bool shadows)
{
  Plan::Node delegate = Make("delegate", D::SURFACES, {}, { "picture", "color" });
  delegate.Order = -1;
  delegate.Delegate = true;
  delegate.Declaration.OptionalReads = { vtkRelievoResources::ShadowMaps };
  Plan::Node layers = Make("gbuffer", D::SURFACES, {}, {});
  layers.Declaration.Layers = { "depth", "normal", "cell" };
  layers.Declaration.WritesArrays = true;
  layers.ReadsFor = [](const Names& asked) {
    const bool shadow = std::find(asked.begin(), asked.end(), "shadow_0") != asked.end();
    return ToResources(shadow ? Names{ "shadow maps" } : Names());
  };
  Plan::Node maps = Make("shadows", D::LIGHT_MAPS, {}, { "shadow maps" });
  maps.Declaration.OptionalWrites = ToResources(shadows ? Names{ "shadow maps" } : Names());
  return { delegate, layers, maps };
}

// The names of those that run, in order; every order of the nodes must give the same.
Names Run(std::vector<Plan::Node> nodes, const Names& outputs, Names* errors = nullptr,
  bool* color = nullptr)
{
  std::mt19937 random(7);
  Names first;
  for (int round = 0; round < 20; ++round)
  {
    std::vector<Plan::Node> shuffled = nodes;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    Plan plan;
    Names layers = outputs;
    const auto picture = std::find(layers.begin(), layers.end(), "the picture");
    const bool pictured = picture != layers.end();
    if (pictured)
    {
      layers.erase(picture);
    }
    Names said = plan.Make(shuffled, layers, pictured);
    std::sort(said.begin(), said.end());
    Names names;
    for (const int place : plan.GetOrder())
    {
      names.push_back(shuffled[place].Name);
    }
    if (round == 0)
    {
      first = names;
      if (errors)
      {
        *errors = said;
      }
      if (color)
      {
        *color = plan.NeedsColor();
      }
    }
    RELIEVO_CHECK_THAT(names == first, "another order of the stages, another frame");
  }
  return first;
}

void TestReached()
{
  RELIEVO_CHECK((Run(MakeOwn(false), { "the picture" }) == Names{ "delegate" }));
  RELIEVO_CHECK((Run(MakeOwn(true), { "the picture" }) == Names{ "shadows", "delegate" }));
  RELIEVO_CHECK(
    (Run(MakeOwn(false), { "the picture", "depth" }) == Names{ "delegate", "gbuffer" }));
  // Layers alone draw no picture, and no maps for a picture that is not shown.
  RELIEVO_CHECK((Run(MakeOwn(true), { "depth" }) == Names{ "gbuffer" }));
  RELIEVO_CHECK((Run(MakeOwn(false), { "shadow_0" }) == Names{ "shadows", "gbuffer" }));
  RELIEVO_CHECK(Run(MakeOwn(true), {}).empty());
}

// Optional layers are made where the picture needs their stages, and need no other stage then.
void TestOptional()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes.push_back(Make("light", D::SHADE, { "depth" }, { "color" }));
  nodes.push_back(Make("fog", D::COMPOSITE, { "color" }, {}));
  for (std::size_t i = 3; i < nodes.size(); ++i)
  {
    nodes[i].Declaration.Layers = { nodes[i].Name };
  }
  for (const bool picture : { true, false })
  {
    Plan plan;
    plan.SetOptionalLayers({ "light", "fog", "none", "temperature" });
    RELIEVO_CHECK(plan.Make(nodes, {}, picture).empty() && plan.GetMissing().empty());
    Names run;
    for (const int place : plan.GetOrder())
    {
      run.push_back(nodes[place].Name);
    }
    RELIEVO_CHECK(run == (picture ? Names{ "delegate", "gbuffer", "light" } : Names()));
    RELIEVO_CHECK(nodes[3].Asked == (picture ? Names{ "color", "light" } : Names()));
  }
}

void TestColor()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes.push_back(Make("fog", D::COMPOSITE, { "depth", "color" }, { "color" }));
  nodes.push_back(Make("bloom", D::COMPOSITE, { "color" }, { "color" }));
  nodes.push_back(Make("light", D::SHADE, { "depth", "normal" }, { "light" }));
  nodes.push_back(Make("lit", D::SHADE, { "light", "color" }, { "color" }));
  bool color = false;
  RELIEVO_CHECK((Run(nodes, { "the picture" }, nullptr, &color) ==
    Names{ "delegate", "gbuffer", "light", "lit", "bloom", "fog" }));
  RELIEVO_CHECK(color);
  // Order before name.
  nodes.back().Declaration.Runs = false;
  nodes[4].Order = 1;
  RELIEVO_CHECK((Run(nodes, { "the picture" }) == Names{ "delegate", "gbuffer", "fog", "bloom" }));
  // Asked for without a picture, the colour is drawn all the same; a layer is not.
  RELIEVO_CHECK((Run(nodes, { "color" }) == Names{ "delegate", "gbuffer", "fog", "bloom" }));
  RELIEVO_CHECK((Run(nodes, { "normal" }, nullptr, &color) == Names{ "gbuffer" }));
  RELIEVO_CHECK(!color);
  // A stage that shows a layer hides stages that work on the colour.
  nodes.push_back(Make("display", D::DISPLAY, { "cell" }, { "picture" }));
  nodes[2].Declaration.OptionalWrites = { vtkRelievoResources::ShadowMaps };
  RELIEVO_CHECK(
    (Run(nodes, { "the picture" }, nullptr, &color) == Names{ "delegate", "gbuffer", "display" }));
  RELIEVO_CHECK(!color);
  // Unless it may turn out to have nothing to show.
  nodes.back().Declaration.HidesColor = false;
  RELIEVO_CHECK((Run(nodes, { "the picture" }, nullptr, &color) ==
    Names{ "shadows", "delegate", "gbuffer", "fog", "bloom", "display" }));
  RELIEVO_CHECK(color);
  // A stage that makes the picture from the colour does not hide it.
  nodes.back() = Make("tone", D::DISPLAY, { "color" }, { "picture" });
  RELIEVO_CHECK((Run(nodes, { "the picture" }, nullptr, &color) ==
    Names{ "shadows", "delegate", "gbuffer", "fog", "bloom", "tone" }));
  RELIEVO_CHECK(color);
}

// Several stages that make the picture: all up to the one that certainly covers earlier ones.
void TestPictureMakers()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes[2].Declaration.OptionalWrites = { vtkRelievoResources::ShadowMaps };
  nodes.push_back(Make("glow", D::COMPOSITE, { "color" }, { "color" }));
  nodes.push_back(Make("tone", D::DISPLAY, { "color" }, { "picture" }));
  nodes.back().Order = -1;
  nodes.back().Declaration.HidesColor = false;
  nodes.push_back(Make("display", D::DISPLAY, { "cell" }, { "picture" }));
  bool color = true;
  RELIEVO_CHECK(
    (Run(nodes, { "the picture" }, nullptr, &color) == Names{ "delegate", "gbuffer", "display" }));
  RELIEVO_CHECK(!color);
  nodes.back().Declaration.HidesColor = false;
  RELIEVO_CHECK((Run(nodes, { "the picture" }, nullptr, &color) ==
    Names{ "shadows", "delegate", "gbuffer", "glow", "tone", "display" }));
  RELIEVO_CHECK(color);
  // A stage that refuses by itself is told of, and the others go on.
  Names errors;
  nodes[nodes.size() - 2].Declaration.Runs = false;
  nodes[nodes.size() - 2].Declaration.ReasonCode = "refused";
  nodes[nodes.size() - 2].Declaration.Reason = "it is not alone";
  RELIEVO_CHECK((Run(nodes, { "the picture" }, &errors) ==
    Names{ "shadows", "delegate", "gbuffer", "glow", "display" }));
  RELIEVO_CHECK(errors.size() == 1 && errors[0] == "The stage tone does not run: it is not alone");
}

// A stage that reads the colour and changes nothing sees it as it is at its place.
void TestReaderInTheMiddle()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes.push_back(Make("a", D::SHADE, { "color" }, { "color" }));
  nodes.push_back(Make("meter", D::COMPOSITE, { "color" }, {}));
  nodes.back().Declaration.Layers = { "mean" };
  nodes.push_back(Make("z", D::COMPOSITE, { "color", "mean" }, { "color" }));
  RELIEVO_CHECK((Run(nodes, { "the picture" }) == Names{ "delegate", "a", "meter", "z" }));
  nodes[4].Order = 1;
  nodes[5].Declaration.Reads = { vtkRelievoResources::Color };
  RELIEVO_CHECK((Run(nodes, { "the picture", "mean" }) == Names{ "delegate", "a", "z", "meter" }));
}

bool Says(const Names& errors, const Names& words)
{
  return std::any_of(errors.begin(), errors.end(), [&words](const std::string& line) {
    return std::all_of(words.begin(), words.end(),
      [&line](const std::string& word) { return line.find(word) != std::string::npos; });
  });
}

void TestRefused()
{
  Names errors;
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes.push_back(Make("haze", D::COMPOSITE, { "smoke", "color" }, { "color" }));
  RELIEVO_CHECK((Run(nodes, { "the picture" }, &errors) == Names{ "delegate" }));
  RELIEVO_CHECK(Says(errors, { "haze", "'smoke'", "no stage writes" }));

  // The stage that would write it is off.
  nodes.push_back(Make("fire", D::SHADE, {}, { "smoke" }));
  nodes.back().Declaration.Runs = false;
  nodes.back().Declaration.Reason = "switched off";
  RELIEVO_CHECK((Run(nodes, { "the picture" }, &errors) == Names{ "delegate" }));
  RELIEVO_CHECK(Says(errors, { "haze", "'smoke'", "fire", "switched off" }));

  // A cycle; unrelated stages run.
  nodes = MakeOwn(false);
  nodes.push_back(Make("chicken", D::COMPOSITE, { "egg", "color" }, { "color", "bird" }));
  nodes.push_back(Make("hen", D::COMPOSITE, { "bird" }, { "egg" }));
  nodes.push_back(Make("fog", D::COMPOSITE, { "color" }, { "color" }));
  RELIEVO_CHECK((Run(nodes, { "the picture" }, &errors) == Names{ "delegate", "fog" }));
  RELIEVO_CHECK(Says(errors, { "chicken", "'egg'", "hen", "'bird'" }));

  // A resource written in a later slot.
  nodes = MakeOwn(false);
  nodes.push_back(Make("early", D::LIGHT_MAPS, { "depth" }, { "shadow maps" }));
  nodes.back().Declaration.OptionalWrites = { vtkRelievoResources::ShadowMaps };
  nodes[2].Declaration.Runs = false;
  RELIEVO_CHECK((Run(nodes, { "the picture" }, &errors) == Names{ "delegate" }));
  RELIEVO_CHECK(Says(errors, { "early", "'depth'", "gbuffer", "light maps", "surfaces" }));
}

// A stage that only writes onto the colour also changes it: alone, and beside those that read it.
void TestAdders()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes.push_back(Make("lamps", D::SHADE, { "depth" }, { "color" }));
  bool color = false;
  Names errors;
  RELIEVO_CHECK(
    (Run(nodes, { "the picture" }, &errors, &color) == Names{ "delegate", "gbuffer", "lamps" }));
  RELIEVO_CHECK(color && errors.empty());
  RELIEVO_CHECK(
    (Run(nodes, { "color" }, &errors, &color) == Names{ "delegate", "gbuffer", "lamps" }));
  nodes.push_back(Make("marks", D::COMPOSITE, {}, { "color" }));
  nodes.push_back(Make("ao", D::SHADE, { "color" }, { "color" }));
  RELIEVO_CHECK((Run(nodes, { "the picture" }, &errors) ==
    Names{ "delegate", "gbuffer", "ao", "lamps", "marks" }));
  RELIEVO_CHECK(errors.empty());
  // A layer that is shown hides them.
  nodes.push_back(Make("display", D::DISPLAY, { "cell" }, { "picture" }));
  RELIEVO_CHECK((Run(nodes, { "the picture" }) == Names{ "delegate", "gbuffer", "display" }));
}

// Arrays may have any name: they are unrelated to stages' resources.
void TestNames()
{
  for (const bool shadows : { false, true })
  {
    for (const char* name : { "picture", "shadow maps", "delegate" })
    {
      Names errors;
      RELIEVO_CHECK_THAT((Run(MakeOwn(shadows), { name }, &errors) == Names{ "gbuffer" }), name);
      RELIEVO_CHECK_THAT(errors.empty(), name);
    }
  }
  // Shown as the picture too.
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes.push_back(Make("display", D::DISPLAY, {}, { "picture" }));
  nodes.back().Declaration.ReadsLayers = { "shadow maps" };
  RELIEVO_CHECK((Run(nodes, { "the picture" }) == Names{ "delegate", "gbuffer", "display" }));
}

// A layer that cannot be made is left out, and others are made.
void TestMissing()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes[2].Declaration.Runs = false;
  nodes[2].Declaration.Reason = "switched off";
  RELIEVO_CHECK((Run(nodes, { "shadow_0", "depth" }) == Names{ "gbuffer" }));
  Plan plan;
  std::vector<Plan::Node> made = nodes;
  RELIEVO_CHECK(plan.Make(made, { "depth", "shadow_0" }, false).empty());
  RELIEVO_CHECK(made[1].Asked == Names{ "depth" });
  RELIEVO_CHECK(plan.GetMissing().size() == 1);
  RELIEVO_CHECK(Says({ plan.GetMissing().at("shadow_0") }, { "shadow maps", "shadows", "off" }));
  // No stage for any layer: those that show one say whose it is.
  nodes[1].Declaration.Runs = false;
  nodes[1].Declaration.Reason = "gone";
  nodes.push_back(Make("display", D::DISPLAY, {}, { "picture" }));
  Names errors;
  for (const char* layer : { "depth", "temperature" })
  {
    nodes.back().Declaration.ReadsLayers = { layer };
    RELIEVO_CHECK((Run(nodes, { "the picture", layer }, &errors) == Names{ "delegate" }));
    RELIEVO_CHECK(Says(errors, { "display", layer, "gbuffer", "gone" }));
    made = nodes;
    plan.Make(made, { layer }, false);
    RELIEVO_CHECK(Says({ plan.GetMissing().at(layer) }, { "gbuffer", "gone" }));
  }
}

// Without a linear colour, stages that read or write it do not run, nor do their readers.
void TestNoColor()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  nodes.push_back(Make("lamps", D::SHADE, { "depth" }, { "color" }));
  nodes.push_back(Make("fog", D::COMPOSITE, { "color" }, { "color" }));
  nodes.push_back(Make("meter", D::COMPOSITE, { "color" }, { "mean" }));
  nodes.push_back(Make("tone", D::DISPLAY, { "mean" }, { "picture" }));
  nodes.push_back(Make("off", D::COMPOSITE, { "color" }, { "color" }));
  nodes.back().Declaration.Runs = false;
  nodes.back().Declaration.ReasonCode = "off";
  Plan plan;
  plan.SetNoColor("it is dark");
  plan.Make(nodes, { "depth", "color" }, true);
  Names run;
  for (const int place : plan.GetOrder())
  {
    run.push_back(nodes[place].Name);
  }
  RELIEVO_CHECK((run == Names{ "delegate", "gbuffer" }));
  RELIEVO_CHECK(!plan.NeedsColor());
  for (const int refused : { 3, 4, 5, 6 })
  {
    RELIEVO_CHECK_THAT(nodes[refused].ReasonCode == "refused", nodes[refused].Name);
    RELIEVO_CHECK_THAT(Says({ nodes[refused].Reason }, { "it is dark" }), nodes[refused].Name);
  }
  RELIEVO_CHECK(nodes[7].ReasonCode == "off");
  RELIEVO_CHECK(Says({ plan.GetMissing().at("color") }, { "it is dark" }));
}

// A joining stage changes the colour if another does before it; its other output can be read
// anyway, which then creates a linear colour.
void TestOnlyIfColorChanges()
{
  std::vector<Plan::Node> nodes = MakeOwn(true);
  nodes[0].Declaration.Writes.push_back(vtkRelievoResources::Translucent);
  Plan::Node joins = Make("joins", D::COMPOSITE, { "translucent" }, { "color" });
  joins.Order = -10;
  joins.Declaration.Layers = { "blend" };
  joins.Declaration.OnlyIfColorChanges = true;
  nodes.push_back(joins);
  bool color = true;
  RELIEVO_CHECK((Run(nodes, { "the picture" }, nullptr, &color) == Names{ "shadows", "delegate" }));
  RELIEVO_CHECK(!color);
  RELIEVO_CHECK(
    (Run(nodes, { "the picture", "color" }, nullptr, &color) == Names{ "shadows", "delegate" }));
  RELIEVO_CHECK(color);
  RELIEVO_CHECK(
    (Run(nodes, { "blend" }, nullptr, &color) == Names{ "shadows", "delegate", "joins" }));
  RELIEVO_CHECK(color);
  // A stage after it does not need it, nor one that only reads the colour.
  nodes.push_back(Make("later", D::COMPOSITE, {}, { "color" }));
  Plan::Node shows = Make("shows", D::DISPLAY, { "color" }, { "picture" });
  shows.Declaration.Presents = true;
  nodes.push_back(shows);
  RELIEVO_CHECK(
    (Run(nodes, { "the picture" }) == Names{ "shadows", "delegate", "later", "shows" }));
  nodes.push_back(Make("lamps", D::SHADE, { "depth" }, { "color" }));
  RELIEVO_CHECK((Run(nodes, { "the picture" }) ==
    Names{ "shadows", "delegate", "gbuffer", "lamps", "joins", "later", "shows" }));
  // Lamps read the colour beneath.
  Plan::Node reads = Make("reads", D::SHADE, { "color" }, {});
  reads.Declaration.Layers = { "half" };
  nodes.push_back(reads);
  RELIEVO_CHECK(
    (Run(nodes, { "half" }) == Names{ "shadows", "delegate", "gbuffer", "lamps", "reads" }));
}

// Stages that are not needed give the reason: their output is not requested, or they contribute
// nothing to the picture and run only if their layer is requested.
void TestReasons()
{
  std::vector<Plan::Node> nodes = MakeOwn(false);
  Plan::Node clear = Make("clear", D::SHADE, {}, {});
  clear.Declaration.Layers = { "clarity" };
  clear.Declaration.ReasonCode = "idle";
  clear.Declaration.Reason = "the strength is 0";
  nodes.push_back(clear);
  Plan plan;
  plan.Make(nodes, {}, true);
  RELIEVO_CHECK(!nodes[3].Needed && nodes[3].ReasonCode == "idle");
  RELIEVO_CHECK(nodes[3].Reason == "the strength is 0");
  RELIEVO_CHECK(nodes[1].ReasonCode == "not_asked" && nodes[1].Reason == "no output asks for it");
  plan.Make(nodes, { "clarity" }, true);
  RELIEVO_CHECK(nodes[3].Needed);
}
}

RELIEVO_TEST_CASE(testFramePlan)
{
  relievoTest::Session session;
  TestReached();
  TestOptional();
  TestColor();
  TestPictureMakers();
  TestReaderInTheMiddle();
  TestRefused();
  TestAdders();
  TestNames();
  TestMissing();
  TestNoColor();
  TestOnlyIfColorChanges();
  TestReasons();
  return session.Result();
}
}
