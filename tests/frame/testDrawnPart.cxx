// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels on which nothing is drawn are left to the background: whatever is drawn outside its box,
// or as far away as can be, is in the picture all the same. So is each point of which something is
// seen, where hidden points are left out. The truth is VTK's own picture.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCompositePolyDataMapper.h>
#include <vtkCubeAxesActor.h>
#include <vtkCubeSource.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>
#include <vtkRelievoFormulas.h>
#include <vtkRelievoHiddenPoints.h>
#include <vtkRelievoLamps.h>
#include <vtkRelievoLampsStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPointGroups.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoSoftwareOpenGL.h>
#include <vtkRelievoToneStage.h>
#include <vtkRelievoVTKVersions.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace testDrawnPart
{
namespace
{
using relievoTest::Picture;

// A cube in the middle of a window, seen from the front; the rest is background.
struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkSmartPointer<vtkRenderWindow> Window;
  bool Moves = false; // between VTK's picture and ours, z of all coincident surfaces alike

  Scene()
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(0.5);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cube->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(0.8, 0.5, 0.2);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Window = relievoTest::MakeWindow(120, 90, this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.3, 0.4, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetClippingRange(1.0, 20.0);
  }

  vtkActor* Add(vtkMapper* mapper)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkActor* Add(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    return this->Add(mapper);
  }
};

vtkSmartPointer<vtkPolyData> MakePoints()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.2, 0.0);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->Allocate(1);
  const vtkIdType both[2] = { 0, 1 };
  data->InsertNextCell(VTK_LINE, 2, both);
  for (const vtkIdType& id : both)
  {
    data->InsertNextCell(VTK_VERTEX, 1, &id);
  }
  return data;
}

void AddWide(Scene& scene)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakePoints());
  vtkActor* actor = scene.Add(mapper);
  actor->GetProperty()->SetLineWidth(9.0F);
  actor->GetProperty()->SetPointSize(25.0F);
}

void AddGlyphs(Scene& scene)
{
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(MakePoints());
  mapper->SetSourceConnection(ball->GetOutputPort());
  scene.Add(mapper);
}

void AddSplats(Scene& scene)
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(MakePoints());
  mapper->SetScaleFactor(0.3);
  mapper->EmissiveOff();
  scene.Add(mapper);
}

// The cube to the left by the shader alone.
void MoveByShader(Scene& scene)
{
  scene.Actor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
    "//VTK::PositionVC::Impl\n  gl_Position.x -= 0.4 * gl_Position.w;\n", false);
}

void AddText(Scene& scene)
{
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput("far from its place");
  text->SetPosition(0.5, 0.5, 0.0);
  scene.Renderer->AddActor(text);
}

void AddAxes(Scene& scene)
{
  vtkNew<vtkCubeAxesActor> axes;
  axes->SetBounds(scene.Actor->GetBounds());
  axes->SetCamera(scene.Renderer->GetActiveCamera());
  scene.Renderer->AddActor(axes);
}

// A plane so near to the far plane that its window z is 1.
void AddFarPlane(Scene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->SetClippingRange(0.01, 15.001);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-3.0, -2.0, -10.0);
  plane->SetPoint1(3.0, -2.0, -10.0);
  plane->SetPoint2(-3.0, 2.0, -10.0);
  scene.Add(plane);
}

void AddGlass(Scene& scene)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.8, 0.0, 0.0);
  scene.Add(ball)->GetProperty()->SetOpacity(0.5);
}

void AddBehindEye(Scene& scene)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-9.0, -0.6, 9.0);
  plane->SetPoint1(9.0, -0.6, 9.0);
  plane->SetPoint2(-9.0, -0.6, -9.0);
  scene.Add(plane);
}

void AddGradient(Scene& scene)
{
  scene.Renderer->GradientBackgroundOn();
  scene.Renderer->SetBackground2(0.9, 0.8, 0.1);
}

#ifdef RELIEVO_VTK_COORDINATE_SYSTEMS
void PlaceOnDevice(Scene& scene)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.7, 0.6, 0.0);
  ball->SetRadius(0.2);
  scene.Add(ball)->SetCoordinateSystemToDevice();
}
#endif

