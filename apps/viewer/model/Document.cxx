// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Document.h"

#include "Messages.h"
#include "Options.h"
#include "Presets.h"
#include "SurfaceSettings.h"
#include "TypedZones.h"

#include <algorithm>
#include <exception>

namespace viewer
{
namespace
{
bool IsOfShadows(const std::string& change)
{
  return change == "--shadows" || change.rfind("shadows:", 0) == 0;
}
}

//------------------------------------------------------------------------------
Document::Document(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
scene::Settings Document::FromWords(const std::vector<std::string>& words)
{
  const scene::Settings settings = scene::Settings::FromWords(words);
  if (std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return word == "--times" || word.rfind("--times=", 0) == 0;
      }))
  {
    reading::Messages::Note(
      "--times: the window plays the animation itself, from the first of the times");
  }
  return settings;
}

//------------------------------------------------------------------------------
void Document::Set(const scene::Settings& settings, int number)
{
  if (settings == this->Now)
  {
    return;
  }
  try
  {
    settings.Parse();
  }
  catch (const std::exception& error)
  {
    this->Refuse(this->Now, QString::fromStdString(error.what()));
    return;
  }
  this->Past.Add(this->Now, settings, this->UnderWay != 0 ? this->UnderWay : number);
  this->GoTo(settings);
}

//------------------------------------------------------------------------------
void Document::GoTo(const std::optional<scene::Settings>& settings)
{
  if (settings)
  {
    this->Now = *settings;
    Q_EMIT this->changed();
    Q_EMIT this->pastChanged();
    Q_EMIT this->asked();
  }
}

//------------------------------------------------------------------------------
void Document::Undo()
{
  this->GoTo(this->Past.Undo(this->Now));
}

//------------------------------------------------------------------------------
void Document::Redo()
{
  this->GoTo(this->Past.Redo(this->Now));
}

//------------------------------------------------------------------------------
void Document::ForgetPast()
{
  this->Past.Clear();
  Q_EMIT this->pastChanged();
}

//------------------------------------------------------------------------------
void Document::Change(const std::function<void(scene::Settings&)>& edit, int number)
{
  scene::Settings settings = this->Now;
  edit(settings);
  scene::DropIdleSurface(settings);
  scene::DropIdleFill(settings);
  DropIdleZones(settings);
  this->Set(settings, number);
}

//------------------------------------------------------------------------------
void Document::Amend(const scene::Settings& settings)
{
  this->Now = settings;
  Q_EMIT this->changed();
}

//------------------------------------------------------------------------------
// Words cannot express a disabled default, such as coloured shadows, or hard shadows with a soft
// preset.
void Document::SwitchShadows(bool on)
{
  const std::set<std::string> since = this->Switched.GetChanges(this->Now);
  scene::Settings back = this->Now;
  back.TakeChanges(this->Switched, this->Unswitched);
  const bool same =
    std::none_of(since.begin(), since.end(), IsOfShadows) && back.IsStageOn("shadows") == on;
  this->Unswitched = this->Now;
  this->Change([&](scene::Settings& settings) {
    same ? void(settings = back) : settings.SwitchStage("shadows", on);
  });
  this->Switched = this->Now;
}

//------------------------------------------------------------------------------
void Document::Return(const scene::Settings& good)
{
  this->Now = good;
  this->Past.DropUntil(good);
  Q_EMIT this->changed();
  Q_EMIT this->pastChanged();
}

//------------------------------------------------------------------------------
void Document::Refuse(const scene::Settings& good, const QString& why)
{
  this->Return(good);
  Q_EMIT this->refused(why);
}

//------------------------------------------------------------------------------
void Document::SetFacts(const Facts& facts)
{
  this->Known = facts;
  Q_EMIT this->factsChanged();
}

//------------------------------------------------------------------------------
int Document::GetUpAxis() const
{
  const scene::RenderOptions options = this->Now.Parse();
  return options.FindsUp ? this->Known.UpAxis : options.UpAxis;
}
}
