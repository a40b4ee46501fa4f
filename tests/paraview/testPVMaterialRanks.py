# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Materials of data that are spread over ranks."""

import os
import pathlib
import subprocess

import pv

SCENE = pathlib.Path(__file__).with_name("materialScene.py")


class MaterialRanks(pv.Test):
    def test_ranks(self):
        """A square in two parts on two ranks, and in one."""
        pictures = []
        for ranks in (1, 2):
            launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks)]
            script = [SCENE, "ranks", pv.OUTPUT, ranks]
            done = subprocess.run(
                [*launcher, str(pv.TOOLS / "pvbatch"), *map(str, script)],
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
                timeout=60,
                # pvpython is a rank of its own already; variables that its children inherit say so.
                env={n: v for n, v in os.environ.items()
                     if not n.startswith(("OMPI_", "PMIX_", "ORTE_"))},
            )  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertEqual(pv.messages(done.stdout), [])
            pictures.append({step: pv.read(pv.OUTPUT / f"{ranks}-{step}.png")
                             for step in ("off", "relief", "normals", "off-again")})  # fmt: skip
        one, two = pictures
        for step in one:
            # The triangles are others: a texel's look may fall on the other side of an edge.
            self.near(one[step], two[step], step, level=2, share=0.002)
        self.differ(one["relief"], one["off"], "relief", share=0.1)
        self.differ(one["normals"], one["off"], "normals", share=0.1)
        self.same(two["off"], two["off-again"], "off again")


if __name__ == "__main__":
    pv.main()