// A cube that floats place beside its box: far from the origin of its own coordinates.
void PlaceByFloats(Scene& scene)
{
  constexpr double away = 67108864.0; // where floats are 8 apart
  constexpr double size = 16.0;
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(away, 0.0, 0.0);
  cube->SetXLength(size);
  cube->SetYLength(size);
  cube->SetZLength(size);
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(scene.Actor->GetMapper());
  mapper->SetInputConnection(cube->GetOutputPort());
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  scene.Actor->SetScale(1.0 / size);
  scene.Actor->SetPosition(-away / size, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetViewAngle(28.0); // of which the sums in floats are far off
}

// Spheres that overlap. Where VTK moves coincident surfaces, it reads their depth before it writes
// it, so the nearest depends on the machine. The truth is the picture without that, as all spheres
// are moved equally.
void AddBalls(Scene& scene)
{
  scene.Moves = true;
  scene.Actor->GetProperty()->SetRepresentationToPoints();
  scene.Actor->GetProperty()->RenderPointsAsSpheresOn();
  scene.Actor->GetProperty()->SetPointSize(20.0F);
}

// Wide lines as tubes: without the offset that VTK adds by their slope.
void AddTubes(Scene& scene)
{
  scene.Moves = true;
  double factor = 0.0;
  double units = 0.0;
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(factor, units);
  scene.Actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-factor, 0.0);
  scene.Actor->GetProperty()->SetRepresentationToWireframe();
  scene.Actor->GetProperty()->RenderLinesAsTubesOn();
  scene.Actor->GetProperty()->SetLineWidth(9.0F);
  scene.Actor->RotateY(30.0);
}

// Surfaces that VTK moves to the far plane, whose z is 1 then.
void MoveToFarPlane(Scene& scene)
{
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  scene.Actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 65000.0);
}

// VTK moves surfaces below their edges, whatever it is told of coincident ones.
void MoveBelowEdges(Scene& scene)
{
  scene.Actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 65000.0);
  scene.Actor->GetProperty()->EdgeVisibilityOn();
}

void WriteFarDepth(Scene& scene)
{
  scene.Actor->GetShaderProperty()->SetFragmentShaderCode(
    "//VTK::System::Dec\n//VTK::Output::Dec\nvoid main()\n{\n"
    "  gl_FragDepth = 1.0;\n  gl_FragData[0] = vec4(0.2, 0.7, 0.4, 1.0);\n}\n");
}

// Its mapper knows the box of the first piece.
void AddInPieces(Scene& scene)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.8, 0.0, 0.0);
  vtkPolyDataMapper::SafeDownCast(scene.Add(ball)->GetMapper())->SetNumberOfSubPieces(3);
}

// A block that moves after frames, of which its mapper keeps the box.
void AddMovedBlock(Scene& scene)
{
  vtkNew<vtkSphereSource> ball;
  ball->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, ball->GetOutput());
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  scene.Add(mapper);
  scene.Renderer->RemoveActor(scene.Actor);
  scene.Window->Render();
  vtkPoints* points = ball->GetOutput()->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* p = points->GetPoint(i);
    points->SetPoint(i, p[0] + 0.9, p[1], p[2]);
  }
  points->Modified();
  ball->GetOutput()->Modified();
}

void Project(Scene& scene)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(3, 0, 5.0);
  scene.Actor->SetUserMatrix(matrix);
}

// Another renderer beside, whose pixels are its own.
void AddBeside(Scene& scene)
{
  vtkNew<vtkRenderer> other;
  other->SetBackground(0.9, 0.1, 0.1);
  other->SetViewport(0.0, 0.0, 0.4, 1.0);
  scene.Window->AddRenderer(other);
  scene.Renderer->SetViewport(0.4, 0.0, 1.0, 1.0);
}

// Upper bound, in levels of 255, of the difference between a picture and its expectation.
double Compare(vtkImageData* plain, vtkImageData* shown, const std::function<double(int)>& follows)
{
  double most = 0.0;
  for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const auto value = [i, c](vtkImageData* picture) {
        return static_cast<int>(picture->GetPointData()->GetScalars()->GetComponent(i, c));
      };
      most = std::max(most, std::abs(value(shown) - follows(value(plain))));
    }
  }
  return most;
}

double AsItIs(int level)
{
  return level;
}

double Toned(int level)
{
  namespace f64 = relievo::f64;
  const double light = f64::relievoLinearFromSrgb(level / 255.0);
  return 255.0 * f64::relievoSrgbFromLinear(f64::relievoToneSimple(glm::dvec3(light)).x);
}

