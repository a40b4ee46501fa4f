# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shell completion, manual page and the tables of options in docs agree with the command's own
help."""

import os
import pathlib
import re
import subprocess
import unittest

COMPLETION = os.environ["COMPLETION"]
MANUAL = os.environ["MANUAL"]  # empty where none is made
RELIEVO = os.environ["RELIEVO"]
HELP = subprocess.run(
    [RELIEVO, "--help"], stdout=subprocess.PIPE, text=True, check=True
).stdout
WORDS = subprocess.run(
    [RELIEVO, "--words"], stdout=subprocess.PIPE, text=True, check=True
).stdout
VERBS = ("render", "compare", "dataset", "visible", "viewshed", "sun", "cover", "view-factors",
         "merge", "verify", "status", "cave", "bench")  # fmt: skip
DOCS = pathlib.Path(COMPLETION).parents[3] / "docs"

# A substitute for the parts of bash-completion that complete files and colons.
STUBS = """
_init_completion() { words=("${COMP_WORDS[@]}") cword=$COMP_CWORD
  cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]}; }
_filedir() { COMPREPLY=("FILE ${1-}"); }
__ltrim_colon_completions() { :; }
compopt() { :; }
"""


def options_of(verb):
    """Each option of that part of the help, with its text."""
    end = f"(?=^(?:{'|'.join(VERBS)}|stages|Options) )"
    part = re.search(rf"^{verb} (?:.|\n)*?{end}", HELP, re.M).group()
    found = re.split(r"^  (--?[a-z][a-z-]*)", part, flags=re.M)[1:]
    return dict(zip(found[::2], found[1::2]))


def rows_after(text):
    """The next table's rows, by the option in the first cell."""
    table = re.search(r"^\|---.*\n((?:\|.*\n)+)", text, re.M).group(1)
    return {re.search(r"--?[a-z][a-z-]*", row).group(): row for row in table.splitlines()}


def tables_of_render():
    """The page's options of outputs, and those of the scene."""
    text = (DOCS / "command-line.md").read_text(encoding="utf-8").split("## Options")[1]
    outputs, scene = text.split("\nOptions of the scene and its look:\n")
    return rows_after(outputs), rows_after(scene)


def not_of_datasets():
    """Options of the scene that data sets do not take, as their page lists them."""
    page = (DOCS / "datasets.md").read_text(encoding="utf-8").split("## Options")[1]
    return set(re.findall(r"`(--[a-z-]+)`", re.search(r"except\s([^.]*)", page).group(1)))


