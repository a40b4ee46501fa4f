// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetView.h"

#include "Display.h"
#include "Errors.h"
#include "Messages.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoLensPicture.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace dataset
{
namespace
{
constexpr int OwnSamples = 8;          // samples per pixel, in a window made here
constexpr int RaysWithAllHits = 65536; // rays per batch
constexpr double MostPixelsBeyond = 1 << 25;

int GetLimit(vtkRenderWindow* window)
{
  auto* gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  return gl ? GetSizeLimit(gl) : 0;
}

void CheckWindowSize(vtkRenderWindow* window, const int size[2])
{
  const int limit = GetLimit(window);
  if (std::max(size[0], size[1]) > limit)
  {
    throw UsageError("a view has " + std::to_string(size[0]) + "x" + std::to_string(size[1]) +
      " pixels; OpenGL here draws at most " + std::to_string(limit) + " each way");
  }
}

// Margin columns and rows at each side of a picture: its own size, limited by the size per
// direction and by the total number of pixels.
std::array<int, 2> GetMargin(double limit, int columns, int rows)
{
  const double pixels = static_cast<double>(columns) * rows;
  const double widest =
    std::min({ 3.0, limit / columns, limit / rows, std::sqrt(MostPixelsBeyond / pixels) });
  const double share = std::max(0.0, (widest - 1.0) / 2.0);
  return { static_cast<int>(share * columns), static_cast<int>(share * rows) };
}

// Left, top, right and bottom of a part of a picture, in columns and rows.
using Rectangle = std::array<double, 4>;
constexpr double Far = std::numeric_limits<double>::infinity();
constexpr Rectangle Everywhere = { -Far, -Far, Far, Far };

// Calls `call` with the number from the top and the image point of each pixel in a rectangle.
template <typename Call>
void ForEachPixel(vtkImageData* image, const Rectangle& part, const Call& call)
{
  const int* size = image->GetDimensions();
  const auto clamp = [](double value, int end) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(end)));
  };
  const int left = clamp(std::floor(part[0]), size[0]);
  const int right = clamp(std::floor(part[2]) + 1.0, size[0]);
  const int bottom = clamp(std::floor(part[3]) + 1.0, size[1]);
  for (int row = clamp(std::floor(part[1]), size[1]); row < bottom; ++row)
  {
    const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(size[0]);
    const vtkIdType point = static_cast<vtkIdType>(size[1] - 1 - row) * size[0];
    for (int column = left; column < right; ++column)
    {
      call(pixel + static_cast<std::size_t>(column), point + column);
    }
  }
}

template <typename Call>
void ForEachPixel(vtkImageData* image, const Call& call)
{
  ForEachPixel(image, Everywhere, call);
}

// Calls `call` with each pixel's number from the top and its object, in a rectangle.
template <typename Call>
void ForEachObject(
  const DatasetObjects& objects, vtkImageData* layers, const Rectangle& part, const Call& call)
{
  const auto getNumbers = [layers](const char* name) {
    return vtkIntArray::SafeDownCast(layers->GetPointData()->GetArray(name))->GetPointer(0);
  };
  const int* actors = getNumbers("actor");
  const int* blocks = getNumbers("block");
  const int* volumes = objects.HasVolumes() ? getNumbers("volume") : nullptr;
  std::pair<int, int> last(-1, -1); // neighbours mostly show one object
  int object = -1;
  ForEachPixel(layers, part, [&](std::size_t pixel, vtkIdType point) {
    const std::pair<int, int> is(actors[point], blocks[point]);
    if (is != last)
    {
      object = objects.Find(is.first, is.second);
      last = is;
    }
    // Rays through volumes end at the surface.
    const int volume = volumes ? objects.FindVolume(volumes[point]) : -1;
    call(pixel, volume >= 0 ? volume : object);
  });
}

// Whether boxes around an object place it entirely in a picture, partly outside, or entirely behind
// the camera.
enum class ObjectReach
{
  Within,
  Beyond,
  Behind
};