// With tone alone where something is translucent, which VTK blends in bytes, and fog and lamps in
// linear light; or has no layers, which they read.
void TestWith(
  const std::string& what, const std::function<void(Scene&)>& add, bool toneAlone = false)
{
  Scene scene;
  add(scene);
  const auto plain = Picture(scene.Window);
  if (scene.Moves)
  {
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  }
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  vtkRelievoToneStage* tone = frame->GetToneStage();
  const bool beside = scene.Window->GetRenderers()->GetNumberOfItems() > 1;
  if (!beside)
  {
    tone->SetOperatorToSimple();
    tone->EnabledOn();
    // VTK's bytes, through the operator, are half a level off at most, and rounded once more.
    RELIEVO_CHECK_AT_MOST(
      Compare(plain, Picture(scene.Window), Toned), toneAlone ? 2.5 : 1.5, what + ", tone");
    tone->EnabledOff();
  }
  if (toneAlone)
  {
    return;
  }

  vtkNew<vtkPoints> place;
  place->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(place);
  vtkNew<vtkRelievoFogSpheres> fog; // of no density to speak of, over a part
  fog->SetInputData(points);
  fog->SetRadius(0.6);
  fog->SetDensity(1e-5);
  frame->GetFogStage()->AddPoints(fog);
  RELIEVO_CHECK_AT_MOST(Compare(plain, Picture(scene.Window), AsItIs), 1.0, what + ", fog");
  frame->GetFogStage()->RemovePoints(fog);

  vtkNew<vtkRelievoLamps> lamps;
  lamps->SetInputData(points);
  lamps->SetRadius(30.0);
  lamps->SetIntensity(1e-5);
  auto* stage = vtkRelievoLampsStage::SafeDownCast(frame->GetStage("lamps"));
  stage->AddPoints(lamps);
  RELIEVO_CHECK_AT_MOST(Compare(plain, Picture(scene.Window), AsItIs), 1.0, what + ", lamp");
}

// A class with unknown drawing, so that VTK draws all of it.
class WholeActor : public vtkOpenGLActor
{
public:
  static WholeActor* New() { VTK_STANDARD_NEW_BODY(WholeActor); }
  vtkTypeMacro(WholeActor, vtkOpenGLActor);
};

// Many points as spheres, in a shell; `far`: from the origin, in diameters. With doubles, vertices
// are in the reverse order of points.
vtkSmartPointer<vtkPolyData> MakeShell(double far, bool floats)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  vtkNew<vtkPoints> points;
  points->SetDataType(floats ? VTK_FLOAT : VTK_DOUBLE);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> verts;
  const auto next = [&random](double from, double to) {
    random->Next();
    return random->GetRangeValue(from, to);
  };
  for (int i = 0; i < 20000; ++i)
  {
    double place[3] = { next(-1.0, 1.0), next(-1.0, 1.0), next(-1.0, 1.0) };
    const double scale = next(0.45, 0.5) / vtkMath::Norm(place);
    points->InsertNextPoint(place[0] * scale + far, place[1] * scale, place[2] * scale);
    colors->InsertNextTuple3(next(0.0, 255.0), next(0.0, 255.0), next(0.0, 255.0));
    verts->InsertNextCell(1);
    verts->InsertCellPoint(floats ? i : 19999 - i);
  }
  auto shell = vtkSmartPointer<vtkPolyData>::New();
  shell->SetPoints(points);
  shell->GetPointData()->SetScalars(colors);
  shell->SetVerts(verts);
  return shell;
}

struct ShellCase
{
  const char* Name;
  double Size;    // of the points, pixels
  double Far;     // of the shell from its own origin
  double Nearest; // clipping distance
  double Zoom;
  bool Parallel;
  bool Sun;
  bool Forward;        // shadows that draw the camera's view a second time
  bool Turned = false; // after a first picture
  double Stray = 0.0;  // place of a point far from the others
};

