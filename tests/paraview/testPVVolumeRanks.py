# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters of blocks, caves, voxels and particles give equal results on two ranks and on one."""

import pathlib

import numpy
import pv

NAMES = ["caves", "blocks", "shell", "cubes", "particles"]
SCENE = pathlib.Path(__file__).with_name("volumeRanks.py")


def make(ranks):
    """The tables of so many ranks by name, a list with one of each, and ParaView's output."""
    launcher = pv.mpirun(ranks) if ranks > 1 else ()
    said = pv.run(SCENE, pv.OUTPUT, ranks, tool="pvbatch", launcher=launcher)
    parts = {
        name: [numpy.load(pv.OUTPUT / f"{name}-{ranks}-{rank}.npy") for rank in range(ranks)]
        for name in NAMES
    }
    return parts, said


def ordered(tables):
    """All rows that there are, each once, in order."""
    return numpy.unique(numpy.concatenate(tables), axis=0)


class VolumeRanks(pv.Test):
    """Two ranks against one."""

    def test_two(self):
        """Bit for bit, with a part on each rank."""
        one, said_by_one = make(1)
        two, said_by_two = make(2)
        self.assertEqual(pv.messages(said_by_one) + pv.messages(said_by_two), [])
        for name in NAMES:
            with self.subTest(name):
                whole = one[name][0]
                self.assertGreater(len(whole), 400)
                for part in two[name]:
                    self.assertGreater(len(part), 0.2 * len(whole))
                # Images share a layer of points; of all others, each is on one rank.
                if name != "caves":
                    self.assertEqual(sum(len(part) for part in two[name]), len(whole))
                numpy.testing.assert_array_equal(ordered(two[name]), ordered(one[name]))


if __name__ == "__main__":
    pv.main()