// The corners of an object's boxes in pixels; none for corners behind the camera.
std::vector<std::optional<std::array<double, 2>>> ProjectCorners(
  vtkRelievoLensCamera* camera, const DatasetObjects& objects, int object)
{
  std::vector<std::optional<std::array<double, 2>>> projected;
  for (const std::array<double, 3>& corner : objects.GetCorners(object))
  {
    double point[3];
    for (int i = 0; i < 3; ++i)
    {
      point[i] =
        vtkMath::Dot(camera->GetRotation() + 3 * i, corner.data()) + camera->GetTranslation()[i];
    }
    std::array<double, 2> pixel{};
    const bool isBefore = point[2] > 0.0 && camera->ProjectCameraPoint(point, pixel.data());
    projected.push_back(isBefore ? std::make_optional(pixel) : std::nullopt);
  }
  return projected;
}

ObjectReach FindReach(vtkRelievoLensCamera* camera, const DatasetObjects& objects, int object)
{
  const auto corners = ProjectCorners(camera, objects, object);
  const auto isWithin = [camera](const std::optional<std::array<double, 2>>& pixel) {
    return pixel && (*pixel)[0] > -0.5 && (*pixel)[1] > -0.5 &&
      (*pixel)[0] < camera->GetSize()[0] - 0.5 && (*pixel)[1] < camera->GetSize()[1] - 0.5;
  };
  return std::all_of(corners.begin(), corners.end(), isWithin) ? ObjectReach::Within
    : std::none_of(
        corners.begin(), corners.end(), [](const auto& pixel) { return pixel.has_value(); })
    ? ObjectReach::Behind
    : ObjectReach::Beyond;
}

// A rectangle that contains all pixels of an object.
Rectangle FindRectangle(vtkRelievoLensCamera* camera, const DatasetObjects& objects, int object)
{
  constexpr double rounding = 2.0;
  const std::optional<double> border = objects.GetBorder(object);
  Rectangle all = { Far, Far, -Far, -Far };
  for (const auto& pixel : ProjectCorners(camera, objects, object))
  {
    if (!pixel || !border)
    {
      return Everywhere;
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      all[i] = std::min(all[i], (*pixel)[i] - *border - rounding);
      all[i + 2] = std::max(all[i + 2], (*pixel)[i] + *border + rounding);
    }
  }
  return all;
}

// Objects that never cover each other, and their rectangles.
struct Group
{
  std::vector<int> Objects;
  std::vector<Rectangle> Rectangles;
};

std::vector<Group> Separate(
  vtkRelievoLensCamera* camera, const DatasetObjects& all, const std::vector<int>& objects)
{
  std::vector<Group> groups;
  for (const int object : objects)
  {
    const Rectangle own = FindRectangle(camera, all, object);
    const auto isApart = [&own](const Rectangle& other) {
      return own[0] > other[2] || own[2] < other[0] || own[1] > other[3] || own[3] < other[1];
    };
    const auto fits = [&isApart](const Group& group) {
      return std::all_of(group.Rectangles.begin(), group.Rectangles.end(), isApart);
    };
    auto group = std::find_if(groups.begin(), groups.end(), fits);
    group = group == groups.end() ? groups.emplace(group) : group;
    group->Objects.push_back(object);
    group->Rectangles.push_back(own);
  }
  return groups;
}

// The frame of a renderer, which several captures then share instead of making one each.
class SharedFrame
{
public:
  explicit SharedFrame(vtkRenderer* renderer)
    : Renderer(renderer)
    , IsOwn(!vtkRelievoPass::SafeDownCast(renderer->GetPass()))
  {
    vtkRelievoPass::Attach(renderer);
  }
  ~SharedFrame()
  {
    if (this->IsOwn)
    {
      vtkRelievoPass::Detach(this->Renderer);
    }
  }
  SharedFrame(const SharedFrame&) = delete;
  void operator=(const SharedFrame&) = delete;

private:
  vtkRenderer* Renderer;
  bool IsOwn;
};

