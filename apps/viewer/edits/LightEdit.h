// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One light in the words of --light: colour, strength, size and where it is. What is not edited
 * keeps its words.
 */
#ifndef LightEdit_h
#define LightEdit_h

#include "Document.h"
#include "LightOptions.h"

#include <QWidget>

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace relievoQt
{
class Number;
class SunEdit;
}

namespace viewer
{
class ColorButton;
class TripleEdit;

class LightEdit : public QWidget
{
  Q_OBJECT

public:
  explicit LightEdit(Document* document, QWidget* parent = nullptr);

  enum Owner
  {
    OWN,    ///< the user's
    PRESET, ///< becomes the user's by an edit
    OFF     ///< cannot be edited
  };

  /// Shows the light. Sends no signal.
  void SetWord(const std::string& word, Owner owner);

  /// A place in the picture was chosen: a spot turns there, a point moves over it.
  void Place(const std::array<double, 3>& place);

  /// No click in the picture is waited for any more.
  void StopPlacing();

Q_SIGNALS:
  void edited(const QString& word);

  /// The next click in the picture is to be told to Place, and what it is for; empty: no longer.
  void placing(const QString& hint);

private:
  void AddCommon(QFormLayout* rows);
  void AddPlace();
  void SetValue(const char* name, const std::string& value);
  void SetNumbers(const std::string& numbers);
  void ShowSoftness(const scene::LightChoice& light);
  void ShowSun(const scene::LightChoice& light);
  void ShowWords();
  void WriteSun();
  void WritePlace();

  Document* Edited;
  std::string Word; // that is shown
  int WordUp = -1;
  scene::LightWords Words;
  scene::LightChoice::Kind Kind = scene::LightChoice::Kind::Sun;
  scene::SunTime Time; // for a sun that is to be placed by it
  QLineEdit* Name;
  ColorButton* Color;
  relievoQt::Number *Intensity, *Angle, *Radius;
  QWidget* Softness; // of them the one that the light has
  QCheckBox* Casts;
  relievoQt::SunEdit* Sun;
  QWidget* Where; // of spots and points
  TripleEdit *Position, *Target;
  relievoQt::Number* Cone;
  QLabel *TargetLabel, *ConeLabel;
  QPushButton* PlaceButton;
};
}

#endif
