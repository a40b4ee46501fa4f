// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The settings that the window shows, and who is told when they change.
 */
#ifndef Document_h
#define Document_h

#include "Settings.h"

#include <QObject>
#include <QString>

#include <array>
#include <functional>
#include <set>

namespace viewer
{
class Document : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  const Settings& Get() const { return this->Now; }

  /// Refuses settings that the command line would refuse.
  void Set(const Settings& settings);
  void Change(const std::function<void(Settings&)>& edit);

  ///@{
  /// Goes back to settings that are known to be good: because the user wants so, or after a picture
  /// of the new ones failed.
  void Return(const Settings& good);
  void Refuse(const Settings& good, const QString& why);
  ///@}

  ///@{
  /// Names of the arrays of what is shown.
  const std::set<std::string>& GetArrays() const { return this->Arrays; }
  void SetArrays(const std::set<std::string>& arrays);
  ///@}

  ///@{
  /// Seconds that animations last; equal: nothing moves.
  const std::array<double, 2>& GetTimes() const { return this->Times; }
  void SetTimes(const std::array<double, 2>& times);
  ///@}

Q_SIGNALS:
  void timesChanged();

  /// What was asked for last is seen, or was refused.
  void shown();
  void changed();

  /// Others than before, to be shown; panels show them already.
  void asked();
  void arraysChanged();
  void refused(const QString& why);

private:
  Settings Now;
  std::set<std::string> Arrays;
  std::array<double, 2> Times = { 0.0, 0.0 };
};
}

#endif
