// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonActors.h"

#include "BareScene.h"
#include "Images.h"
#include "Numbers.h"
#include "Options.h"
#include "PythonProperty.h"
#include "PythonSurface.h"
#include "PythonWords.h"
#include "Readers.h"
#include "Scene.h"
#include "Settings.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoModelReader.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkStringArray.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

namespace viewer
{
namespace
{
#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
constexpr const char* CompositeMapper = "vtkCompositePolyDataMapper2";
#else
constexpr const char* CompositeMapper = "vtkCompositePolyDataMapper";
#endif

std::string NameReader(std::size_t model)
{
  return "model" + std::to_string(model);
}

//------------------------------------------------------------------------------
class ActorWriter
{
public:
  ActorWriter(std::ostream& out, const BareScene& bare, const cli::RenderOptions& options)
    : Out(out)
    , Bare(bare)
    , Scene(bare.Get())
    , Options(options)
  {
    vtkActorCollection* actors = this->Scene.Renderer->GetActors();
    for (int i = 0; i < actors->GetNumberOfItems(); ++i)
    {
      this->Actors.push_back(vtkActor::SafeDownCast(actors->GetItemAsObject(i)));
    }
  }

  void WriteFiles()
  {
    for (std::size_t i = 0; i < this->Options.Files.size(); ++i)
    {
      const std::string& path = this->Options.Files[i];
      const auto count = static_cast<std::size_t>(this->Scene.Counts[i]);
      if (cli::IsModel(path) || (cli::IsGLTF(path) && this->Options.Model.Given))
      {
        this->WriteModel(this->Scene.Models[this->Model]);
      }
      else if (cli::IsGLTF(path))
      {
        this->WriteGLTF(path, count);
      }
      else
      {
        this->WriteData(path, count);
      }
      this->Next += count;
    }
    this->WriteSkeletons();
  }

private:
  std::string Smooth(const std::string& data) const
  {
    return this->Options.ShadingKind == cli::Shading::Flat ? data : "smooth(" + data + ")";
  }

  std::string Map(const std::string& mesh) const
  {
    return IsMapped(this->Options) ? WriteMapped(mesh, this->Options) : mesh;
  }

  //----------------------------------------------------------------------------
  void WriteActor(vtkActor* actor, const std::string& mesh)
  {
    vtkMapper* mapper = actor->GetMapper();
    const bool single = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
    this->Out << "mapper = " << (single ? "vtkPolyDataMapper" : CompositeMapper)
              << "()\nmapper.SetInputDataObject(" << this->Map(mesh) << ")\n";
    WriteColors(this->Out, mapper, true, false);
    this->Out << "actor = vtkActor()\nactor.SetMapper(mapper)\nproperty = actor.GetProperty()\n";
    WriteProperty(this->Out, actor->GetProperty(), vtkNew<vtkProperty>());
    this->WriteTexture(actor);
    this->Out << "renderer.AddActor(actor)\n";
  }

  //----------------------------------------------------------------------------
  // Actors share textures.
  void WriteTexture(vtkActor* actor)
  {
    vtkTexture* texture = actor->GetTexture();
    if (!texture)
    {
      return;
    }
    std::string& name = this->Textures[texture];
    if (name.empty())
    {
      name = "texture" + std::to_string(this->Textures.size() - 1);
      this->Out << name << " = vtkTexture()\n"
                << name << ".SetInputData("
                << WriteImage(this->Scene, actor, texture->GetInput(), "base_color_texture")
                << ")\n"
                << name << ".InterpolateOn()\n"
                << name << ".MipmapOn()\n"
                << (texture->GetUseSRGBColorSpace() ? name + ".UseSRGBColorSpaceOn()\n" : "");
      if (vtkTransform* transform = texture->GetTransform())
      {
        const double* const matrix = transform->GetMatrix()->GetData();
        this->Out << "transform = vtkTransform()\ntransform.SetMatrix(["
                  << WriteNumbers(std::vector<double>(matrix, matrix + 16)) << "])\n"
                  << name << ".SetTransform(transform)\n";
      }
    }
    this->Out << "actor.SetTexture(" << name << ")\n";
    if (actor->GetProperty()->GetTexture("albedoTex") == texture)
    {
      this->Out << "property.SetBaseColorTexture(" << name << ")\n";
    }
  }