// The picture of the actor over a ground, with a shadow, and how many points were seen.
vtkSmartPointer<vtkImageData> DrawShell(const ShellCase& test, vtkActor* actor, vtkIdType& seen)
{
  Scene scene;
  scene.Renderer->RemoveActor(scene.Actor);
  vtkNew<vtkPolyDataMapper> mapper;
  const auto shell = MakeShell(test.Far, test.Sun);
  if (test.Stray > 0.0)
  {
    shell->GetPoints()->SetPoint(7, test.Stray, 0.0, 0.0);
  }
  mapper->SetInputData(shell);
  actor->SetMapper(mapper);
  actor->SetPosition(-test.Far * 1.2, 0.0, 0.0);
  actor->SetScale(1.2, 1.4, 1.3);
  actor->GetProperty()->RenderPointsAsSpheresOn();
  actor->GetProperty()->SetPointSize(static_cast<float>(test.Size));
  scene.Renderer->AddActor(actor);
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-3.0, -1.0, 3.0);
  ground->SetPoint1(3.0, -1.0, 3.0);
  ground->SetPoint2(-3.0, -1.0, -3.0);
  scene.Add(ground);
  scene.Renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetPosition(1.0, 4.0, 2.0);
  light->SetPositional(!test.Sun);
  light->SetConeAngle(40.0);
  scene.Renderer->AddLight(light);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetClippingRange(test.Nearest, 20.0);
  camera->SetParallelProjection(test.Parallel);
  camera->Zoom(test.Zoom);
  scene.Renderer->SetViewport(0.1, 0.2, 1.0, 0.9);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->ShadowsOn();
  frame->GetShadowStage()->SetMapSize(512);
  if (test.Forward)
  {
    frame->GetShadowStage()->SetMethodToForward();
  }
  // Once the buffers are made; the map with casters as before would be kept.
  scene.Window->Render();
  if (test.Turned)
  {
    for (vtkIdType i = 0; i < shell->GetNumberOfPoints(); ++i)
    {
      double place[3];
      shell->GetPoint(i, place);
      shell->GetPoints()->SetPoint(i, -place[2], place[1], place[0]);
    }
    shell->GetPoints()->Modified();
    light->SetPosition(1.0, 4.0, 2.1);
    scene.Window->Render();
  }
  light->SetPosition(1.0, 4.0, 2.5);
  const auto picture = Picture(scene.Window);
  vtkRelievoPointGroups groups;
  const vtkRelievoHiddenPoints hidden(actor, scene.Renderer, groups);
  seen = hidden.GetNumberOfSeen();
  return picture;
}

void TestHiddenPoints()
{
  const ShellCase cases[] = {
    { "a shell", 4.0, 0.0, 1.0, 1.0, false, true, false },
    { "a shell of large points", 13.5, 0.0, 1.0, 1.0, false, false, false },
    { "a shell in parallel projection", 4.9, 0.0, 1.0, 1.0, true, true, false },
    { "a shell that the window cuts", 7.0, 0.0, 1.0, 4.0, false, false, false },
    { "a shell that the near plane cuts", 6.0, 0.0, 4.9, 1.0, false, true, false },
    { "a shell that is all at the far plane", 4.0, 0.0, 0.0005, 1.0, false, false, false },
    { "a shell far from its origin", 3.0, 5.0, 1.0, 1.0, false, false, false },
    { "a shell with shadows forward", 8.0, 0.0, 1.0, 1.0, false, true, true },
    { "a shell whose points have moved", 4.0, 0.0, 1.0, 1.0, false, false, false, true },
    { "a shell and a point far away", 4.0, 0.0, 1.0, 1.0, false, true, false, false, 1000.0 },
    // Floats around the middle of all do not tell the shell's points apart.
    { "a shell and a point very far away", 4.0, 0.0, 1.0, 1.0, false, true, false, false, 3e5 },
  };
  for (const ShellCase& test : cases)
  {
    vtkNew<vtkActor> actor;
    vtkNew<WholeActor> whole;
    vtkIdType some = 0;
    vtkIdType all = 0;
    const auto picture = DrawShell(test, actor, some);
    const auto truth = DrawShell(test, whole, all);
    RELIEVO_CHECK_AT_MOST(Compare(truth, picture, AsItIs), 0.0, test.Name);
    RELIEVO_CHECK_THAT(all == -1, std::string(test.Name) + ": points of an unknown actor left out");
    std::cout << test.Name << ": " << some << " of 20000 points drawn\n";
    RELIEVO_CHECK_THAT(
      !vtkRelievoIsSoftwareOpenGL() || (some > 0 && (some < 19000 || test.Stray > 1e4)),
      std::string(test.Name) + ": hidden points are drawn");
  }
}

