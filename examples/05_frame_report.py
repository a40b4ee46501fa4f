# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cost of layers, from the frame report of a renderer with a custom pass; frees all memory.

    05_frame_report.py
"""

import relievo
import scene
from relievo.vtk.vtkRenderingOpenGL2 import vtkOpenGLFXAAPass, vtkRenderStepsPass

renderer, window = scene.make()
own = vtkOpenGLFXAAPass()
own.SetDelegatePass(vtkRenderStepsPass())
renderer.SetPass(own)

frame = relievo.attach(renderer)
for wanted in ([], ["depth"], ["depth", "normal", "cell"]):
    for layer in wanted:
        frame.RequestLayer(layer)
    relievo.report(frame)  # software OpenGL measures times only after a first read
    for _ in range(5):  # GPU times arrive some frames later, without waiting
        window.Render()
    print(f"\nasked for {wanted or 'nothing'}")
    for stage in relievo.report(frame)["stages"]:
        time = "" if stage["gpu_ms"] is None else f", {stage['gpu_ms']:.2f} ms on the GPU"
        state = "ran" if stage["ran"] else "did not run"
        print(f"  {stage['name']}: {state}: {stage['reason']}; {stage['bytes']} bytes{time}")

relievo.detach(renderer)
print("\nthe renderer has its own pass again:", renderer.GetPass() is own)
