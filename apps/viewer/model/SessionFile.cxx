// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionFile.h"

#include "Errors.h"
#include "LightOptions.h"
#include "Options.h"
#include "Outputs.h"
#include "Readers.h"
#include "TypedZones.h"
#include "vtkRelievoFileKind.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <exception>

namespace viewer
{
namespace
{
const char* const Mark = "relievo-viewer";
constexpr int Version = 1;

constexpr std::pair<const char*, std::array<double, 3> look::CameraPlace::*> Triples[] = {
  { "position", &look::CameraPlace::Position }, { "focal_point", &look::CameraPlace::FocalPoint },
  { "view_up", &look::CameraPlace::ViewUp }
};

[[noreturn]] void Fail(const QString& path, const QString& why)
{
  throw words::WorkError((path + ": " + why.simplified()).toStdString()); // one line
}

// Older sessions stored a first sun by date and place beside the words.
void PlaceSun(scene::Settings& view, const QJsonObject& sun)
{
  std::vector<std::string> lights = view.GetAll("--light");
  const auto first = std::find_if(lights.begin(), lights.end(),
    [](const std::string& light) { return light.rfind("sun:", 0) == 0; });
  if (first == lights.end() || !sun["by_time"].toBool())
  {
    return;
  }
  const QJsonArray date = sun["date"].toArray();
  const look::SunTime fresh;
  look::LightWords words = look::SplitLight(*first);
  words.Numbers = look::WriteSunTime(
    { date[0].toInt(fresh.Year), date[1].toInt(fresh.Month), date[2].toInt(fresh.Day),
      sun["hour"].toDouble(fresh.Hour), sun["time_zone"].toDouble(fresh.TimeZone),
      sun["latitude"].toDouble(fresh.Latitude), sun["longitude"].toDouble(fresh.Longitude) });
  *first = look::WriteLight(words);
  view.SetAll("--light", lights);
  view.Parse();
}

//------------------------------------------------------------------------------
// Keys as in a file of --camera-path.
QJsonArray WriteKeys(const std::vector<scene::CameraKey>& keys)
{
  QJsonArray all;
  for (const scene::CameraKey& key : keys)
  {
    QJsonObject one{ { "time", key.Time } };
    for (const auto& [name, member] : Triples)
    {
      const std::array<double, 3>& v = key.Place.*member;
      one[name] = QJsonArray{ v[0], v[1], v[2] };
    }
    all.append(one);
  }
  return all;
}

double ReadNumber(const QJsonValue& value)
{
  if (!value.isDouble())
  {
    throw words::WorkError("a view of the camera's path: expected numbers");
  }
  return value.toDouble();
}

std::vector<scene::CameraKey> ReadKeys(const QJsonValue& given)
{
  if (!given.isUndefined() && !given.isArray())
  {
    throw words::WorkError("the camera's path: expected a list of views");
  }
  const QJsonArray all = given.toArray();
  std::vector<scene::CameraKey> keys;
  for (const auto& each : all)
  {
    const QJsonObject one = each.toObject();
    scene::CameraKey key{ ReadNumber(one["time"]), {} };
    for (const auto& [name, member] : Triples)
    {
      const QJsonArray v = one[name].toArray();
      key.Place.*member = { ReadNumber(v[0]), ReadNumber(v[1]), ReadNumber(v[2]) };
    }
    if (const std::string expected = look::CheckPlace(key.Place); !expected.empty())
    {
      throw words::WorkError("a view of the camera's path: expected " + expected);
    }
    keys.push_back(key);
  }
  return keys;
}
}

//------------------------------------------------------------------------------
void SaveSession(const QString& path, const Session& session)
{
  QJsonArray words;
  scene::Settings moving = session.View;
  moving.MakePathsRelative(QFileInfo(path).absolutePath().toStdString());
  for (const std::string& word : moving.GetWords())
  {
    words.append(QString::fromStdString(word));
  }
  QJsonObject root{ { Mark, Version }, { "words", words } };
  if (!session.Keys.empty())
  {
    root["keys"] = WriteKeys(session.Keys);
  }
  QJsonArray zones;
  for (const std::string& light : moving.GetAll(TypedZones))
  {
    zones.append(QString::fromStdString(light));
  }
  if (!zones.isEmpty())
  {
    root["typed_zones"] = zones;
  }
  const std::string place = path.toStdString();
  reading::Outputs outputs;
  outputs.Add("Save", place, {});
  QFile file(QString::fromStdString(outputs.Temporary(place)));
  const QByteArray text = QJsonDocument(root).toJson();
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.flush())
  {
    Fail(path, "cannot be written: " + file.errorString());
  }
  file.close();
  outputs.Commit();
}

//------------------------------------------------------------------------------
Session LoadSession(const QString& path)
{
  constexpr std::size_t most = std::size_t(1) << 26;
  std::string text;
  const std::string message = vtkRelievoFileKind::ReadWhole(path.toStdString(), most, text);
  if (!message.empty())
  {
    Fail(path, QString::fromStdString(message));
  }
  QJsonParseError trouble;
  const QJsonObject root =
    QJsonDocument::fromJson(QByteArray::fromStdString(text), &trouble).object();
  if (root[Mark].toInt() != Version || !root["words"].isArray())
  {
    Fail(path,
      trouble.error == QJsonParseError::NoError
        ? QString("is no session of relievo-viewer (expected \"%1\": %2 and \"words\")")
            .arg(Mark)
            .arg(Version)
        : "is no session: " + trouble.errorString());
  }
  std::vector<std::string> words;
  const QJsonArray given = root["words"].toArray();
  for (const auto& word : given) // the string type differs between Qt versions
  {
    if (!word.isString() || word.toString().contains(QChar(0)))
    {
      Fail(path, "is no session: its \"words\" are not all text");
    }
    words.push_back(word.toString().toStdString());
  }
  try
  {
    scene::Settings view = scene::Settings::FromWords(words);
    for (const std::string& each : view.Files)
    {
      reading::CheckExtension(each);
    }
    PlaceSun(view, root["sun"].toObject());
    std::vector<std::string> zones;
    const QJsonArray typed = root["typed_zones"].toArray();
    for (const auto& light : typed)
    {
      zones.push_back(light.toString().toStdString());
    }
    view.SetAll(TypedZones, zones);
    DropIdleZones(view);
    view.MakePathsAbsolute(QFileInfo(path).absolutePath().toStdString());
    return { view, ReadKeys(root["keys"]) };
  }
  catch (const std::exception& error)
  {
    Fail(path, error.what());
  }
}
}
