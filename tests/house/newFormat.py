# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new format of data sets is a class in a file of its own, a word of dataset/CMakeLists.txt and a
row of its page: after that the command, its help, its completion and Python have it. For
testNewPass.py, which builds the tree anyway.

The format writes where cameras stand, a line for each, and its pictures.
"""

import os

CLASS = """// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"
#include "DatasetFormats.h"

namespace dataset
{
namespace
{
class LinesFormat : public DatasetFormat
{
public:
  LinesFormat()
    : DatasetFormat("lines")
  {
    this->NeedsK = true;
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects&,
    const Json&, const std::string& name) const override
  {
    WriteDatasetPictures(style, view, "pictures", name);
  }

  std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle&,
    const std::vector<std::string>&, const std::vector<Json>& records) const override
  {
    std::string lines;
    for (const Json& record : records)
    {
      lines += record["camera"]["t"].dump() + "\\n";
    }
    return { { "lines.txt", lines } };
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeLinesFormat()
{
  return std::make_unique<LinesFormat>();
}
}
"""


def replace(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1, (path, old)
    path.write_text(text.replace(old, new), encoding="utf-8")


def add(tree):
    """The class, its word, and their documentation."""
    (tree / "dataset" / "formats" / "LinesFormat.cxx").write_text(CLASS, encoding="utf-8")
    replace(tree / "dataset" / "CMakeLists.txt", "Npz Yolo Kitti WebDataset)",
            "Npz Yolo Kitti WebDataset Lines)")
    replace(tree / "docs" / "datasets.md", "| `npz` | `NUMBER.npz`",
            "| `lines` | `pictures/`, `depth/` and `lines.txt`, where cameras stand |\n"
            "| `npz` | `NUMBER.npz`")  # fmt: skip


def on_the_command_line(run, build, folder):
    """In the help and the completion's words, refused and written."""
    relievo = build / "bin" / "relievo"
    assert "yolo, kitti, webdataset or lines (bop)" in " ".join(run([relievo, "--help"]).split())
    assert "bop coco nerf npz yolo kitti webdataset lines\n" in run([relievo, "--words"])
    mesh = folder / "seen.off"
    mesh.write_text("OFF\n3 1 0\n-1 -1 0\n1 -1 0\n-1 1 0\n3 0 1 2\n", encoding="utf-8")
    words = [relievo, "dataset", mesh, "--poses", "orbit:3", "--size", "32x24", "--format", "lines",
             "--preset", "none", "--out"]  # fmt: skip
    run([*words, folder / "lines"])
    assert len((folder / "lines" / "lines.txt").read_text(encoding="utf-8").splitlines()) == 3
    assert (folder / "lines" / "pictures" / "000002.png").exists()
    assert not (folder / "lines" / "models").exists()
    said = run([*words, folder / "no", "--lens", "equirectangular"], status=2)
    assert "which has no K; expected the format coco, npz, yolo or webdataset" in said, said


PYTHON = """
import os
import sys

import relievo
from vtkmodules.vtkFiltersSources import vtkSphereSource

assert "npz, yolo, kitti, lines" in relievo.write_dataset.__doc__
folder = sys.argv[1] + "/python"
relievo.write_dataset(vtkSphereSource(), "orbit:2", folder, "lines", size=(32, 24))
assert len(open(folder + "/lines.txt").readlines()) == 2
"""


def in_python(run, build, python, folder):
    """A word of relievo.write_dataset and of its docstring."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON, folder / "lines"], env={**os.environ, "PYTHONPATH": path})
