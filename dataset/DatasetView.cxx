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
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoLensPicture.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace dataset
{
namespace
{
constexpr int OwnSamples = 8;          // samples per pixel, in a window made here
constexpr int RaysWithAllHits = 65536; // rays per batch
constexpr double MostPixelsBeyond = 1 << 25;
// Views drawn together have at most so many pixels; more together take no less time per view.
constexpr int MostTogether = 64;
constexpr int PixelsTogether = 1 << 18;
constexpr int MasksTogether = 100000;   // three of each object in a view
constexpr std::size_t ViewsOfFrame = 4; // drawn with others in the time that a frame takes

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

bool IsPinhole(vtkRelievoCameraModel* camera)
{
  auto* lens = vtkRelievoLensCamera::SafeDownCast(camera);
  return lens && lens->GetLens() == vtkRelievoLensCamera::PINHOLE;
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
constexpr Rectangle Nowhere = { Far, Far, -Far, -Far };

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
  Rectangle all = Nowhere;
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

using Places = std::vector<std::vector<Rectangle>>; // of each object in each view

// Objects that never cover each other in these views.
std::vector<std::vector<int>> Separate(
  const Places& places, const std::vector<std::size_t>& views, const std::vector<int>& objects)
{
  std::vector<std::vector<int>> groups;
  for (const int object : objects)
  {
    const auto isApart = [&](int member) {
      return std::all_of(views.begin(), views.end(), [&](std::size_t view) {
        const Rectangle& own = places[view][static_cast<std::size_t>(object)];
        const Rectangle& other = places[view][static_cast<std::size_t>(member)];
        return own[0] > other[2] || own[2] < other[0] || own[1] > other[3] || own[3] < other[1];
      });
    };
    const auto fits = [&isApart](const std::vector<int>& group) {
      return std::all_of(group.begin(), group.end(), isApart);
    };
    auto group = std::find_if(groups.begin(), groups.end(), fits);
    group = group == groups.end() ? groups.emplace(group) : group;
    group->push_back(object);
  }
  return groups;
}

// The views that draw a group of objects.
using Draws = std::map<std::vector<int>, std::vector<std::size_t>>;

std::size_t GetCost(const Draws& draws)
{
  return std::accumulate(draws.begin(), draws.end(), std::size_t{},
    [](std::size_t sum, const auto& each) { return sum + ViewsOfFrame + each.second.size(); });
}

// Groups for each view alone, or for all views, which then share frames: what takes less time.
Draws Separate(const Places& places, const std::vector<std::vector<int>>& objects)
{
  Draws each;
  std::vector<std::size_t> views;
  std::vector<int> all;
  for (std::size_t view = 0; view < objects.size(); ++view)
  {
    for (const std::vector<int>& group : Separate(places, { view }, objects[view]))
    {
      each[group].push_back(view);
    }
    views.push_back(view);
    all.insert(all.end(), objects[view].begin(), objects[view].end());
  }
  if (objects.size() == 1)
  {
    return each;
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  Draws shared;
  for (const std::vector<int>& group : Separate(places, views, all))
  {
    std::copy_if(
      views.begin(), views.end(), std::back_inserter(shared[group]), [&](std::size_t view) {
        return std::any_of(group.begin(), group.end(), [&](int object) {
          return std::binary_search(objects[view].begin(), objects[view].end(), object);
        });
      });
  }
  return GetCost(shared) < GetCost(each) ? shared : each;
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
// A layer of another kind may depend on more than the surfaces in one view.
std::size_t DatasetPainter::GetNumberTogether(vtkRelievoCameraModel* camera) const
{
  constexpr int elsewhere = vtkRelievoLayer::FROM_PICTURE | vtkRelievoLayer::FROM_STAGE;
  const auto isOfSurfaces = [](const std::string& name) {
    const vtkRelievoLayer& layer = vtkRelievoLayerCatalogue::Find(name);
    return layer.Kind != vtkRelievoLayer::ARRAY && !layer.OfLight &&
      (layer.Source & elsewhere) == 0;
  };
  if (!IsPinhole(camera) || !std::all_of(this->Layers.begin(), this->Layers.end(), isOfSurfaces))
  {
    return 1;
  }
  const double pixels = static_cast<double>(camera->GetSize()[0]) * camera->GetSize()[1];
  const double objects = static_cast<double>(std::max<std::size_t>(1, this->Objects.Get().size()));
  return static_cast<std::size_t>(std::clamp<double>(
    std::min(PixelsTogether / pixels, MasksTogether / objects), 1, MostTogether));
}

//------------------------------------------------------------------------------
std::vector<DatasetView> DatasetPainter::Draw(const std::vector<DatasetShot>& shots)
{
  std::vector<DatasetView> views(shots.size());
  for (std::size_t i = 0; i < shots.size(); ++i)
  {
    views[i].Columns = shots[i].Camera->GetSize()[0];
    views[i].Rows = shots[i].Camera->GetSize()[1];
    views[i].Visible.assign(
      this->Objects.Get().size(), DatasetMask(views[i].Columns, views[i].Rows));
    views[i].Whole = views[i].Visible;
  }
  if (!IsPinhole(shots[0].Camera))
  {
    for (std::size_t i = 0; i < shots.size(); ++i)
    {
      this->SetSun(shots[i].Sun);
      this->FollowRays(shots[i].Camera, shots[i].Before, views[i]);
    }
    return views;
  }
  this->DrawInWindow(shots, views);
  for (std::size_t i = 0; i < shots.size() && !this->Flow.empty(); ++i)
  {
    const auto traced = this->TraceLayers(shots[i].Camera, shots[i].Before, this->Flow);
    for (const std::string& layer : this->Flow)
    {
      views[i].Layers->GetPointData()->AddArray(traced->GetPointData()->GetArray(layer.c_str()));
    }
  }
  return views;
}

//------------------------------------------------------------------------------
// The first sun of the scene turns; without one, a sun becomes the only light.
void DatasetPainter::SetSun(const std::optional<std::array<double, 3>>& direction)
{
  if (!direction)
  {
    return;
  }
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
  this->Sun->SetPosition(direction->data());
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
void DatasetPainter::DrawLayers(
  const std::vector<std::string>& layers, const std::vector<Shown>& cameras, const Take& take)
{
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(this->Renderer);
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer);
  }
  this->Renderer->SetActiveCamera(cameras[0].Camera);
  for (const Shown& camera : cameras)
  {
    source->AddView(camera.Camera);
  }
  std::vector<vtkSmartPointer<vtkImageData>> views(cameras.size());
  std::string lack;
  const bool good = source->CaptureEach([&](std::size_t i, vtkImageData* drawn) {
    if (i == 0)
    {
      const double bytes = 1024.0 * static_cast<double>(drawn->GetActualMemorySize());
      lack = relievo::LackOfMemory(bytes * static_cast<double>(views.size()), 0.0, bytes);
    }
    if (lack.empty())
    {
      views[i] = drawn;
    }
  });
  if (!lack.empty())
  {
    throw WorkError("The layers of " + std::to_string(views.size()) +
      " views are too many: " + lack + ". Ask for fewer layers or smaller views.");
  }
  try
  {
    Messages::Check("layers", !good);
  }
  catch (const WorkError& error)
  {
    if (source->GetErrorCode() == vtkRelievoLayerSource::NO_SUCH_LAYER)
    {
      throw UsageError(error.what());
    }
    throw;
  }
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    take(i, views[i]);
  }
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
// Calls `call` with each view, and each pixel of each of its objects, drawn without the others.
void DatasetPainter::DrawAlone(const std::vector<Shown>& cameras,
  const std::vector<std::vector<int>>& objects,
  const std::function<void(std::size_t, std::size_t, std::size_t)>& call)
{
  std::vector<std::string> layers = { "actor", "block" };
  if (this->Objects.HasVolumes())
  {
    layers.emplace_back("volume");
  }
  Places places(cameras.size());
  for (std::size_t view = 0; view < cameras.size(); ++view)
  {
    places[view].resize(this->Objects.Get().size(), Nowhere);
    for (const int object : objects[view])
    {
      places[view][static_cast<std::size_t>(object)] =
        FindRectangle(cameras[view].Lens, this->Objects, object);
    }
  }
  for (const auto& each : Separate(places, objects))
  {
    const std::vector<int>& group = each.first;
    const std::vector<std::size_t>& views = each.second;
    const auto find = [&](std::size_t view, vtkImageData* drawn) {
      for (const int object : group)
      {
        if (std::binary_search(objects[view].begin(), objects[view].end(), object))
        {
          ForEachObject(this->Objects, drawn, places[view][static_cast<std::size_t>(object)],
            [&](std::size_t pixel, int found) {
              if (found == object)
              {
                call(view, pixel, static_cast<std::size_t>(object));
              }
            });
        }
      }
    };
    const DatasetObjects::Alone alone(this->Objects, group);
    const bool isDrawn = alone.IsWhole() && cameras[0].Layers;
    std::vector<Shown> shown;
    for (const std::size_t view : views)
    {
      shown.push_back(cameras[view]);
      if (isDrawn)
      {
        find(view, cameras[view].Layers);
      }
    }
    if (!isDrawn)
    {
      this->DrawLayers(
        layers, shown, [&](std::size_t i, vtkImageData* drawn) { find(views[i], drawn); });
    }
  }
}

//------------------------------------------------------------------------------
// An object's full mask is drawn without the others, by the same camera: pixels where the object is
// visible among the others also show it alone.
void DatasetPainter::DrawInWindow(
  const std::vector<DatasetShot>& shots, std::vector<DatasetView>& views)
{
  std::vector<Shown> cameras;
  for (std::size_t i = 0; i < shots.size(); ++i)
  {
    auto* lens = vtkRelievoLensCamera::SafeDownCast(shots[i].Camera);
    this->SetSun(shots[i].Sun);
    this->BeginView();
    CheckWindowSize(this->Window, lens->GetSize());
    this->Window->vtkRenderWindow::SetSize(views[i].Columns, views[i].Rows);
    lens->ApplyTo(this->Camera);
    this->Renderer->ResetCameraClippingRange();
    Messages::Check("the camera");
    this->TakePicture(views[i]);
    cameras.push_back({ lens, this->Camera, nullptr });
  }
  const SharedFrame frame(this->Renderer);
  this->DrawLayers(this->Layers, cameras, [&](std::size_t i, vtkImageData* drawn) {
    views[i].Layers = cameras[i].Layers = drawn;
    if (cameras.size() > 1) // which gives no camera
    {
      this->SetSun(shots[i].Sun);
      this->Renderer->SetActiveCamera(cameras[i].Camera);
      this->Renderer->UpdateLightsGeometryToFollowCamera();
      vtkRelievoLayerSource::AddCamera(
        this->Renderer, drawn, vtkRelievoPass::SafeDownCast(this->Renderer->GetPass()));
    }
    FindVisible(this->Objects, views[i]);
  });
  std::vector<int> all(this->Objects.Get().size());
  std::iota(all.begin(), all.end(), 0);
  this->DrawAlone(cameras, std::vector<std::vector<int>>(views.size(), all),
    [&views](std::size_t view, std::size_t pixel, std::size_t object) {
      views[view].Whole[object].Add(pixel);
    });
  if (this->Silhouettes)
  {
    this->LookBeyond(cameras, views);
  }
}

//------------------------------------------------------------------------------
// An object that may reach beyond the picture is drawn once more, on up to three times as many
// columns and rows; the middle part is known. Shaders can displace surfaces out of their boxes, so
// a mask that touches the edge counts as well.
void DatasetPainter::LookBeyond(const std::vector<Shown>& cameras, std::vector<DatasetView>& views)
{
  const int columns = views[0].Columns;
  const int rows = views[0].Rows;
  const std::array<int, 2> margin = GetMargin(GetLimit(this->Window), columns, rows);
  const std::array<int, 2> all = { columns + 2 * margin[0], rows + 2 * margin[1] };
  const std::array<std::size_t, 4> middle = { static_cast<std::size_t>(margin[0]),
    static_cast<std::size_t>(margin[1]), static_cast<std::size_t>(margin[0] + columns),
    static_cast<std::size_t>(margin[1] + rows) };
  std::vector<Shown> wide;
  std::vector<vtkSmartPointer<vtkRelievoLensCamera>> lenses;
  std::vector<std::size_t> numbers; // of the views
  std::vector<std::vector<int>> wider;
  std::vector<std::vector<DatasetMask>> beyond;
  for (std::size_t number = 0; number < views.size(); ++number)
  {
    DatasetView& view = views[number];
    vtkRelievoLensCamera* camera = cameras[number].Lens;
    std::vector<int> objects;
    for (std::size_t i = 0; i < view.Whole.size(); ++i)
    {
      const std::array<int, 4> box = view.Whole[i].GetBox();
      view.Silhouettes.push_back({ view.Whole[i].GetCount(), box });
      const bool isTouching = view.Whole[i].GetCount() > 0 &&
        (box[0] == 0 || box[1] == 0 || box[0] + box[2] == columns || box[1] + box[3] == rows);
      const auto object = static_cast<int>(i);
      if (isTouching || FindReach(camera, this->Objects, object) == ObjectReach::Beyond)
      {
        objects.push_back(object);
      }
    }
    if (objects.empty())
    {
      continue;
    }
    lenses.push_back(vtkSmartPointer<vtkRelievoLensCamera>::New());
    vtkRelievoLensCamera* lens = lenses.back();
    lens->Copy(camera);
    const double* axis = camera->GetPrincipalPoint();
    lens->SetSize(all[0], all[1]);
    lens->SetIntrinsics(camera->GetFocalX(), camera->GetFocalY(), camera->GetSkew(),
      axis[0] + margin[0], axis[1] + margin[1]);
    lens->ApplyTo(cameras[number].Camera);
    wide.push_back({ lens, cameras[number].Camera, nullptr });
    numbers.push_back(number);
    wider.push_back(objects);
    beyond.emplace_back(view.Whole.size(), DatasetMask(all[0], all[1]));
  }
  if (wide.empty())
  {
    return;
  }
  this->Window->vtkRenderWindow::SetSize(all[0], all[1]);
  this->DrawAlone(wide, wider, [&](std::size_t view, std::size_t pixel, std::size_t object) {
    const std::size_t column = pixel % static_cast<std::size_t>(all[0]);
    const std::size_t row = pixel / static_cast<std::size_t>(all[0]);
    const bool isMiddle =
      column >= middle[0] && row >= middle[1] && column < middle[2] && row < middle[3];
    if (!isMiddle)
    {
      beyond[view][object].Add(pixel);
    }
  });
  for (std::size_t i = 0; i < wide.size(); ++i)
  {
    DatasetView& view = views[numbers[i]];
    for (const int object : wider[i])
    {
      const auto number = static_cast<std::size_t>(object);
      view.Silhouettes[number] = JoinSilhouette(view.Whole[number], beyond[i][number], margin);
    }
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
