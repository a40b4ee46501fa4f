# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Materials of data that are spread over ranks."""

import pathlib

import pv

SCENE = pathlib.Path(__file__).with_name("materialScene.py")
STEPS = ("off", "relief", "normals", "sky", "glass", "off-again")


def draw(names, *words, **how):
    """All steps' pictures, of each name."""
    said = pv.run(SCENE, "ranks", pv.OUTPUT, names, *words, **how)
    if pv.messages(said):
        raise AssertionError(f"{names}: {said}")
    return [{step: pv.read(pv.OUTPUT / f"{name}-{step}.png") for step in STEPS}
            for name in names.split(",")]  # fmt: skip


class MaterialRanks(pv.Test):
    """Against one process that draws alone."""

    @classmethod
    def setUpClass(cls):
        (cls.alone,) = draw("alone")

    def compare(self, pictures, where):
        # The triangles are others: a texel's look may fall on the other side of an edge.
        for step in STEPS:
            self.near(self.alone[step], pictures[step], f"{step} {where}", level=2, share=0.002)
        self.same(pictures["off"], pictures["off-again"], f"off again {where}")

    def test_scene(self):
        """Each step is another."""
        for first, second in zip(STEPS, STEPS[1:]):
            self.differ(self.alone[first], self.alone[second], f"{first} {second}", share=0.1)

    def test_server(self):
        """A square in two parts, drawn by a server's two ranks and by its client."""
        with pv.Server(launcher=pv.mpirun(2)) as server:
            for where, pictures in zip(("server", "client"), draw("server,client", server.port)):
                self.compare(pictures, f"by {where}")
            self.assertEqual(pv.messages(server.text()), [])


if __name__ == "__main__":
    pv.main()
