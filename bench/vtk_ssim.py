# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors by VTK's SSIM, as vtkTesting computes them since VTK 9.4, for bench/compare.py.

    python bench/vtk_ssim.py

Reads lines of two names of PNG files, separated by a tab, and prints a line for each pair: the
errors that TIGHT_VALID and LOOSE_VALID compare with a test's threshold. The Python needs VTK only;
its first line of output is VTK's version.
"""

import sys

from vtkmodules.vtkCommonCore import reference, vtkVersion
from vtkmodules.vtkImagingColor import vtkImageRGBToXYZ, vtkImageXYZToLAB
from vtkmodules.vtkImagingCore import vtkImageShiftScale, vtkImageSSIM
from vtkmodules.vtkIOImage import vtkPNGReader


def lab(file):
    """The last filter of a pipeline."""
    steps = vtkPNGReader(), vtkImageShiftScale(), vtkImageRGBToXYZ(), vtkImageXYZToLAB()
    steps[0].SetFileName(file)
    steps[1].SetScale(1 / 255)
    steps[1].SetOutputScalarTypeToDouble()
    for before, after in zip(steps, steps[1:], strict=False):
        after.SetInputConnection(before.GetOutputPort())
    return steps[-1]


def errors(files):
    compared = vtkImageSSIM()
    compared.SetInputToLab()
    compared.ClampNegativeValuesOn()
    pictures = [lab(file) for file in files]
    for port, each in enumerate(pictures):
        compared.SetInputConnection(port, each.GetOutputPort())
    compared.Update()
    tight, loose = reference(0.0), reference(0.0)
    vtkImageSSIM.ComputeErrorMetrics(
        compared.GetOutput().GetPointData().GetScalars(), tight, loose)  # fmt: skip
    return float(tight), float(loose)


def main():
    print(vtkVersion.GetVTKVersion(), flush=True)
    for line in sys.stdin:
        print(*errors(line.rstrip("\n").split("\t")), flush=True)


if __name__ == "__main__":
    main()