// An object's complete silhouette, from its mask in the picture and its mask in a picture that is
// wider by a margin at each side.
DatasetSilhouette JoinSilhouette(
  const DatasetMask& whole, const DatasetMask& beyond, const std::array<int, 2>& margin)
{
  DatasetSilhouette all = { whole.GetCount(), whole.GetBox() };
  if (beyond.GetCount() == 0)
  {
    return all;
  }
  std::array<int, 4> other = beyond.GetBox();
  other[0] -= margin[0];
  other[1] -= margin[1];
  std::array<int, 4> both = other;
  for (std::size_t axis = 0; axis < 2 && all.Count > 0; ++axis)
  {
    both[axis] = std::min(all.Box[axis], other[axis]);
    both[axis + 2] =
      std::max(all.Box[axis] + all.Box[axis + 2], other[axis] + other[axis + 2]) - both[axis];
  }
  return { all.Count + beyond.GetCount(), both };
}

void FindVisible(const DatasetObjects& objects, DatasetView& view)
{
  ForEachObject(objects, view.Layers, Everywhere, [&view](std::size_t pixel, int object) {
    view.Objects.push_back(object);
    if (object >= 0)
    {
      view.Visible[static_cast<std::size_t>(object)].Add(pixel);
    }
  });
}
}

//------------------------------------------------------------------------------
std::vector<double> DatasetView::GetLayer(const std::string& name, int& components) const
{
  vtkDataArray* array = this->Layers->GetPointData()->GetArray(name.c_str());
  components = array->GetNumberOfComponents();
  const auto count = static_cast<std::size_t>(components);
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfValues()));
  ForEachPixel(this->Layers, [&](std::size_t pixel, vtkIdType point) {
    array->GetTuple(point, values.data() + count * pixel);
  });
  return values;
}

//------------------------------------------------------------------------------
DatasetPainter::DatasetPainter(vtkRenderer* renderer, const DatasetObjects& objects,
  const std::vector<std::string>& layers, bool silhouettes)
  : Renderer(renderer)
  , Objects(objects)
  , Silhouettes(silhouettes)
  , HadLights(renderer->GetLights()->GetNumberOfItems() > 0)
{
  for (const std::string& layer : layers)
  {
    (vtkRelievoRayLayers::IsFlow(layer.c_str()) ? this->Flow : this->Layers).push_back(layer);
  }
  for (const char* own : { "depth", "actor", "block", "volume" })
  {
    if ((objects.HasVolumes() || own != std::string("volume")) &&
      std::find(layers.begin(), layers.end(), own) == layers.end())
    {
      this->Layers.emplace_back(own);
    }
  }
}

//------------------------------------------------------------------------------
DatasetPainter::~DatasetPainter()
{
  this->RestoreLights();
  if (!this->HadLights)
  {
    this->Renderer->RemoveAllLights(); // the first frame makes a headlight
  }
  if (!this->Window)
  {
    return;
  }
  this->Guard.reset();
  if (this->IsOwnWindow)
  {
    this->Window->RemoveRenderer(this->Renderer);
  }
}

//------------------------------------------------------------------------------
void DatasetPainter::OpenWindow()
{
  if (this->Window)
  {
    return;
  }
  vtkSmartPointer<vtkRenderWindow> window = this->Renderer->GetRenderWindow();
  this->IsOwnWindow = !window;
  if (this->IsOwnWindow)
  {
    window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(OwnSamples);
    window->SetSize(1, 1);
  }
  CheckDisplay(window);
  if (auto* gl = vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    gl->Initialize(); // keeps the window's size: X ends the process for sizes that it cannot make
  }
  window->MakeCurrent();
  Messages::Check("OpenGL");
  if (this->IsOwnWindow)
  {
    window->AddRenderer(this->Renderer);
  }
  this->Guard = std::make_unique<vtkRelievoWindowGuard>(this->Renderer);
  window->SetUseOffScreenBuffers(true);
  this->Window = window;
}

