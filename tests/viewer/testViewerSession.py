# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sessions of which there is no picture: the viewer names the file in one line, and ends."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

MESH = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
MARK = {"relievo-viewer": 1}


class Session(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        (self.folder / "triangle.off").write_text(MESH)

    def view(self):
        return subprocess.run(
            [os.environ["VIEWER"], "session.json", "--once"], cwd=self.folder,
            capture_output=True, text=True, timeout=60, check=False)  # fmt: skip

    def refused(self, says):
        done = self.view()
        self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
        self.assertRegex(done.stderr, r"\Arelievo-viewer: .*session\.json: .*\n\Z")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(says, done.stderr)

    def test_whole(self):
        words = [str(self.folder / "triangle.off")]
        (self.folder / "session.json").write_text(json.dumps({**MARK, "words": words}))
        done = self.view()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\A\d+x\d+\n\Z")

    def test_wrong(self):
        off = str(self.folder / "triangle.off")
        for content, says in (
            ("", "is no session"),
            ("{", "is no session"),
            ("[]", "is no session"),
            (json.dumps({"relievo-viewer": 2, "words": [off]}), "is no session"),
            (json.dumps(MARK), "is no session"),
            (json.dumps({**MARK, "words": off}), "is no session"),
            (json.dumps({**MARK, "words": [off, 3]}), "are not all text"),
            (json.dumps({**MARK, "words": ["a\0b.off"]}), "are not all text"),
            (json.dumps({**MARK, "words": []}), "nothing to draw"),
            (json.dumps({**MARK, "words": ["--preset", "studio"]}), "nothing to draw"),
            (json.dumps({**MARK, "words": [off, "64x64"]}), "64x64: no reader"),
            (json.dumps({**MARK, "words": [off, "--frob"]}), "--frob"),
            (json.dumps({**MARK, "words": [off, "--preset", "a\nb"]}), "“Preset” in Scene"),
            (json.dumps({**MARK, "words": [off, "--size", "0x0"]}), "--size"),
            (json.dumps({**MARK, "words": [off, "--times", "x"]}), "--times"),
        ):
            with self.subTest(content=content):
                (self.folder / "session.json").write_text(content)
                self.refused(says)

    def test_no_file(self):
        path = self.folder / "session.json"
        self.refused("No such file")
        path.mkdir()
        self.refused("it is a folder")
        path.rmdir()
        os.mkfifo(path)
        self.refused("it is a pipe")


if __name__ == "__main__":
    unittest.main()