def complete(*words, known=WORDS, program=RELIEVO):
    """Bash's completions of the last word; `known` are the words requested by the completion
    before, so that these tests do not start the command each time."""
    script = f"""{STUBS}
source {COMPLETION}
COMP_WORDS=({pathlib.Path(program).name} "$@") COMP_CWORD=$#
_relievo {program}
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
    done = subprocess.run(
        ["bash", "-c", script, "bash", *words],
        env={**os.environ, "_relievo_words": known},
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    return done.stdout.splitlines() if done.stdout.strip() else []


class Completion(unittest.TestCase):
    def test_the_parts_of_the_help_are_found(self):
        self.assertGreater(len(options_of("render")), 30)
        self.assertEqual(set(options_of("bench")), {"--beside", "--list", "--out", "--quick"})

    def test_options_are_those_of_the_help(self):
        for verb in VERBS:
            offered = complete(verb, "-", known="")
            known = set(options_of(verb))
            if verb == "dataset":  # with options of render
                known |= set(tables_of_render()[1]) - not_of_datasets() | {"--lens"}
            self.assertEqual(sorted(offered), sorted(known))

    def test_the_viewer_takes_the_words_of_render(self):
        viewer = RELIEVO + "-viewer"
        offered = complete("-", known="", program=viewer)  # asks the command beside it
        own = {"--once", "--help", "--version"}
        self.assertEqual(set(offered), set(tables_of_render()[1]) | own)
        self.assertEqual(
            complete("a.off", "--preset", "", program=viewer),
            complete("render", "a.off", "--preset", ""),
        )
        self.assertEqual(complete("", program=viewer), complete("render", ""))

    def test_the_beginning_of_an_option(self):
        offered = complete("render", "a.off", "--sha")
        self.assertLessEqual({"--shading", "--shadow-size", "--shadows"}, set(offered))
        self.assertTrue(all(option.startswith("--sha") for option in offered), offered)

    def test_values_are_those_of_the_help(self):
        for verb in VERBS:
            for option, text in options_of(verb).items():
                values = complete(verb, option, "")
                for value in values:
                    options = {**options_of(verb), **options_of("render")}  # behind a flag
                    if not value.startswith("FILE") and value not in options:
                        self.assertRegex(text, rf"(?<![\w-]){re.escape(value)}(?:(?<=:)|(?![\w-]))")

    def test_all_values_are_offered(self):
        # Where the help lists values as "a, b or c", the completion has every one.
        for option in ("--shading", "--preset", "--colormap", "--shadows"):
            text = " ".join(options_of("render")[option].split())
            listed = re.search(r"((?:[a-z-]+, )+[a-z-]+ or [a-z-]+)", text).group()
            offered = complete("render", option, "")
            others = ["none"] if option == "--preset" else []
            self.assertEqual(sorted([*re.split(r", | or ", listed), *others]), sorted(offered))

    def test_files(self):
        pattern = complete("render", "")[0]
        listed = re.findall(r"\.\w+", re.search(r"FILE  +((?:.|\n)+?)Grids", HELP).group(1))
        self.assertGreater(len(listed), 15)
        script = 'for f in "${@:2}"; do [[ ${f#.} == $1 ]] || echo $f; done'
        left_out = subprocess.run(
            ["bash", "-O", "extglob", "-c", script, "bash", pattern.split()[1], *listed],
            stdout=subprocess.PIPE,
            text=True,
            check=True,
        ).stdout
        self.assertEqual(left_out, "")
        self.assertEqual(complete("render", "a.off", "--png", ""), ["FILE @(png)"])
        self.assertEqual(complete("cave", "-o", ""), ["FILE @(vti)"])
        self.assertEqual(complete("dataset", "--out", ""), ["FILE -d"])
        self.assertEqual(complete("visible", "--lens", "./a"), ["FILE @(json|yml|yaml|xml|txt|gz)"])

    def test_first_word(self):
        self.assertEqual(complete("re"), ["render"])
        self.assertEqual(complete("s"), ["sun", "status", "stages"])
        self.assertEqual(set(complete("")), {*VERBS, "stages", "--help", "--version"})
        self.assertEqual(complete("stages", ""), [])

    def test_nothing_is_offered_for_a_number(self):
        self.assertEqual(complete("render", "--size", ""), [])
        self.assertEqual(complete("cave", "--seed", ""), [])
        self.assertEqual(complete("render", "--edges", ""), complete("render", ""))


class Pages(unittest.TestCase):
    def test_tables(self):
        """Each command's table has its options, and no others; bench's are in the text."""
        page = (DOCS / "command-line.md").read_text(encoding="utf-8")
        for verb, text in (
            ("visible", page.split("| option of `visible` |")[1]),
            ("viewshed", page.split("| option of `viewshed` |")[1]),
            ("sun", page.split("| option of `sun` |")[1]),
            ("cover", page.split("| option of `cover` |")[1]),
            ("view-factors", page.split("| option of `view-factors` |")[1]),
            ("dataset", (DOCS / "datasets.md").read_text("utf-8").split("## Options")[1]),
            ("compare", (DOCS / "compare.md").read_text("utf-8").split("| option of")[1]),
            ("cave", (DOCS / "caves.md").read_text("utf-8").split("## Settings")[1]),
        ):
            table = re.search(r"^\|---.*\n((?:\|.*\n)+)", text, re.M).group(1)
            cells = [row.split("|")[1:3] for row in table.splitlines()]
            named = re.findall(r"`(--?[a-z][a-z-]*)[ `\[]", "\n".join(map(str, cells)))
            self.assertLessEqual(set(options_of(verb)), {*named, "-o"}, verb)
            firsts = [cell[verb == "cave"] for cell in cells]
            said = re.findall(r"`(--?[a-z][a-z-]*)[ `\[]", "\n".join(firsts))
            self.assertLessEqual(set(said), set(options_of(verb)), verb)

    def test_rows_of_render(self):
        """Each row of the page has the option's form, its bounds and its choices, as the help."""
        outputs, scene = tables_of_render()
        self.assertFalse(set(outputs) & set(scene))
        rows = {**outputs, **scene}
        self.assertEqual(set(rows), set(options_of("render")))
        words = dict(re.findall(r"^render (--\S+) \S+ ?(.*)$", WORDS, re.M))
        for option, text in options_of("render").items():
            row = rows[option].replace("−", "-").replace("\\|", "|")
            form = re.match(r"(?: (\S+))?(?:  |\n|$)", text).group(1)
            said = f"`{option} {form}`" if form else f"`{option}`"
            with self.subTest(option):
                self.assertTrue(row.startswith(f"| {said} |"), row)
                for bounds in re.findall(r"-?[\d.]+ to -?[\d.]+\d", " ".join(text.split())):
                    self.assertIn(bounds, row)
                if option not in ("--lens", "--light"):  # which have tables of their own
                    self.assertEqual([w for w in words[option].split() if w not in row], [])

    def test_files(self):
        """Input formats, in the table and in the texts."""
        page = (DOCS / "command-line.md").read_text(encoding="utf-8")
        table = page.split("| extension | drawn as |")[1].split("\n\n")[0]
        listed = [each for row in table.splitlines()[2:]
                  for each in re.findall(r"`\.(\w+)`", row.split("|")[1])]  # fmt: skip
        read = re.search(r"^render \. (.*)$", WORDS, re.M).group(1)
        self.assertEqual(sorted(listed), sorted(read.split("|")))

    def test_lenses(self):
        """The words of sensors, in their page's table and in the help, form by form."""
        page = (DOCS / "cameras.md").read_text(encoding="utf-8")
        rows = page.split("### A lens in a word")[1].split("|---|---|\n")[1].splitlines()
        listed = [form for row in rows[:rows.index(next(r for r in rows if ".yml" in r))]
                  for form in re.findall(r"`([^`]+)`", row.split("|")[1])]  # fmt: skip
        said = " ".join(options_of("render")["--lens"].split())
        said = said.split("by rays: ")[1].split("; or a cal")[0]
        said = re.sub(r", with ,K=[^;]*;", ",", said)
        self.assertEqual(listed, re.split(r", (?=[a-z])", said))

    def test_synopsis(self):
        """The ways to call it, word for word."""
        page = (DOCS / "command-line.md").read_text(encoding="utf-8")
        listed = re.findall(r"^    (relievo .*)$", page.split("\n\n`render`")[0], re.M)
        self.assertEqual(listed, re.findall(r"^  (relievo .*)$", HELP.split("\n\nrender")[0], re.M))


class Manual(unittest.TestCase):
    def test_it_has_each_option_and_each_word(self):
        if not MANUAL:
            self.skipTest("this build makes no manual page")
        page = pathlib.Path(MANUAL).read_text(encoding="utf-8")
        self.assertTrue(page.startswith(".TH RELIEVO 1 "))
        plain = re.sub(r"^\.\w\w? ?", "", page, flags=re.M).replace("\\-", "-").replace("\\e", "\\")
        plain = plain.replace("\\&", "").replace("\\:", "")
        missing = [word for word in HELP.replace("\nExamples\n", "\n").split()
                   if word not in plain.split()]  # fmt: skip
        self.assertEqual(missing, [])
        named = re.findall(r"^\.TP\n\.B (\\-\S+)", page, re.M)
        for verb in VERBS:
            for option in options_of(verb):
                self.assertIn(option.replace("-", "\\-"), named)


if __name__ == "__main__":
    unittest.main()
