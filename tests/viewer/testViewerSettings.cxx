// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// scene::Settings keep the meaning of words, and write it as words again.
#include "TestCase.h"
#include "ViewerTest.h"

#include "Errors.h"
#include "History.h"
#include "Options.h"
#include "ShadowOptions.h"

#include <QtTest>

namespace testViewerSettings
{
using scene::Settings;
using Words = std::vector<std::string>;

class TestViewerSettings : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void words()
  {
    const auto words = [](const Words& given) {
      return scene::Settings::FromWords(given).GetWords();
    };
    QCOMPARE(words({ "a.vtp", "--edges", "--opacity=0.5" }),
      (Words{ "--opacity", "0.5", "--edges", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--deferred" }), (Words{ "--stage", "deferred", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--tone", "reinhard-rgb,white=2", "--exposure", "-1" }),
      (Words{ "--stage", "tone:operator=reinhard_rgb,white=2,exposure=-1", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--shadows", "exact", "--soft-shadows", "16" }),
      (Words{ "--shadows", "exact", "--stage", "shadows:soft_samples=16", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--shadow-tolerance", "0.05%" }),
      (Words{ "--shadows", "map", "--stage", "shadows:tolerance=0.0005", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--stage", "shadows:visible=on,method=exact" }),
      (Words{ "--shadows", "exact", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--stage", "shadows" }), (Words{ "--shadows", "map", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--ambient", "0.5,radius=2" }),
      (Words{ "--stage", "ambient:enabled=on,strength=0.5,radius=2", "a.vtp" }));
    QCOMPARE(words({ "a.vtp", "--png", "a.png" }), Words{ "a.vtp" });
    QCOMPARE(words({ "--", "-a.vtp" }), (Words{ "--", "-a.vtp" }));
    QVERIFY_EXCEPTION_THROWN(words({ "a.vtp", "--wrong", "1" }), words::UsageError);
    QVERIFY_EXCEPTION_THROWN(words({ "a.vtp", "--opacity", "2" }), words::UsageError);
  }

  // Written words parse to the same settings.
  void again()
  {
    const scene::Settings once = scene::Settings::FromWords({ "a.vtp", "b.vtp", "--tone", "simple",
      "--light", "sun:1,2,3", "--light", "point:0.1,0.2,0.3,size=0.5", "--shadows", "warped",
      "--shadow-size", "512", "--preset", "town", "--fog", "f.vtp,density=2" });
    QVERIFY(scene::Settings::FromWords(once.GetWords()) == once);
    QVERIFY(once != scene::Settings());
  }

  void shadows()
  {
    scene::Settings settings = scene::Settings::FromWords({ "a.vtp" });
    settings.SetParameter("shadows", "method", "exact");
    QCOMPARE(settings.GetParameter("shadows", "enabled"), std::string("off"));
    QVERIFY(!scene::ShowsShadows(settings.Parse()));
    settings.SetParameter("shadows", "enabled", "on");
    QVERIFY(scene::ShowsShadows(settings.Parse()));
    QCOMPARE(
      *scene::FindStageChoice(settings.Parse().Stages, "shadows", "method"), std::string("exact"));
    QCOMPARE(settings.GetParameter("shadows", "method"), std::string("exact"));
    settings.SetParameter("shadows", "enabled", "off");
    QVERIFY(!scene::ShowsShadows(settings.Parse()));
    QCOMPARE(settings.GetParameter("shadows", "method"), std::string("exact"));
    settings.SetParameter("shadows", "method", "map");
    QCOMPARE(settings.GetWords(), Words{ "a.vtp" });
    settings.Set("--preset", "studio"); // which shows them
    QCOMPARE(settings.GetParameter("shadows", "enabled"), std::string("on"));
    settings.SetParameter("shadows", "enabled", "off");
    QVERIFY(!scene::ShowsShadows(settings.Parse()));
  }

  // Changes are taken over one by one, where other things are said besides.
  void changes()
  {
    const auto take = [](const Words& to, const Words& before, const Words& after) {
      scene::Settings settings = scene::Settings::FromWords(to);
      settings.TakeChanges(scene::Settings::FromWords(before), scene::Settings::FromWords(after));
      return settings.GetWords();
    };
    const Words before = { "b.vtp", "--edges", "--stage", "tone:operator=reinhard,exposure=2" };
    QCOMPARE(take({ "a.vtp", "--opacity", "0.5", "--edges" }, before,
               { "b.vtp", "--stage", "tone:operator=reinhard,exposure=3", "--color", "red" }),
      (Words{ "--color", "red", "--opacity", "0.5", "--stage", "tone:exposure=3", "a.vtp" }));
    QCOMPARE(take({ "a.vtp", "--stage", "tone:white=3" }, before, { "b.vtp", "--edges" }),
      Words{ "a.vtp" });
    QCOMPARE(take({ "a.vtp", "--stage", "tone:white=3,exposure=2" }, before,
               { "b.vtp", "--edges", "--stage", "tone:operator=reinhard" }),
      (Words{ "--stage", "tone:white=3", "a.vtp" }));
  }

  // Shadows that are shown otherwise than before, and are the option's and the stage's at once.
  void changesOfShadows()
  {
    scene::Settings before = scene::Settings::FromWords({ "a.vtp" });
    before.SetParameter("shadows", "method", "exact");
    scene::Settings after = before;
    after.SetParameter("shadows", "enabled", "on");
    scene::Settings other = before;
    other.Set("--edges", "");
    other.TakeChanges(before, after);
    QCOMPARE(other.GetWords(), (Words{ "--edges", "--shadows", "exact", "a.vtp" }));
    other.TakeChanges(after, before);
    other.Remove("--edges");
    QVERIFY(other == before);
  }

  // The preset's values are readable, without words for them, and a word switches them off.
  void presets()
  {
    for (const Words& words : { Words{}, Words{ "a.vtp" } })
    {
      scene::Settings settings = scene::Settings::FromWords(words);
      QVERIFY(!settings.IsStageOn("antialias"));
      settings.Set("--preset", "studio");
      QVERIFY(settings.IsStageOn("antialias") && settings.IsStageOn("shadows"));
      QCOMPARE(settings.GetParameter("antialias", "samples"), std::string("24"));
      QCOMPARE(settings.GetParameter("shadows", "soft_samples"), std::string("24"));
      settings.SwitchStage("antialias", false);
      QVERIFY(!settings.IsStageOn("antialias"));
      settings.SwitchStage("antialias", true);
      QVERIFY(settings.IsStageOn("antialias"));
      QCOMPARE(settings.GetParameter("antialias", "samples"), std::string("24"));
      settings.SetParameter("shadows", "soft_samples", "1"); // a new stage's default
      QCOMPARE(settings.GetParameter("shadows", "soft_samples"), std::string("1"));
      settings.SwitchStage("shadows", false);
      QVERIFY(!settings.IsStageOn("shadows"));
      QVERIFY(!scene::ShowsShadows(settings.Parse()));
    }
    scene::Settings studio = scene::Settings::FromWords({ "a.vtp", "--preset", "studio" });
    QCOMPARE(studio.GetWords(), (Words{ "--preset", "studio", "a.vtp" }));
    studio.Set("--preset", "none");
    QVERIFY(!studio.IsStageOn("antialias") && !studio.IsStageOn("shadows"));
    const scene::Settings soft =
      scene::Settings::FromWords({ "a.vtp", "--preset", "studio", "--soft-shadows", "8" });
    QCOMPARE(soft.GetParameter("shadows", "soft_samples"), std::string("8"));
    // Words override the preset, in any of their forms.
    const scene::Settings same = scene::Settings::FromWords(
      { "a.vtp", "--preset", "studio", "--stage", "shadows:soft_samples=8" });
    QVERIFY(same == soft);
    QCOMPARE(
      *scene::FindStageChoice(same.Parse().Stages, "shadows", "soft_samples"), std::string("8"));
  }

  // Shadows that are switched off and on again, or on and off, are as they were.
  void switchedTwice()
  {
    for (const Words& words : { Words{ "--preset", "none" }, Words{ "--preset", "studio" },
           Words{ "--preset", "studio", "--shadows", "map" },
           Words{ "--preset", "studio", "--shadows", "off" },
           Words{ "--preset", "studio", "--shadows", "map", "--soft-shadows", "24" },
           Words{ "--preset", "none", "--shadows", "off" },
           Words{ "--preset", "studio", "--soft-shadows", "3", "--shadow-size", "512" },
           Words{ "--preset", "town", "--shadows", "exact", "--colored-shadows" },
           Words{ "--preset", "studio", "--environment", "a.exr" },
           Words{ "--preset", "none", "--stage", "shadows:method=exact" } })
    {
      const scene::Settings settings = scene::Settings::FromWords(words);
      const bool on = settings.IsStageOn("shadows");
      viewer::Document document;
      document.Set(settings);
      document.SwitchShadows(!on);
      QCOMPARE(document.Get().IsStageOn("shadows"), !on);
      document.Change([](scene::Settings& other) { other.Set("--edges", ""); });
      document.SwitchShadows(on);
      scene::Settings wanted = settings;
      wanted.Set("--edges", "");
      QCOMPARE(document.Get().GetWords(), wanted.GetWords());
      // Values set meanwhile stay.
      document.SwitchShadows(!on);
      document.Change(
        [](scene::Settings& other) { other.SetParameter("shadows", "strength", "0.5"); });
      document.SwitchShadows(on);
      QCOMPARE(document.Get().IsStageOn("shadows"), on);
      QCOMPARE(document.Get().GetParameter("shadows", "strength"), std::string("0.5"));
    }
  }

  void history()
  {
    const auto at = [](const char* opacity) {
      return scene::Settings::FromWords({ "a.vtp", "--opacity", opacity });
    };
    scene::Settings edged = at("0.5");
    edged.Set("--edges", "");
    viewer::History history;
    QVERIFY(!history.CanUndo() && !history.Undo(at("0.1")));
    history.Add(at("0.1"), at("0.3"), 1); // a slider
    history.Add(at("0.3"), at("0.4"), 1);
    history.Add(at("0.4"), at("0.5"), 1);
    history.Add(at("0.5"), edged); // something else
    QVERIFY(*history.Undo(edged) == at("0.5"));
    QVERIFY(*history.Undo(at("0.5")) == at("0.1"));
    QVERIFY(!history.CanUndo() && history.CanRedo());
    QVERIFY(*history.Redo(at("0.1")) == at("0.5"));
    QVERIFY(*history.Redo(at("0.5")) == edged);
    QVERIFY(!history.CanRedo());
    QVERIFY(*history.Undo(edged) == at("0.5"));
    history.Add(at("0.5"), at("0.6"), 1); // an undone edit cannot be done again any more
    QVERIFY(!history.CanRedo());
    QVERIFY(*history.Undo(at("0.6")) == at("0.5")); // not one with what came before undoing
    history.Add(at("0.5"), at("0.6"));
    history.Add(at("0.6"), at("0.7")); // another edit
    history.DropUntil(at("0.6"));      // it was refused
    QVERIFY(*history.Undo(at("0.6")) == at("0.5"));
    // There and back is no edit, and later changes of the same drag form a new one.
    history.Clear();
    history.Add(at("0.1"), at("0.2"));
    history.Add(at("0.2"), at("0.3"), 2);
    history.Add(at("0.3"), at("0.2"), 2);
    history.Add(at("0.2"), at("0.4"), 2);
    history.Add(at("0.4"), at("0.5"), 2);
    QVERIFY(*history.Undo(at("0.5")) == at("0.2"));
    QVERIFY(*history.Undo(at("0.2")) == at("0.1"));
    QVERIFY(!history.CanUndo());
    // Undone in the middle of a drag: later changes start from there.
    history.Add(at("0.1"), at("0.2"));
    history.Add(at("0.2"), at("0.3"), 3);
    QVERIFY(*history.Undo(at("0.3")) == at("0.2"));
    history.Add(at("0.2"), at("0.4"), 3);
    QVERIFY(*history.Undo(at("0.4")) == at("0.2"));
    // Two equal changes are two edits, however soon.
    history.Clear();
    history.Add(at("0.1"), at("0.2"));
    history.Add(at("0.2"), at("0.1"));
    QVERIFY(*history.Undo(at("0.1")) == at("0.2"));
    QVERIFY(*history.Undo(at("0.2")) == at("0.1"));
  }

  // The mode is the stage's, and said once; the last word counts, as in the command line.
  void fogMode()
  {
    const scene::Settings settings = scene::Settings::FromWords(
      { "a.vtp", "--stage", "fog:mode=beer", "--fog", "f.vtp,mode=chord,density=2" });
    QCOMPARE(settings.GetWords(),
      (Words{ "--fog", "f.vtp,density=2", "--stage", "fog:mode=chord", "a.vtp" }));
    QCOMPARE(
      scene::Settings::FromWords({ "a.vtp", "--lamps", "l.vtp,casting=2,radius=3" }).GetWords(),
      (Words{ "--lamps", "l.vtp,radius=3", "--stage", "lamps:casting=2", "a.vtp" }));
    QCOMPARE(scene::Settings::FromWords({ "a.vtp", "--fog", "f.vtp,mode=beer" }).GetWords(),
      (Words{ "--fog", "f.vtp", "a.vtp" }));
  }

  void absolutePaths()
  {
    scene::Settings settings =
      scene::Settings::FromWords({ "a.vtp", "/there/b.vtp", "--environment", "sky.exr,90",
        "--normal-map", "n.png", "--height-map", "h.png,0.5", "--lamps", "l.vtp,color=1/0.5/0",
        "--fog", "/there/f.vtp", "--fog", "f.vtp", "--markers", "m.vtp", "--color-by", "a" });
    settings.MakePathsAbsolute("/here");
    QCOMPARE(settings.GetWords(),
      (Words{ "--color-by", "a", "--normal-map", "/here/n.png", "--height-map", "/here/h.png,0.5",
        "--environment", "/here/sky.exr,90", "--lamps", "/here/l.vtp,color=1/0.5/0", "--fog",
        "/there/f.vtp", "--fog", "/here/f.vtp", "--markers", "/here/m.vtp", "/here/a.vtp",
        "/there/b.vtp" }));
    settings = scene::Settings::FromWords(
      { "a.vtp", "--environment", "sky,1", "--fog", R"(f\,g.vtp,density=a\,mode=b,mode=beer)" });
    settings.MakePathsAbsolute("/a,b");
    QCOMPARE(settings.GetWords(),
      (Words{ "--environment", "/a,b/sky,1", "--fog", R"(/a\,b/f\,g.vtp,density=a\,mode=b)",
        "/a,b/a.vtp" }));
    settings.MakePathsRelative("/a,b");
    QCOMPARE(settings.GetWords(),
      (Words{ "--environment", "sky,1", "--fog", R"(f\,g.vtp,density=a\,mode=b)", "a.vtp" }));
    settings = scene::Settings::FromWords({ "/a/b.vtp", "/a/c/d.vtp", "/ab/c.vtp" });
    settings.MakePathsRelative("/a");
    QCOMPARE(settings.Files, (Words{ "b.vtp", "c/d.vtp", "/ab/c.vtp" }));
  }

  void numbers()
  {
    QCOMPARE(
      words::WriteNumbers({ 0.1, 100.0, 1.0 / 3.0 }), std::string("0.1,100,0.3333333333333333"));
  }
};

RELIEVO_TEST_CASE_APART(testViewerSettings)
{
  TestViewerSettings tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerSettings.moc"
