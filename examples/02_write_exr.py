# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes many layers to one OpenEXR file, and reads them as numpy arrays.

    02_write_exr.py [FOLDER]      writes FOLDER/layers.exr
"""

import numpy
import relievo
import scene

renderer, window = scene.make()
layers = ["color", "depth", "normal", "position", "actor", "cell", "Elevation"]
image = relievo.capture(renderer, layers)
path = scene.folder() / "layers.exr"
relievo.write_exr(path, image, compression="zip")
print(f"{path}: {path.stat().st_size} bytes")

back = relievo.read_exr(path)
for name in relievo.layer_names(back):
    values = relievo.layer(back, name)
    known = values[numpy.isfinite(values)]
    print(f"{name:10} {values.shape} {values.dtype}: {known.min():.6g} to {known.max():.6g}")

known = relievo.attributes(back)
print("near and far:", known["near"], known["far"])
print("light 0:", known["lights"][0])

# Layers are consistent: a pixel shows one point of one surface in all of them.
depth, actor = relievo.layer(back, "depth"), relievo.layer(back, "actor")
for i in range(actor.max() + 1):
    print(f"actor {i}: {(actor == i).sum()} pixels, nearest at {depth[actor == i].min():.4f}")
