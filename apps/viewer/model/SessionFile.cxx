// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionFile.h"

#include "Errors.h"
#include "Outputs.h"
#include "Readers.h"
#include "vtkRelievoFileKind.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <exception>

namespace viewer
{
namespace
{
const char* const Mark = "relievo-viewer";
constexpr int Version = 1;

[[noreturn]] void Fail(const QString& path, const QString& why)
{
  throw scene::WorkError((path + ": " + why.simplified()).toStdString()); // one line
}
}

//------------------------------------------------------------------------------
void SaveSession(const QString& path, const Session& session)
{
  QJsonArray words;
  for (const std::string& word : session.View.GetWords())
  {
    words.append(QString::fromStdString(word));
  }
  const SunTime& sun = session.Sun;
  const QJsonObject root{ { Mark, Version }, { "words", words },
    { "sun",
      QJsonObject{ { "by_time", session.SunByTime },
        { "date", QJsonArray{ sun.Year, sun.Month, sun.Day } }, { "hour", sun.Hour },
        { "time_zone", sun.TimeZone }, { "latitude", sun.Latitude },
        { "longitude", sun.Longitude } } } };
  const std::string place = path.toStdString();
  scene::Outputs outputs;
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
  const std::string instead = vtkRelievoFileKind::FindInstead(path.toStdString());
  if (!instead.empty())
  {
    Fail(path, "expected a session, but " + QString::fromStdString(instead));
  }
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
  {
    Fail(path, file.errorString());
  }
  QJsonParseError trouble;
  const QJsonObject root = QJsonDocument::fromJson(file.readAll(), &trouble).object();
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
  for (const auto& word : given) // whose type differs between versions of Qt
  {
    if (!word.isString() || word.toString().contains(QChar(0)))
    {
      Fail(path, "is no session: its \"words\" are not all text");
    }
    words.push_back(word.toString().toStdString());
  }
  Session session;
  try
  {
    session.View = scene::Settings::FromWords(words);
    for (const std::string& each : session.View.Files)
    {
      scene::CheckExtension(each);
    }
  }
  catch (const std::exception& error)
  {
    Fail(path, error.what());
  }
  const QJsonObject sun = root["sun"].toObject();
  const QJsonArray date = sun["date"].toArray();
  const SunTime fresh;
  session.SunByTime = sun["by_time"].toBool();
  session.Sun = { date[0].toInt(fresh.Year), date[1].toInt(fresh.Month), date[2].toInt(fresh.Day),
    sun["hour"].toDouble(fresh.Hour), sun["time_zone"].toDouble(fresh.TimeZone),
    sun["latitude"].toDouble(fresh.Latitude), sun["longitude"].toDouble(fresh.Longitude) };
  return session;
}
}