//------------------------------------------------------------------------------
// Each view gets a new camera: state such as the previous distance changes the last digits of a
// camera's matrices, and files would depend on the set of views in a call.
void DatasetPainter::BeginView()
{
  this->OpenWindow();
  this->Camera = vtkSmartPointer<vtkCamera>::Take(this->Renderer->MakeCamera());
  this->Renderer->SetActiveCamera(this->Camera);
}

//------------------------------------------------------------------------------
DatasetView DatasetPainter::Draw(vtkRelievoCameraModel* camera, vtkRelievoCameraModel* before,
  const std::optional<std::array<double, 3>>& sun)
{
  DatasetView view;
  view.Columns = camera->GetSize()[0];
  view.Rows = camera->GetSize()[1];
  view.Visible.assign(this->Objects.Get().size(), DatasetMask(view.Columns, view.Rows));
  view.Whole = view.Visible;
  if (sun)
  {
    this->SetSun(*sun);
  }
  auto* lens = vtkRelievoLensCamera::SafeDownCast(camera);
  if (lens && lens->GetLens() == vtkRelievoLensCamera::PINHOLE)
  {
    this->DrawInWindow(lens, view);
    if (!this->Flow.empty())
    {
      const auto traced = this->TraceLayers(camera, before, this->Flow);
      for (const std::string& layer : this->Flow)
      {
        view.Layers->GetPointData()->AddArray(traced->GetPointData()->GetArray(layer.c_str()));
      }
    }
  }
  else
  {
    this->FollowRays(camera, before, view);
  }
  return view;
}

//------------------------------------------------------------------------------
// The first sun of the scene turns; without one, a sun becomes the only light.
void DatasetPainter::SetSun(const std::array<double, 3>& direction)
{
  if (!this->Sun)
  {
    vtkLightCollection* lights = this->Renderer->GetLights();
    vtkCollectionSimpleIterator it;
    lights->InitTraversal(it);
    while (vtkLight* light = lights->GetNextLight(it))
    {
      if (!this->Sun && light->GetSwitch() && !light->GetPositional() &&
        light->LightTypeIsSceneLight())
      {
        this->Sun = light;
      }
      this->Lamps.push_back({ light, light->GetSwitch() != 0 });
    }
    this->IsOwnSun = !this->Sun;
    if (this->IsOwnSun)
    {
      for (const Lamp& lamp : this->Lamps)
      {
        lamp.Light->SwitchOff();
      }
      this->Sun = vtkSmartPointer<vtkLight>::New();
      this->Sun->SetLightTypeToSceneLight();
      this->Renderer->AddLight(this->Sun);
    }
    this->Sun->GetPosition(this->SunPosition.data());
    this->Sun->GetFocalPoint(this->SunFocus.data());
    this->SunMatrix = this->Sun->GetTransformMatrix();
    this->Sun->SetTransformMatrix(nullptr);
  }
  this->Sun->SetFocalPoint(0.0, 0.0, 0.0);
  this->Sun->SetPosition(direction.data());
}

//------------------------------------------------------------------------------
void DatasetPainter::RestoreLights()
{
  if (!this->Sun)
  {
    return;
  }
  this->Sun->SetPosition(this->SunPosition.data());
  this->Sun->SetFocalPoint(this->SunFocus.data());
  this->Sun->SetTransformMatrix(this->SunMatrix);
  if (this->IsOwnSun)
  {
    this->Renderer->RemoveLight(this->Sun);
    for (const Lamp& lamp : this->Lamps)
    {
      lamp.Light->SetSwitch(lamp.On);
    }
  }
  this->Sun = nullptr;
  this->Lamps.clear();
  this->IsOwnSun = false;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DatasetPainter::DrawLayers(const std::vector<std::string>& layers)
{
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(this->Renderer);
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer);
  }
  source->Update();
  const unsigned long code = source->GetErrorCode();
  try
  {
    Messages::Check("layers", code != 0);
  }
  catch (const WorkError& error)
  {
    if (code == vtkRelievoLayerSource::NO_SUCH_LAYER)
    {
      throw UsageError(error.what());
    }
    throw;
  }
  return source->GetOutput();
}

