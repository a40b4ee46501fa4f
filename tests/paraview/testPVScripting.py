# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties by script: trace, state files in fresh processes, undo, invalid values, no plugin.

With the words `restore plugin|none FILE PICTURE` the script loads a state and draws it; with
`invalid` it sets invalid values and prints the results.
"""

import json
import pathlib
import re
import sys

import described
import judge
import materialScene
import numpy
import pv
import stage
from paraview import simple, smstate, smtrace

DOCS = pathlib.Path(__file__).parents[2] / "docs"
EXAMPLES = DOCS.parent / "examples"

# Every property of the view: default, another value as a script gives it.
PROPERTIES = {
    **described.of_view(),
    "RelievoMarkSelection": (0, 1),
    "RelievoShadows": (0, 1),
    "RelievoLightKitCasts": ("Key light, without a sun", "Nothing"),
    "RelievoSun": (0, 1),
    "RelievoSunBy": ("Angles", "Date and place"),
    "RelievoSunAzimuth": (150.0, 240.0),
    "RelievoSunElevation": (45.0, 35.0),
    "RelievoSunDate": ([2026, 6, 21], [2027, 2, 3]),
    "RelievoSunTime": (15.0, 10.5),
    "RelievoSunTimeZone": (0.0, 1.0),
    "RelievoSunLatitude": (48.0, -33.5),
    "RelievoSunLongitude": (0.0, 18.5),
    "RelievoSunNorth": (0.0, 25.0),
    "RelievoSunFill": (0.3, 0.1),
    "RelievoSunUpAxis": ("Z", "Y"),
    "RelievoSunIntensity": (0.7, 0.9),
    "RelievoSunColor": ([1.0, 1.0, 1.0], [1.0, 0.9, 0.7]),
    "RelievoSunKitShare": (0.3, 0.5),
    "RelievoEnvironment": ("", str(pv.OUTPUT / "axes.png")),
    "RelievoSkybox": (0, 1),
    "RelievoMarkSelection": (0, 1),
    "RelievoDisplayLayer": ("None", "normal"),
    "RelievoDisplayRange": ([0.0, 0.0], [5.0, 12.0]),
    "RelievoDisplayColormap": ("viridis", "hot"),
    "RelievoDisplayReversed": (0, 1),
    "RelievoDisplayGrey": (0, 1),
    "RelievoDisplayLegend": (1, 0),
}

# Wrong values, and the text of the warning or error; a value that Python refuses has an exception.
INVALID = (
    ("RelievoShadows", 5, "expected 0 to 1: 1 is taken"),
    ("RelievoShadowMapSize", 3, "expected 16 to 16384: 16 is taken"),
    ("RelievoShadowMapSize", 2**31 - 1, "expected 16 to 16384: 16384 is taken"),
    ("RelievoShadowLampMapSize", 3, "expected 16 to 16384: 16 is taken"),
    ("RelievoShadowTolerance", 5, "was given 5, expected 0 to 1: 1 is taken"),
    ("RelievoShadowTimeBudget", -1, "expected 0 to 3.6e+06: 0 is taken"),
    ("RelievoShadowStrength", 7, "was given 7, expected 0 to 1: 1 is taken"),
    ("RelievoShadowFilterRadius", -1, "expected 0 to 16: 0 is taken"),
    ("RelievoShadowBias", float("nan"), "was given nan, expected 0 to 100"),
    ("RelievoShadowMethod", 9, "expected 0 to 3: 3 is taken"),
    ("RelievoShadowMethod", "Magic", "ValueError"),
    ("RelievoLightKitCasts", -3, "expected 0 to 3: 0 is taken"),
    ("RelievoSunElevation", 200, "expected -90 to 90: 90 is taken"),
    ("RelievoSunAzimuth", float("inf"), "expected 0 to 360: 360 is taken"),
    ("RelievoSunBy", 2, "expected 0 to 1: 1 is taken"),
    ("RelievoSunDate", [2026, 13, 1], "was given 13, expected 1 to 12: 12 is taken"),
    ("RelievoSunTime", 25, "expected 0 to 24: 24 is taken"),
    ("RelievoSunLatitude", 91, "expected -90 to 90: 90 is taken"),
    ("RelievoSunLongitude", -181, "expected -180 to 180: -180 is taken"),
    ("RelievoSunTimeZone", 15, "expected -12 to 14: 14 is taken"),
    ("RelievoSunFill", -0.5, "expected 0 to 1: 0 is taken"),
    ("RelievoSunUpAxis", 7, "expected 0 to 2: 2 is taken"),
    ("RelievoSunIntensity", -1, "expected 0 to 1000: 0 is taken"),
    ("RelievoSunColor", [0.5, 2.0, 0.5], "was given 2, expected 0 to 1: 1 is taken"),
    ("RelievoSunKitShare", 1.5, "expected 0 to 1: 1 is taken"),
    ("RelievoDisplayLayer", "nosuch", "The layer 'nosuch' cannot be read"),
    ("RelievoDisplayLayer", "shadow_99", "The layer 'shadow_99' cannot be read"),
)


def value(view, name):
    """A property's value, as Python's own objects."""
    found, default = getattr(view, name), PROPERTIES[name][0]
    if isinstance(default, str):
        return str(found).strip("'")
    return list(found) if isinstance(default, list) else found


def read(view, name):
    """The numbers that a property holds, as a state file would have them."""
    held = view.SMProxy.GetProperty(name)
    return [held.GetElement(i) for i in range(held.GetNumberOfElements())]


def set_invalid_values():
    """Sets and resets each invalid value; the output of the process is the result."""
    pv.load()
    scene = stage.Stage((120, 80))
    scene.sun()
    first = pv.picture(scene.view)
    for number, (name, invalid, _) in enumerate(INVALID):
        # ParaView's messages go to the same place as these lines, in order.
        print(f"case {number} {name}", file=sys.stderr, flush=True)
        before = value(scene.view, name)
        try:
            setattr(scene.view, name, invalid)
        except ValueError as refused:
            print("ValueError", refused, file=sys.stderr, flush=True)
        if name != "RelievoShadowMapSize" or invalid < 16:
            shown = pv.picture(scene.view)
            if name == "RelievoDisplayLayer":
                print("kept", (shown == first).all(), file=sys.stderr, flush=True)
        print("reads", read(scene.view, name), file=sys.stderr, flush=True)
        setattr(scene.view, name, before)
        print("same", (pv.picture(scene.view) == first).all(), file=sys.stderr, flush=True)
    print("strength of a light", file=sys.stderr, flush=True)
    light = simple.AddLight(scene.view)
    light.RelievoShadowStrength = 5
    print("reads", read(light, "RelievoShadowStrength"), file=sys.stderr, flush=True)
    print("no plugin", file=sys.stderr, flush=True)
    try:
        simple.LoadPlugin("/nowhere/Relievo.so")
    except RuntimeError as refused:
        print("RuntimeError", refused, file=sys.stderr, flush=True)


class Scripting(judge.StageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        materialScene.write_axes("axes.png")

    def set_all(self):
        for name, (_, other) in PROPERTIES.items():
            setattr(self.view, name, other)

    def test_defaults_are_those_said_and_everything_has_a_text(self):
        known = [name for name in self.view.ListProperties() if name.startswith("Relievo")]
        told = [
            "RelievoFrameReport", "RelievoSamplesLeft", "RelievoShadowLayers", "RelievoSunAngles",
        ]  # fmt: skip
        self.assertEqual(sorted(known), sorted([*PROPERTIES, *told]))
        for name, (default, _) in PROPERTIES.items():
            self.assertEqual(value(self.view, name), default, name)
            self.assertGreater(len(getattr(type(self.view), name).__doc__.strip()), 15, name)

    def test_groups_that_the_docs_name(self):
        """Groups named in the docs are in the panel of the view, or of its representations."""
        proxies = (self.view.SMProxy, self.scene.ball_shown.SMProxy)
        groups = {
            proxy.GetPropertyGroup(i).GetXMLLabel()
            for proxy in proxies
            for i in range(proxy.GetNumberOfPropertyGroups())
        }
        named = set()
        for page in [DOCS / "paraview.md", *(DOCS / "passes").glob("*.md")]:
            named.update(re.findall(r"\*([^*]+ \(Relievo\))\*", page.read_text()))
        self.assertGreater(len(named), 5)
        self.assertLessEqual(named, groups)

    def test_names_in_the_examples(self):
        """testPVTour runs them, at night."""
        simple.AddLight(self.view)
        (light, *_) = self.view.AdditionalLights
        known = set()
        for proxy in (self.view, self.scene.ball_shown, light):
            known.update(proxy.ListProperties())
        named = set()
        for page in EXAMPLES.glob("*paraview*.py"):
            named.update(re.findall(r"\.(Relievo\w+)(?! *\()", page.read_text()))
        self.assertGreater(len(named), 30)
        self.assertLessEqual(named, known)

    def test_trace_records_every_property(self):
        light = simple.AddLight(self.view)
        smtrace.start_trace()
        # The panel's actions when its values are applied.
        for proxy, values in (
            (self.view, {name: other for name, (_, other) in PROPERTIES.items()}),
            (light, {"RelievoShadowStrength": 0.25}),
        ):
            item = smtrace._create_trace_item_internal(
                "PropertiesModified", kwargs={"proxy": proxy}
            )
            for name, other in values.items():
                setattr(proxy, name, other)
            item.finalize()
            del item
        trace = smtrace.stop_trace()
        for name, (_, other) in PROPERTIES.items():
            self.traced(trace, name, other)
        self.traced(trace, "RelievoShadowStrength", 0.25)

    def test_states_restore_the_picture_in_fresh_processes(self):
        self.scene.sun()
        self.view.RelievoShadowStrength = 0.8
        light = simple.AddLight(self.view)
        light.Coords, light.Type = "Scene", "Positional"
        light.Position, light.FocalPoint = [3.0, -2.0, 4.0], [0.0, 0.0, 0.0]
        light.Intensity, light.RelievoShadowStrength = 0.5, 0.5
        picture = pv.picture(self.view)
        self.view.RelievoShadows = 0
        plain = pv.picture(self.view)
        self.view.RelievoShadows = 1
        pvsm, python = pv.OUTPUT / "state.pvsm", pv.OUTPUT / "state.py"
        simple.SaveState(str(pvsm))
        python.write_text(smstate.get_state())
        for state in (pvsm, python):
            found = pv.OUTPUT / (state.name + ".npy")
            said = pv.run(__file__, "restore", "plugin", state, found, tool="pvbatch")
            self.assertEqual(pv.messages(said), [], state.name)
            self.same(numpy.load(found), picture, state.name)
        # Without the plugin: ParaView's own picture, or its own words, and no crash.
        found = pv.OUTPUT / "without.npy"
        said = pv.run(__file__, "restore", "none", pvsm, found)
        self.assertIn("restored []", said)
        self.differ(numpy.load(found), plain, "neither sun nor shadows")
        said = pv.run(__file__, "restore", "none", python, found, status=None)
        self.assertRegex(
            said,
            "AttributeError: Attribute RelievoShadow"
            if pv.VERSION < (6, 0)
            else r'WARN\| Property "RelievoShadows=1" is not available on Render View',
        )

    def test_undo_and_redo(self):
        stack = pv.UndoStack(self, len(PROPERTIES))
        # The stack has no state before the first change that it sees of an object.
        self.view.RelievoSunAzimuth = 1.0
        self.view.RelievoSunAzimuth = PROPERTIES["RelievoSunAzimuth"][0]
        own = pv.picture(self.view)
        for name, (default, other) in PROPERTIES.items():
            stack.change(self.view, name, other)
            stack.undo()
            self.assertEqual(value(self.view, name), default, name)
            stack.redo()
            self.assertEqual(value(self.view, name), other, name)
        changed = pv.picture(self.view)
        self.differ(changed, own, "all changed")
        for _ in PROPERTIES:
            stack.undo()
        self.same(pv.picture(self.view), own, "all undone")
        for _ in PROPERTIES:
            stack.redo()
        self.same(pv.picture(self.view), changed, "all done again")

    def test_invalid_values_and_a_plugin_that_is_not_there(self):
        said = pv.run(__file__, "invalid", tool="pvbatch")
        cases, _, rest = said.partition("strength of a light")
        light, _, missing = rest.partition("no plugin")
        self.assertEqual(
            light.count("RelievoShadowStrength was given 5, expected 0 to 1: 1 is taken"), 1)
        self.assertIn("reads [1.0]", light)
        self.assertIn("RuntimeError Problem loading plugin /nowhere/Relievo.so", missing)
        cases = cases.split("case ")[1:]
        self.assertEqual(len(cases), len(INVALID), said)
        for (name, invalid, words), text in zip(INVALID, cases):
            self.assertIn(words, text, f"{name} = {invalid}")
            self.assertEqual(text.count(words), 1, f"{name} = {invalid} is told once: {text}")
            self.assertIn("same True", text, f"{name} = {invalid}: the picture afterwards")
            taken = re.search(r"(\S+) is taken", words)
            if taken:  # the property has the used value
                held = json.loads(re.search(r"reads (\[.*\])", text).group(1))
                self.assertIn(float(taken.group(1)), held, f"{name} = {invalid}")
            self.assertNotIn("kept False", text, f"{name} = {invalid}: the picture meanwhile")

    def test_the_frame_report(self):
        def report():
            self.view.UpdatePropertyInformation()
            return self.view.GetProperty("RelievoFrameReport").GetElement(0)

        self.assertEqual(report(), "")
        self.scene.sun()
        for _ in range(4):
            pv.picture(self.view)
        stages = {each["name"]: each for each in json.loads(report())["stages"]}
        self.assertTrue(stages["shadows"]["ran"])
        self.assertEqual(stages["shadows"]["bytes"], 4 * 2048**2)
        reason = stages["shadows"]["reason"].split("; ")
        self.assertRegex(reason[0], r"^1 light casts \(sun\), 1 map of 2048 x 2048 texels")
        chosen = [each for each in reason if each.endswith("cast none: it is chosen so")]
        self.assertEqual([each.split(", ").count("key light") for each in chosen], [1])
        self.scene.sun(on=False, shadows=False)
        pv.picture(self.view)
        self.assertEqual(report(), "", "all off: no frame of Relievo is drawn")


if sys.argv[1:2] == ["restore"]:
    if sys.argv[2] == "plugin":
        pv.load()
    shown = pv.restore(*sys.argv[3:])
    print("restored", [name for name in shown.ListProperties() if "Relievo" in name])
    pv.leave()
elif sys.argv[1:2] == ["invalid"]:
    set_invalid_values()
    pv.leave()
elif __name__ == "__main__":
    pv.main()