  //----------------------------------------------------------------------------
  void WriteData(const std::string& path, std::size_t count)
  {
    const bool incomplete = this->Scene.Incomplete.count(path) != 0;
    const std::string file = std::string("data(") + GetReader(path) + "(), " + Quote(path) + ")";
    const auto draw = [&](const std::string& data) {
      const std::string mesh = "surface(" + data + ")";
      return this->Smooth(incomplete ? "finite(" + mesh + ")" : mesh);
    };
    const auto& materials = this->Scene.ObjMaterials;
    this->Out << "\n";
    if (materials.count(this->Actors[this->Next]) == 0)
    {
      this->WriteActor(this->Actors[this->Next], draw(file));
      return;
    }
    this->Out << "file = " << file << "\nmesh = " << draw("file") << "\ncells = by_material("
              << Quote(path) << ", file, mesh)\n";
    for (std::size_t i = this->Next; i < this->Next + count; ++i)
    {
      vtkActor* actor = this->Actors[i];
      const std::optional<std::string>& material = materials.at(actor);
      auto* data = vtkDataSet::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
      vtkDataArray* coordinates = data->GetPointData()->GetTCoords();
      const char* name = coordinates ? coordinates->GetName() : nullptr;
      this->WriteActor(actor,
        "part(mesh, cells[" + (material ? QuoteBytes(*material) : "None") + "], " +
          QuoteBytes(name ? name : "") + ")");
    }
  }

  //----------------------------------------------------------------------------
  // What the file's own actors have is not said again.
  void WriteGLTF(const std::string& path, std::size_t count)
  {
    this->Out << "\nscene = vtkGLTFImporter()\nscene.SetFileName(" << Quote(path)
              << ")\nscene.SetRenderWindow(window)\nscene.Update()\n"
              << "actors = list(renderer.GetActors())\n";
    for (std::size_t i = this->Next; i < this->Next + count; ++i)
    {
      vtkActor* actor = this->Actors[i];
      const BareScene::Part* part = this->Bare.Find(actor);
      if (!part)
      {
        continue;
      }
      std::ostringstream lines;
      lines.imbue(std::locale::classic());
      if (IsMapped(this->Options))
      {
        lines << "turn(actor)\nmapper.Update()\nmapper.SetInputDataObject("
              << this->Map("mapper.GetInputDataObject(0, 0)") << ")\n";
      }
      if (!actor->GetMapper()->GetScalarVisibility() || !part->Colored ||
        actor->GetMapper()->GetUseLookupTableScalarRange())
      {
        WriteColors(lines, actor->GetMapper(), part->Colored, part->Interpolated);
      }
      WriteProperty(lines, actor->GetProperty(), part->Property);
      if (part->Texture && !actor->GetTexture())
      {
        lines << "actor.SetTexture(None)\n";
      }
      if (!lines.str().empty())
      {
        this->Out << "actor = actors[" << i << "]\nmapper = actor.GetMapper()\n"
                  << "property = actor.GetProperty()\n"
                  << lines.str();
      }
    }
  }

