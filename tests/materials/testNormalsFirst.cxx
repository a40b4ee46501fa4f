// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shaders as VTK's main branch after 9.7 builds them: the normal comes before the colour, and where
// cells have colours or normals a geometry shader hands their number on. Layers, shadows and
// materials are the same in them: bit for bit, but for the rounding of a geometry shader.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoMaterial.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace testNormalsFirst
{
namespace
{
using namespace relievoTest;

// After VTK's tags, only code that passes a triangle on.
constexpr const char* Geometry = R"(//VTK::System::Dec
//VTK::PositionVC::Dec
//VTK::PrimID::Dec
//VTK::Color::Dec
//VTK::Normal::Dec
//VTK::TCoord::Dec
//VTK::Picking::Dec
//VTK::Clip::Dec
//VTK::Output::Dec
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
void main()
{
  for (int i = 0; i < 3; ++i)
  {
    //VTK::PrimID::Impl
    //VTK::Clip::Impl
    //VTK::Color::Impl
    //VTK::Normal::Impl
    //VTK::TCoord::Impl
    //VTK::Picking::Impl
    //VTK::PositionVC::Impl
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
  }
  EndPrimitive();
}
)";

using Shaders = std::map<vtkShader::Type, vtkShader*>;

class OrderedMapper : public vtkOpenGLPolyDataMapper
{
public:
  static OrderedMapper* New();
  vtkTypeMacro(OrderedMapper, vtkOpenGLPolyDataMapper);

  bool NormalsFirst = false;
  bool HandsCellsOn = false;
  int Reordered = 0;

protected:
  OrderedMapper() = default;
  ~OrderedMapper() override = default;

  void GetShaderTemplate(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    this->Superclass::GetShaderTemplate(shaders, renderer, actor);
    if (this->HandsCellsOn && shaders[vtkShader::Geometry]->GetSource().empty())
    {
      shaders[vtkShader::Geometry]->SetSource(Geometry);
    }
    if (!this->NormalsFirst)
    {
      return;
    }
    std::string fragment = shaders[vtkShader::Fragment]->GetSource();
    const std::string normal = "//VTK::Normal::Impl";
    const std::size_t to = fragment.find("//VTK::Color::Impl");
    const std::size_t from = fragment.find(normal);
    if (RELIEVO_CHECK(to != std::string::npos && from != std::string::npos) && from > to)
    {
      fragment.erase(from, normal.size());
      fragment.insert(to, normal + "\n  ");
      shaders[vtkShader::Fragment]->SetSource(fragment);
    }
    ++this->Reordered;
  }

  void ReplaceShaderColor(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    if (this->NormalsFirst)
    {
      this->Superclass::ReplaceShaderNormal(shaders, renderer, actor);
    }
    this->Superclass::ReplaceShaderColor(shaders, renderer, actor);
  }

  void ReplaceShaderNormal(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    if (!this->NormalsFirst)
    {
      this->Superclass::ReplaceShaderNormal(shaders, renderer, actor);
    }
  }
};
vtkStandardNewMacro(OrderedMapper);

enum Where
{
  Nowhere,
  Points,
  Cells
};

struct Case
{
  const char* Name;
  Where Colors;
  Where Normals;
  int Shading;
  bool Edges;
};

const Case Cases[] = {
  { "one colour, faces", Nowhere, Nowhere, VTK_PHONG, false },
  { "one colour, point normals", Nowhere, Points, VTK_PHONG, false },
  { "one colour, cell normals", Nowhere, Cells, VTK_PHONG, false },
  { "point colours, point normals", Points, Points, VTK_PHONG, false },
  { "cell colours, faces", Cells, Nowhere, VTK_FLAT, false },
  { "cell colours, point normals", Cells, Points, VTK_PHONG, false },
  { "cell colours, cell normals", Cells, Cells, VTK_PHONG, false },
  { "cell colours, point normals, edges", Cells, Points, VTK_PHONG, true },
  { "PBR, cell colours, point normals", Cells, Points, VTK_PBR, false },
};

// Normals that lean over one by one, and values that differ from one to the next.
void Fill(vtkDataSetAttributes* data, vtkIdType count, bool colors, bool normals)
{
  vtkNew<vtkFloatArray> value;
  vtkNew<vtkFloatArray> normal;
  normal->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    value->InsertNextValue(static_cast<float>(i % 5));
    const double lean = 0.1 * static_cast<double>(i % 3) - 0.1;
    const double height = std::sqrt(1. - 2. * lean * lean);
    normal->InsertNextTuple3(lean, -lean, height);
  }
  if (colors)
  {
    data->SetScalars(value);
  }
  if (normals)
  {
    data->SetNormals(normal);
  }
}

vtkSmartPointer<vtkPolyData> MakeMesh(const Case& of)
{
  vtkSmartPointer<vtkPolyData> mesh = ReliefPlane(3);
  mesh->GetPointData()->SetNormals(nullptr);
  Fill(mesh->GetPointData(), mesh->GetNumberOfPoints(), of.Colors == Points, of.Normals == Points);
  Fill(mesh->GetCellData(), mesh->GetNumberOfCells(), of.Colors == Cells, of.Normals == Cells);
  return mesh;
}