//------------------------------------------------------------------------------
// The window's picture, antialiased by the window.
void DatasetPainter::TakePicture(DatasetView& view)
{
  auto* frame = vtkRelievoPass::SafeDownCast(this->Renderer->GetPass());
  const bool waits = frame && frame->GetWaitForSamples();
  if (frame)
  {
    frame->WaitForSamplesOn();
  }
  this->Window->Render();
  if (frame)
  {
    frame->SetWaitForSamples(waits);
  }
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  Messages::Check("the picture");
  vtkImageData* image = grab->GetOutput();
  constexpr std::size_t colors = 3;
  const std::size_t length = colors * static_cast<std::size_t>(view.Columns);
  for (int row = view.Rows - 1; row >= 0; --row)
  {
    const auto* first = static_cast<const unsigned char*>(image->GetScalarPointer(0, row, 0));
    view.Picture.insert(view.Picture.end(), first, first + length);
  }
}

//------------------------------------------------------------------------------
// Calls `call` with each pixel of each object, drawn without the other objects.
void DatasetPainter::DrawAlone(vtkRelievoLensCamera* camera, const std::vector<int>& objects,
  const std::function<void(std::size_t, std::size_t)>& call)
{
  std::vector<std::string> layers = { "actor", "block" };
  if (this->Objects.HasVolumes())
  {
    layers.emplace_back("volume");
  }
  for (const Group& group : Separate(camera, this->Objects, objects))
  {
    const DatasetObjects::Alone alone(this->Objects, group.Objects);
    const vtkSmartPointer<vtkImageData> drawn = this->DrawLayers(layers);
    for (std::size_t i = 0; i < group.Objects.size(); ++i)
    {
      const int object = group.Objects[i];
      ForEachObject(this->Objects, drawn, group.Rectangles[i], [&](std::size_t pixel, int found) {
        if (found == object)
        {
          call(pixel, static_cast<std::size_t>(object));
        }
      });
    }
  }
}

//------------------------------------------------------------------------------
// An object's full mask is drawn without the others, by the same camera: pixels where the object is
// visible among the others also show it alone.
void DatasetPainter::DrawInWindow(vtkRelievoLensCamera* camera, DatasetView& view)
{
  this->BeginView();
  CheckWindowSize(this->Window, camera->GetSize());
  this->Window->vtkRenderWindow::SetSize(view.Columns, view.Rows);
  camera->ApplyTo(this->Camera);
  this->Renderer->ResetCameraClippingRange();
  Messages::Check("the camera");
  this->TakePicture(view);
  const SharedFrame frame(this->Renderer);
  view.Layers = this->DrawLayers(this->Layers);
  FindVisible(this->Objects, view);
  std::vector<int> all(view.Whole.size());
  std::iota(all.begin(), all.end(), 0);
  this->DrawAlone(
    camera, all, [&view](std::size_t pixel, std::size_t object) { view.Whole[object].Add(pixel); });
  if (this->Silhouettes)
  {
    this->LookBeyond(camera, view);
  }
}

