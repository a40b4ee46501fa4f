// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The sun: one --light of kind sun, the first unless it was switched off, by angles or by date,
 * time and place. The other lights are those of LightPanel.
 */
#ifndef SunGroup_h
#define SunGroup_h

#include "Document.h"
#include "FoldGroup.h"
#include "Sun.h"

#include <map>
#include <string>
#include <vector>

namespace relievoQt
{
class SunEdit;
}

namespace viewer
{
class PresetsLights;

class SunGroup : public FoldGroup
{
  Q_OBJECT

public:
  explicit SunGroup(Document* document, QWidget* parent = nullptr);

  ///@{
  /// Place and clock, which only the session keeps.
  SunTime GetTime() const;
  void SetTime(const SunTime& time, bool byTime);
  bool IsByTime() const;
  ///@}

  /// Another axis points up: a sun by time stands where it did in the sky, elsewhere in the data.
  void FollowUpAxis();

  /// All lights but the sun, in the words of --light. Which is the sun stays as it is.
  std::vector<std::string> GetOthers() const;
  void SetOthers(const std::vector<std::string>& others);

private:
  void ShowSettings();
  void ShowPlace(const SunAngles& angles);
  void PlaceSun();
  void Switch(bool on);
  void SetLights(const std::vector<std::string>& lights, int own);
  void Insert(const std::string& sun, std::size_t place);

  Document* Edited;
  relievoQt::SunEdit* Sun;
  PresetsLights* Preset;
  std::vector<std::string> Lights, Next; // as they were seen last, and as they are set now
  int Own = -1, NextOwn = -1;            // which of them is the sun; -1: none
  std::string Written;                   // the sun whose angles are shown
  int WrittenUp = 1;
  std::map<std::string, SunTime> ByTime; // of suns in words, those that were placed so
  std::string Kept;                      // while it is switched off
  std::size_t KeptPlace = 0;
};
}

#endif