// A wavy square below a ball that throws a shadow on it.
struct Scene
{
  relievoTest::Stage Stage{ 160, 120 };
  vtkNew<OrderedMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkLight> Sun;
  vtkNew<vtkRelievoMaterial> Material;
  GLCheck Watch{ this->Stage.Window };

  Scene(const Case& of, bool normalsFirst, bool handsCellsOn)
  {
    vtkRenderer* renderer = this->Stage.Renderer;
    this->Mapper->NormalsFirst = normalsFirst;
    this->Mapper->HandsCellsOn = handsCellsOn;
    this->Mapper->SetInputData(MakeMesh(of));
    this->Mapper->SetScalarRange(0., 4.);
    this->Actor->SetMapper(this->Mapper);
    vtkProperty* look = this->Actor->GetProperty();
    look->SetInterpolation(of.Shading);
    look->SetEdgeVisibility(of.Edges);
    look->SetColor(0.8, 0.7, 0.5);
    look->SetSpecular(0.4);
    look->SetSpecularPower(20.);
    renderer->AddActor(this->Actor);
    AddActor(renderer, Moved(MakeBall(0.3), 0.2, 0.1, 0.6));
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetPosition(2., 1., 3.);
    this->Sun->SetFocalPoint(0., 0., 0.);
    renderer->AddLight(this->Sun);
    LookAtRelief(renderer, 40.);
    vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
    frame->ShadowsOn();
    frame->GetShadowStage()->SetMapSize(256); // the relief is searched in each of its texels
    this->Material->SetNormalMap(NormalImage(Waves, 32));
    this->Material->SetHeightMap(HeightImage(Waves, 32));
    this->Material->SetHeightScale(0.1);
    this->Material->DepthCorrectionOn();
    this->Material->SelfShadowOn();
    this->Material->Attach(this->Actor);
  }
  ~Scene()
  {
    this->Material->Detach(this->Actor);
    vtkRelievoPass::Detach(this->Stage.Renderer);
  }
};

// Pixels at which a component of the layer differs by more than rounding does.
int CountFar(const Layers& a, const Layers& b, const std::string& name, int components)
{
  int count = 0;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      bool far = false;
      for (int c = 0; c < components; ++c)
      {
        const double one = a.Value(name, x, y, c);
        const double other = b.Value(name, x, y, c);
        far = far || !(one == other || std::abs(one - other) < 1e-3);
      }
      count += far ? 1 : 0;
    }
  }
  return count;
}

void TestCase(const Case& of)
{
  const std::vector<std::string> names = { "depth", "normal", "geometric_normal", "albedo", "cell",
    "shadow_0" };
  std::vector<Layers> usualLayers;
  const bool ofCells = of.Colors == Cells || of.Normals == Cells;
  for (const bool handsCellsOn : { false, true })
  {
    if (handsCellsOn && !ofCells)
    {
      return;
    }
    const std::string what =
      std::string(of.Name) + (handsCellsOn ? ", through a geometry shader" : "");
    Scene usual(of, false, handsCellsOn);
    const auto picture = Picture(usual.Stage.Window);
    usualLayers.emplace_back(usual.Stage.Renderer, names, Way::Shared);
    const Layers& layers = usualLayers.back();
    RELIEVO_CHECK_THAT(layers.CountId("cell", 8) > 20, what + ": cells are known");
    Scene next(of, true, handsCellsOn);
    SamePicture(picture, Picture(next.Stage.Window), what);
    const Layers others(next.Stage.Renderer, names, Way::Shared);
    for (const std::string& name : names)
    {
      RELIEVO_CHECK_THAT(CountDifferent(layers, others, name) == 0, what + ": " + name);
    }
    RELIEVO_CHECK_THAT(next.Mapper->Reordered > 0, what + ": the order was changed");
  }
  // A geometry shader changes interpolated values by rounding, so a ray may miss a wave.
  const std::string what = std::string(of.Name) + ", with and without a geometry shader: ";
  RELIEVO_CHECK_THAT(CountDifferent(usualLayers[0], usualLayers[1], "cell") == 0, what + "cell");
  for (const std::string name : { "depth", "normal", "geometric_normal", "albedo" })
  {
    const int components = name == "depth" ? 1 : 3;
    RELIEVO_CHECK_AT_MOST(
      CountFar(usualLayers[0], usualLayers[1], name, components), 20, what + name);
  }
}

// The comparisons are not equal merely because material and shadow are missing.
void TestShown()
{
  Scene scene(Cases[1], true, true);
  const auto all = Picture(scene.Stage.Window);
  const Layers layers(scene.Stage.Renderer, { "shadow_0" }, Way::Shared);
  long long dark = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      dark += layers.Value("shadow_0", x, y) < 0.5 ? 1 : 0;
    }
  }
  RELIEVO_CHECK_THAT(dark > 100, "something is in shadow");
  scene.Material->EnabledOff();
  const Layers plain(scene.Stage.Renderer, { "normal" }, Way::Shared);
  scene.Material->EnabledOn();
  const Layers mapped(scene.Stage.Renderer, { "normal" }, Way::Shared);
  RELIEVO_CHECK_THAT(CountDifferent(plain, mapped, "normal") > 1000, "the material is seen");
}
}

RELIEVO_TEST_CASE(testNormalsFirst)
{
  relievoTest::Session session;
  for (const Case& of : Cases)
  {
    TestCase(of);
  }
  TestShown();
  return session.Result();
}
}