// Groups of neighbours are small also if one point is far from the others, and all who ask share
// them, until points change.
void TestPointGroups()
{
  const auto shell = MakeShell(0.0, true);
  shell->GetPoints()->SetPoint(7, 1000.0, 0.0, 0.0);
  vtkRelievoPointGroups first;
  vtkRelievoPointGroups second;
  const vtkRelievoPointGroups::Mesh* made = &first.Get(shell);
  int large = 0;
  for (const vtkRelievoPointGroups::Group& group : made->Groups)
  {
    large += glm::length(group.High - group.Low) > 0.6 ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(large, 0.05 * made->Groups.size(), "groups of points far from each other");

  const vtkIdType bytes = first.GetBytes();
  RELIEVO_CHECK(bytes >= 20000 * 16 && bytes < 20000 * 20);
  shell->GetPointData()->GetScalars()->Modified();
  shell->Modified();
  RELIEVO_CHECK(&second.Get(shell) == made);
  RELIEVO_CHECK(first.GetBytes() + second.GetBytes() == bytes);
  shell->GetPoints()->Modified();
  RELIEVO_CHECK(&second.Get(shell) != made);
  second.KeepOnly({});
  RELIEVO_CHECK(second.IsEmpty() && second.GetBytes() == 0 && first.GetBytes() == bytes);
}

// The groups of a frame and its shadows are held once, and only while points are drawn as spheres.
void TestBytesOfPoints()
{
  Scene scene;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeShell(0.0, true));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetPointSize(4.0f);
  scene.Renderer->AddActor(actor);
  scene.Renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetPosition(1.0, 4.0, 2.0);
  scene.Renderer->AddLight(light);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->ShadowsOn();
  const auto draw = [&](bool spheres, bool visible) {
    actor->GetProperty()->SetRenderPointsAsSpheres(spheres);
    actor->SetVisibility(visible);
    scene.Renderer->GetActiveCamera()->Azimuth(5.0); // draws all anew
    scene.Window->Render();
    scene.Window->Render();
    return frame->GetBytesHeld();
  };
  const vtkIdType without = draw(false, true);
  const vtkIdType more = vtkRelievoIsSoftwareOpenGL() ? 20000 * 16 : 0;
  for (int i = 0; i < 2; ++i)
  {
    const vtkIdType with = draw(true, true) - without;
    RELIEVO_CHECK(with >= more && with <= more * 5 / 4);
    RELIEVO_CHECK(draw(i == 0, i == 1) <= without);
    RELIEVO_CHECK(draw(false, true) == without);
  }
}

// A background between two bytes stays one colour, inside and outside the requested part.
void TestBetweenBytes(int samples)
{
  Scene scene;
  scene.Renderer->SetBackground(0.1, 0.3, 0.7);
  scene.Window->SetMultiSamples(samples);
  vtkNew<vtkPoints> place;
  place->InsertNextPoint(0.0, 0.0, 2.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(place);
  vtkNew<vtkRelievoLamps> lamps;
  lamps->SetInputData(points);
  lamps->SetRadius(30.0);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  auto* stage = vtkRelievoLampsStage::SafeDownCast(frame->GetStage("lamps"));
  stage->AddPoints(lamps);
  const auto picture = Picture(scene.Window);
  vtkDataArray* bytes = picture->GetPointData()->GetScalars();
  int beside = 0;
  for (vtkIdType i = 1; i < picture->GetNumberOfPoints(); ++i)
  {
    const double more = bytes->GetComponent(i, 2) - bytes->GetComponent(0, 2);
    beside += std::abs(more) == 1.0 ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(
    beside, 0, std::to_string(samples) + " samples: pixels a level beside the background's");
}
}

RELIEVO_TEST_CASE(testDrawnPart)
{
  relievoTest::Session session;
  TestBetweenBytes(0);
  TestBetweenBytes(8);
  TestWith("a cube", [](Scene&) {});
  TestWith("nothing", [](Scene& scene) { scene.Renderer->RemoveAllViewProps(); });
  TestWith("wide lines and points", AddWide);
  TestWith("glyphs", AddGlyphs);
  TestWith("splats", AddSplats, true);
  TestWith("a shader that moves", MoveByShader);
  TestWith("text that faces the eye", AddText, true);
  TestWith("axes with labels", AddAxes);
  TestWith("a plane at the far plane", AddFarPlane);
  TestWith("glass", AddGlass, true);
  TestWith("points as spheres, moved z", AddBalls);
  vtkMapper::SetResolveCoincidentTopologyToOff();
  TestWith("lines as tubes, moved z", AddTubes);
  vtkMapper::SetResolveCoincidentTopologyToOff();
  TestWith("moved to the far plane", MoveToFarPlane);
  vtkMapper::SetResolveCoincidentTopologyToOff();
  TestWith("moved below its edges", MoveBelowEdges);
  TestWith("far from its own origin", PlaceByFloats);
  TestWith("a shader of depth", WriteFarDepth, true);
  TestWith("in pieces", AddInPieces);
  TestWith("a block that moves", AddMovedBlock);
  TestWith("a projection", Project, true);
  TestWith("a plane that goes on behind the eye", AddBehindEye);
  TestWith("a gradient", AddGradient);
  TestHiddenPoints();
  TestPointGroups();
  TestBytesOfPoints();
  TestWith("another renderer beside", AddBeside);
#ifdef RELIEVO_VTK_COORDINATE_SYSTEMS
  TestWith("an actor in units of the device", PlaceOnDevice);
#endif
  return session.Result();
}
}
