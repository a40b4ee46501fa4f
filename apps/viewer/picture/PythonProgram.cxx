// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonProgram.h"

#include "vtkRelievoVTKVersions.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>
#include <vector>

#define RELIEVO_QUOTED_AS_IS(name) #name
#define RELIEVO_QUOTED(name) RELIEVO_QUOTED_AS_IS(name)

namespace viewer
{
namespace
{
struct Function
{
  const char* Name;
  const char* Text;
};

// Each calls none of those behind it, by name: what is called is what a program carries.
const Function Functions[] = {
  { "blocks", R"(def blocks(data):
    """The data itself, or all that composite data holds."""
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    found = []
    place = data.NewIterator()
    place.InitTraversal()
    while not place.IsDoneWithTraversal():
        found.append(place.GetCurrentDataObject())
        place.GoToNextItem()
    return found
)" },
  { "data", R"(def data(reader, path):
    """What a file holds."""
    reader.SetFileName(path)
    reader.Update()
    found = reader.GetOutputDataObject(0)
    if found is None or not any(block.GetNumberOfElements(0) for block in blocks(found)):
        raise SystemExit(f"{path}: VTK reads nothing of it")
    return found
)" },
  { "image", R"(def image(path):
    """An image, such as a map of normals."""
    ending = path[path.rfind("."):].lower()
    reader = (relievo.vtkRelievoEXRReader() if ending == ".exr" else
              vtkImageReader2Factory.CreateImageReader2FromExtension(ending))
    return data(reader, path)
)" },
  { "run", R"(def run(step, data):
    """What a filter makes of data."""
    step.SetInputDataObject(data)
    step.Update()
    return step.GetOutputDataObject(0)
)" },
  { "replaced", R"(def replaced(data, change):
    """The data changed, or composite data of which every block is."""
    if not isinstance(data, vtkCompositeDataSet):
        return change(data)
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    place = data.NewIterator()
    place.InitTraversal()
    while not place.IsDoneWithTraversal():
        copy.SetDataSet(place, change(place.GetCurrentDataObject()))
        place.GoToNextItem()
    return copy
)" },
  { "number_cells", R"(def number_cells(mesh):
    """With the number of each cell."""
    ids = numpy_to_vtkIdTypeArray(numpy.arange(mesh.GetNumberOfCells()), deep=True)
    ids.SetName("vtkOriginalCellIds")
    copy = mesh.NewInstance()
    copy.ShallowCopy(mesh)
    copy.GetCellData().AddArray(ids)
    return copy
)" },
  { "surface", R"(def surface(data):
    """The polygons to draw."""
    if all(isinstance(block, vtkPolyData) for block in blocks(data)):
        return data
    return run(vtkGeometryFilter(), replaced(data, lambda block: number_cells(block)))
)" },
  { "finite_mesh", R"(def finite_mesh(data):
    """Without the cells that have a point which is not finite."""
    if not isinstance(data, vtkPolyData) or data.GetNumberOfPoints() == 0:
        return data
    points = vtk_to_numpy(data.GetPoints().GetData())
    good = numpy.isfinite(points).all(axis=1)
    mesh = vtkPolyData()
    if good.all() or not good.any():
        return data if good.all() else mesh
    mesh.ShallowCopy(data)
    if not mesh.GetCellData().HasArray("vtkOriginalCellIds"):
        mesh = number_cells(mesh)
    places = vtkPoints()
    places.SetDataType(data.GetPoints().GetDataType())
    places.DeepCopy(data.GetPoints())
    vtk_to_numpy(places.GetData())[~good] = points[good][0]
    mesh.SetPoints(places)
    mesh.BuildCells()
    corners = vtkIdList()
    for cell in range(mesh.GetNumberOfCells()):
        mesh.GetCellPoints(cell, corners)
        if not all(good[corners.GetId(i)] for i in range(corners.GetNumberOfIds())):
            mesh.DeleteCell(cell)
    mesh.RemoveDeletedCells()
    return mesh
)" },
  { "finite", R"(def finite(data):
    """The cells whose points are all finite."""
    return replaced(data, lambda mesh: finite_mesh(mesh))
)" },
  { "is_bare", R"(def is_bare(mesh):
    """Whether there are polygons without normals."""
    have = mesh.GetPointData().GetNormals() or mesh.GetCellData().GetNormals()
    return not have and mesh.GetNumberOfPolys() > 0
)" },
  { "smooth_mesh", R"(def smooth_mesh(mesh):
    """With normals, unless vertices or lines have points that no polygon has."""
    if not isinstance(mesh, vtkPolyData) or not is_bare(mesh):
        return mesh
    of_polygons = numpy.zeros(mesh.GetNumberOfPoints(), dtype=bool)
    for cells in (mesh.GetPolys(), mesh.GetStrips()):
        of_polygons[vtk_to_numpy(cells.GetConnectivityArray())] = True
    for cells in (mesh.GetVerts(), mesh.GetLines()):
        if not of_polygons[vtk_to_numpy(cells.GetConnectivityArray())].all():
            return mesh
    normals = vtkPolyDataNormals()
    normals.ConsistencyOff()
    return run(normals, mesh)
)" },
  { "smooth", R"(def smooth(data):
    """With normals."""
    return replaced(data, lambda mesh: smooth_mesh(mesh))
)" },
  { "by_material", R"(def by_material(path, file, mesh):
    """The cells of a mesh by the names of their materials in an OBJ file; None: without one."""
    names, name = [None] * (file.GetNumberOfVerts() + file.GetNumberOfLines()), None
    with open(path, "rb") as lines:
        for line in lines:
            words = line.split(None, 1)
            if words[:1] == [b"f"]:
                names.append(name)
            elif words[:1] == [b"usemtl"]:
                name = b"".join(words[1:]).strip()
    ids = mesh.GetCellData().GetArray("vtkOriginalCellIds")
    cells = {}
    for cell in range(mesh.GetNumberOfCells()):
        cells.setdefault(names[cell if ids is None else ids.GetValue(cell)], []).append(cell)
    return cells
)" },
  { "part", R"(def part(mesh, cells, coordinates):
    """These cells of a mesh; the name of their texture coordinates."""
    chosen = vtkPolyData()
    chosen.SetPoints(mesh.GetPoints())
    chosen.GetPointData().ShallowCopy(mesh.GetPointData())
    chosen.AllocateEstimate(len(cells), 4)
    chosen.GetCellData().CopyAllocate(mesh.GetCellData(), len(cells))
    ids = mesh.GetCellData().GetArray("vtkOriginalCellIds")
    original = vtkIdTypeArray()
    original.SetName("vtkOriginalCellIds")
    corners = vtkIdList()
    for cell in cells:
        mesh.GetCellPoints(cell, corners)
        copy = chosen.InsertNextCell(mesh.GetCellType(cell), corners)
        chosen.GetCellData().CopyData(mesh.GetCellData(), cell, copy)
        original.InsertNextValue(cell if ids is None else ids.GetValue(cell))
    chosen.GetCellData().AddArray(original)
    if coordinates:
        chosen.GetPointData().SetActiveTCoords(coordinates)
    return chosen
)" },
  { "turn", R"(def turn(actor):
    """Texture coordinates as the file turns its textures, for maps."""
    key = vtkProp.)" RELIEVO_QUOTED(RELIEVO_VTK_TEXTURE_TRANSFORM) R"(()
    keys, mapper = actor.GetPropertyKeys(), actor.GetMapper()
    if mapper is None or keys is None or keys.Length(key) != 16:
        return
    mapper.Update()
    mesh = mapper.GetInputDataObject(0, 0)
    before = mesh.GetPointData().GetTCoords()
    if before is None or before.GetNumberOfComponents() < 2:
        return
    by = [keys.Get(key, i) for i in range(16)]
    u, v = vtk_to_numpy(before)[:, :2].astype(float).T
    turned = [by[0] * u + by[1] * v + by[3], by[4] * u + by[5] * v + by[7]]
    after = numpy_to_vtk(numpy.stack(turned, axis=1).astype(numpy.float32), deep=True)
    after.SetName(before.GetName())
    copy = vtkPolyData()
    copy.ShallowCopy(mesh)
    copy.GetPointData().SetTCoords(after)
    mapper.SetInputDataObject(copy)
    keys.Remove(key)
)" },
  { "mapped_mesh", R"(def mapped_mesh(mesh, mapping, up):
    """With texture coordinates, where there are none."""
    if (not isinstance(mesh, vtkPolyData) or mesh.GetPointData().GetTCoords()
            or mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0):
        return mesh
    if mesh.GetNumberOfStrips() > 0:
        mesh = run(vtkTriangleFilter(), mesh)
    coordinates = relievo.vtkRelievoTextureCoordinates()
    coordinates.SetMapping(mapping)
    coordinates.SetUp(up)
    mesh = run(coordinates, mesh)
    mesh.GetPointData().RemoveArray("vtkOriginalPointIds")
    return mesh
)" },
  { "mapped", R"(def mapped(data, mapping, up):
    """With texture coordinates on every mesh."""
    return replaced(data, lambda mesh: mapped_mesh(mesh, mapping, up))
)" },
};

const std::pair<const char*, std::vector<const char*>> Modules[] = {
  { "util.numpy_support", { "numpy_to_vtk", "numpy_to_vtkIdTypeArray", "vtk_to_numpy" } },
  { "vtkCommonCore", { "vtkIdList", "vtkIdTypeArray", "vtkPoints" } },
  { "vtkCommonDataModel", { "vtkCompositeDataSet", "vtkPolyData" } },
  { "vtkCommonTransforms", { "vtkTransform" } },
  { "vtkFiltersCore", { "vtkPolyDataNormals", "vtkTriangleFilter" } },
  { "vtkFiltersGeometry", { "vtkGeometryFilter" } },
  { "vtkIOGeometry", { "vtkOBJReader", "vtkSTLReader" } },
  { "vtkIOImage", { "vtkImageReader2Factory", "vtkPNGWriter" } },
  { "vtkIOImport", { "vtkGLTFImporter" } },
  { "vtkIOLegacy", { "vtkGenericDataObjectReader" } },
  { "vtkIOPLY", { "vtkPLYReader" } },
  { "vtkIOXML", { "vtkXMLGenericDataObjectReader" } },
  { "vtkRenderingAnnotation", { "vtkScalarBarActor" } },
  { "vtkRenderingCore",
    { "vtkActor", "vtkColorTransferFunction", "vtkCompositePolyDataMapper", "vtkLight",
      "vtkPolyDataMapper", "vtkProp", "vtkRenderer", "vtkRenderWindow", "vtkTexture",
      "vtkWindowToImageFilter" } },
  { "vtkRenderingOpenGL2", { "vtkCompositePolyDataMapper2" } },
};

//------------------------------------------------------------------------------
bool IsNamePart(char letter)
{
  return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_';
}

// Whether the name stands in the lines as a whole word that is nobody's attribute, before this.
bool Has(const std::string& lines, const std::string& name, const std::string& before = "")
{
  const std::string word = name + before;
  for (std::size_t at = lines.find(word); at != std::string::npos; at = lines.find(word, at + 1))
  {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || (!IsNamePart(lines[at - 1]) && lines[at - 1] != '.');
    if (begins && (end == lines.size() || !IsNamePart(lines[end])))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string WriteImport(
  const std::string& lines, const std::string& module, const std::vector<const char*>& names)
{
  std::vector<std::string> used;
  std::copy_if(names.begin(), names.end(), std::back_inserter(used),
    [&lines](const char* name) { return Has(lines, name); });
  if (used.empty())
  {
    return "";
  }
  std::string text = "from vtkmodules." + module + " import ";
  const std::size_t most = 3; // in one line
  if (used.size() <= most)
  {
    for (const std::string& name : used)
    {
      text += (name == used.front() ? "" : ", ") + name;
    }
    return text + "\n";
  }
  text += "(\n";
  for (const std::string& name : used)
  {
    text += "    " + name + ",\n";
  }
  return text + ")\n";
}
}

//------------------------------------------------------------------------------
std::string CompletePython(const std::string& lines)
{
  std::string text = "\n" + lines;
  for (auto function = std::rbegin(Functions); function != std::rend(Functions); ++function)
  {
    if (Has(text, function->Name, "("))
    {
      text = "\n" + std::string(function->Text) + "\n" + text;
    }
  }
  std::string imports = Has(text, "numpy", ".") ? "import numpy\n" : "";
  imports += "import relievo\n";
  for (const auto& [module, names] : Modules)
  {
    imports += WriteImport(text, module, names);
  }
  return imports + "\n" + text;
}
}