  //----------------------------------------------------------------------------
  void WriteModel(const cli::PosedModel& model)
  {
    const std::string name = NameReader(this->Model);
    const vtkNew<vtkRelievoModelReader> fresh;
    vtkRelievoModelReader* reader = model.Reader;
    this->Out << "\n"
              << name << " = relievo.vtkRelievoModelReader()\n"
              << name << ".SetFileName(" << Quote(model.Path) << ")\n";
    const auto write = [&](const char* what, const std::string& value, bool differs) {
      this->Out << (differs ? name + ".Set" + what + "(" + value + ")\n" : "");
    };
    const auto writeText = [&](const char* what, const char* text) {
      write(what, Quote(text ? text : ""), text && *text);
    };
    const auto writeSwitch = [&](const char* what, bool on) { write(what, "True", on); };
    writeText("Animation", reader->GetAnimation());
    if (const char* blended = reader->GetBlendAnimation(); blended && *blended)
    {
      const double weight = reader->GetBlendWeight();
      write("BlendAnimation", Quote(blended), true);
      write("BlendWeight", WriteNumber(weight), weight != fresh->GetBlendWeight());
    }
    writeText("WeightsOf", reader->GetWeightsOf());
    writeSwitch("Loop", reader->GetLoop());
    writeSwitch("SkeletonAxes", reader->GetSkeletonAxes());
    writeSwitch("FirstBone", reader->GetFirstBone());
    write("Pose", std::to_string(reader->GetPose()), reader->GetPose() != fresh->GetPose());
    write("Method", std::to_string(reader->GetMethod()), reader->GetMethod() != fresh->GetMethod());
    const std::optional<double> time = this->Options.Model.Time;
    this->Out << name << (time ? ".UpdateTimeStep(" + WriteNumber(*time) : ".Update(") << ")\n";
    for (std::size_t i = 0; i < model.Parts.size(); ++i)
    {
      this->WriteActor(this->Actors[this->Next + i],
        this->Smooth("surface(" + name + ".GetOutput().GetBlock(" +
          std::to_string(model.Parts[i].Block) + "))"));
    }
    ++this->Model;
  }

  //----------------------------------------------------------------------------
  void WriteSkeletons()
  {
    for (std::size_t i = 0; i < this->Scene.Models.size(); ++i)
    {
      if (vtkActor* actor = this->Scene.Models[i].Skeleton)
      {
        this->Out << "\nmapper = vtkPolyDataMapper()\nmapper.SetInputDataObject(" << NameReader(i)
                  << ".GetOutputDataObject(1))\nmapper.SetScalarModeToUseCellData()\n"
                  << "bones = vtkActor()\nbones.SetMapper(mapper)\n"
                  << "bones.GetProperty().LightingOff()\nbones.GetProperty().SetLineWidth("
                  << actor->GetProperty()->GetLineWidth() << ")\nrenderer.AddActor(bones)\n";
      }
    }
  }

  std::ostream& Out;
  const BareScene& Bare;
  const cli::Scene& Scene;
  const cli::RenderOptions& Options;
  std::vector<vtkActor*> Actors;
  std::map<vtkTexture*, std::string> Textures;
  std::size_t Next = 0;  // the first actor of the next file
  std::size_t Model = 0; // the next one with bones
};
}

//------------------------------------------------------------------------------
void WriteActors(std::ostream& out, const BareScene& bare, const cli::RenderOptions& options)
{
  ActorWriter(out, bare, options).WriteFiles();
}

//------------------------------------------------------------------------------
std::string WriteImage(
  const cli::Scene& scene, vtkActor* actor, vtkImageData* image, const char* array)
{
  const std::string file = cli::GetImageFile(image);
  if (!file.empty())
  {
    return "image(" + Quote(file) + ")";
  }
  for (std::size_t i = 0; i < scene.Models.size(); ++i)
  {
    for (const cli::PosedModel::Part& part : scene.Models[i].Parts)
    {
      auto* block =
        vtkDataSet::SafeDownCast(scene.Models[i].Reader->GetOutput()->GetBlock(part.Block));
      auto* names = part.Actor == actor && block
        ? vtkStringArray::SafeDownCast(block->GetFieldData()->GetAbstractArray(array))
        : nullptr;
      if (names && names->GetNumberOfValues() > 0)
      {
        return NameReader(i) + ".GetEmbeddedTexture(" + Quote(names->GetValue(0)) + ")";
      }
    }
  }
  RefusePython("an image that is of no file");
}
}