//------------------------------------------------------------------------------
// An object that may reach beyond the picture is drawn once more, on up to three times as many
// columns and rows; the middle part is known. Shaders can displace surfaces out of their boxes, so
// a mask that touches the edge counts as well.
void DatasetPainter::LookBeyond(vtkRelievoLensCamera* camera, DatasetView& view)
{
  const std::array<int, 2> margin = GetMargin(GetLimit(this->Window), view.Columns, view.Rows);
  const std::array<int, 2> all = { view.Columns + 2 * margin[0], view.Rows + 2 * margin[1] };
  const std::array<std::size_t, 4> middle = { static_cast<std::size_t>(margin[0]),
    static_cast<std::size_t>(margin[1]), static_cast<std::size_t>(margin[0] + view.Columns),
    static_cast<std::size_t>(margin[1] + view.Rows) };
  std::vector<int> wider;
  for (std::size_t i = 0; i < view.Whole.size(); ++i)
  {
    const std::array<int, 4> box = view.Whole[i].GetBox();
    view.Silhouettes.push_back({ view.Whole[i].GetCount(), box });
    const bool isTouching = view.Whole[i].GetCount() > 0 &&
      (box[0] == 0 || box[1] == 0 || box[0] + box[2] == view.Columns ||
        box[1] + box[3] == view.Rows);
    const auto object = static_cast<int>(i);
    if (isTouching || FindReach(camera, this->Objects, object) == ObjectReach::Beyond)
    {
      wider.push_back(object);
    }
  }
  if (wider.empty())
  {
    return;
  }
  vtkNew<vtkRelievoLensCamera> wide;
  wide->Copy(camera);
  const double* axis = camera->GetPrincipalPoint();
  wide->SetSize(all[0], all[1]);
  wide->SetIntrinsics(camera->GetFocalX(), camera->GetFocalY(), camera->GetSkew(),
    axis[0] + margin[0], axis[1] + margin[1]);
  this->Window->vtkRenderWindow::SetSize(all[0], all[1]);
  wide->ApplyTo(this->Camera);
  std::vector<DatasetMask> beyond(view.Whole.size(), DatasetMask(all[0], all[1]));
  this->DrawAlone(wide, wider, [&](std::size_t pixel, std::size_t object) {
    const std::size_t column = pixel % static_cast<std::size_t>(all[0]);
    const std::size_t row = pixel / static_cast<std::size_t>(all[0]);
    const bool isMiddle =
      column >= middle[0] && row >= middle[1] && column < middle[2] && row < middle[3];
    if (!isMiddle)
    {
      beyond[object].Add(pixel);
    }
  });
  for (const int object : wider)
  {
    const auto i = static_cast<std::size_t>(object);
    view.Silhouettes[i] = JoinSilhouette(view.Whole[i], beyond[i], margin);
  }
}

//------------------------------------------------------------------------------
// The sensor's picture, warped from pinhole views.
void DatasetPainter::TakePicture(vtkRelievoCameraModel* camera, DatasetView& view)
{
  this->BeginView();
  CheckWindowSize(this->Window, camera->GetSize());
  vtkNew<vtkRelievoLensPicture> source;
  source->SetRenderer(this->Renderer);
  source->SetCamera(camera);
  source->PictureOn();
  source->Update();
  vtkImageData* image = source->GetOutput();
  const bool isUsage = source->GetErrorCode() == vtkErrorCode::UserError;
  try
  {
    Messages::Check("the picture", image->GetNumberOfPoints() == 0);
  }
  catch (const WorkError& error)
  {
    if (isUsage)
    {
      throw UsageError(error.what());
    }
    throw;
  }
  vtkDataArray* shown = image->GetPointData()->GetScalars();
  view.Picture.resize(static_cast<std::size_t>(shown->GetNumberOfValues()));
  ForEachPixel(image, [&](std::size_t pixel, vtkIdType point) {
    for (int i = 0; i < 3; ++i)
    {
      view.Picture[3 * pixel + static_cast<std::size_t>(i)] =
        static_cast<unsigned char>(shown->GetComponent(point, i));
    }
  });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DatasetPainter::TraceLayers(vtkRelievoCameraModel* camera,
  vtkRelievoCameraModel* before, const std::vector<std::string>& layers)
{
  if (!this->Rays)
  {
    this->Rays = vtkSmartPointer<vtkRelievoRayScene>::New();
    this->Rays->SetRenderer(this->Renderer);
    this->Rays->OpaqueOnlyOn(); // like the frame's layers
    this->Nothing = vtkSmartPointer<vtkRelievoRayScene>::New();
  }
  vtkNew<vtkRelievoRayLayers> source;
  source->SetScene(this->Rays);
  source->SetCamera(camera);
  source->SetOther(before ? this->Rays : this->Nothing, before ? before : camera);
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer.c_str());
  }
  source->Update();
  try
  {
    Messages::Check("layers");
  }
  catch (const WorkError& error)
  {
    throw UsageError(error.what());
  }
  return source->GetOutput();
}

