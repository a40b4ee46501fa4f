# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Red and blue stereo: each frame is drawn for two eyes."""

from parts import actor, cube, plane, show, sphere

window = show(actor(sphere()), actor(cube(at=(1.2, 0, 0)), (0.3, 0.5, 0.9)), actor(plane()))
window.SetStereoTypeToRedBlue()
window.StereoRenderOn()
