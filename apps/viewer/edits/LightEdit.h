// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Edits one light in the words of --light: colour, strength, size and position. Unedited parts keep
 * their words.
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
    PRESET, ///< becomes the user's when edited
    OFF     ///< cannot be edited
  };

  /// Shows the light. Emits no signal.
  void SetWord(const std::string& word, Owner owner);

  /// Whether the time zone of the sun shown was typed, or is not the longitude's.
  bool HasOwnZone() const { return this->OwnZone; }

  /// Applies a place chosen in the picture: a spot turns there, a point light moves above it.
  void Place(const std::array<double, 3>& place);

  /// Cancels waiting for a click in the picture.
  void StopPlacing();

Q_SIGNALS:
  void edited(const QString& word);

  /// The next click in the picture must be passed to Place; the text names its purpose; empty:
  /// cancelled.
  void placing(const QString& hint);

private:
  void AddCommon(QFormLayout* rows);
  void AddPlace();
  void SetValue(const char* name, const std::string& value);
  void SetNumbers(const std::string& numbers);
  void ShowSoftness(const look::LightChoice& light);
  void ShowSun(const look::LightChoice& light);
  void ShowWords();
  void WriteSun();
  void WritePlace();

  Document* Edited;
  std::string Word; // the light shown
  int WordUp = -1;
  look::LightWords Words;
  look::LightChoice::Kind Kind = look::LightChoice::Kind::Sun;
  look::SunTime Time;   // for a sun by date and time
  bool OwnZone = false; // the time zone was typed, or is not the longitude's
  QLineEdit* Name;
  ColorButton* Color;
  relievoQt::Number *Intensity, *Angle, *Radius;
  QWidget* Softness; // the size edit of the present kind of light
  QCheckBox* Casts;
  relievoQt::SunEdit* Sun;
  QWidget* Where; // position of spots and points
  TripleEdit *Position, *Target;
  relievoQt::Number* Cone;
  QLabel *TargetLabel, *ConeLabel;
  QPushButton* PlaceButton;
};
}

#endif