//------------------------------------------------------------------------------
void DatasetPainter::FollowRays(
  vtkRelievoCameraModel* camera, vtkRelievoCameraModel* before, DatasetView& view)
{
  if (camera->HasPicture())
  {
    this->TakePicture(camera, view);
  }
  std::vector<std::string> layers = this->Layers;
  layers.insert(layers.end(), this->Flow.begin(), this->Flow.end());
  view.Layers = this->TraceLayers(camera, before, layers);
  FindVisible(this->Objects, view);
  this->FindWhole(camera, view);
}

//------------------------------------------------------------------------------
// A full mask covers every pixel whose ray hits the object, also behind others: one of the ray's
// hits is the object's. A lens bends straight lines, so an object whose corners are in the picture
// may still leave it: for silhouettes, rays beyond the picture are traced for every object.
void DatasetPainter::FindWhole(vtkRelievoCameraModel* camera, DatasetView& view)
{
  const std::array<int, 2> margin = this->Silhouettes
    ? GetMargin(std::numeric_limits<double>::infinity(), view.Columns, view.Rows)
    : std::array<int, 2>{};
  const int columns = view.Columns + 2 * margin[0];
  const int rows = view.Rows + 2 * margin[1];
  std::vector<DatasetMask> beyond(view.Whole.size(), DatasetMask(columns, rows));
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkDoubleArray> origins;
  vtkNew<vtkDoubleArray> directions;
  vtkNew<vtkTable> hits;
  places->SetNumberOfComponents(2);
  const int step = std::max(1, RaysWithAllHits / columns);
  for (int first = 0; first < rows; first += step)
  {
    places->SetNumberOfTuples(0);
    for (int row = first; row < std::min(rows, first + step); ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        places->InsertNextTuple2(column - margin[0], row - margin[1]);
      }
    }
    camera->GetRays(places, origins, directions);
    this->Rays->FindAll(origins, directions, hits);
    Messages::Check("rays");
    const auto getColumn = [&hits](const char* name) {
      return vtkDataArray::SafeDownCast(hits->GetColumnByName(name));
    };
    vtkDataArray* rays = getColumn("ray");
    vtkDataArray* props = getColumn("prop");
    vtkDataArray* blocks = getColumn("block");
    for (vtkIdType i = 0; i < hits->GetNumberOfRows(); ++i)
    {
      const int object = this->Objects.Find(
        static_cast<int>(props->GetComponent(i, 0)), static_cast<int>(blocks->GetComponent(i, 0)));
      if (object < 0)
      {
        continue;
      }
      const auto ray = static_cast<int>(rays->GetComponent(i, 0));
      const int column = ray % columns - margin[0];
      const int row = first + ray / columns - margin[1];
      const auto number = static_cast<std::size_t>(object);
      if (column >= 0 && row >= 0 && column < view.Columns && row < view.Rows)
      {
        view.Whole[number].Add(
          static_cast<std::size_t>(row) * static_cast<std::size_t>(view.Columns) +
          static_cast<std::size_t>(column));
      }
      else
      {
        beyond[number].Add(static_cast<std::size_t>(first) * static_cast<std::size_t>(columns) +
          static_cast<std::size_t>(ray));
      }
    }
  }
  for (std::size_t i = 0; i < view.Whole.size() && this->Silhouettes; ++i)
  {
    view.Silhouettes.push_back(JoinSilhouette(view.Whole[i], beyond[i], margin));
  }
}
}
