// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Differences between the records of two frames that concern the whole picture: overlays, tone and
// other settings.
#ifndef vtkRelievoRecordChanges_h
#define vtkRelievoRecordChanges_h

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"

namespace relievo::compare
{
class RecordChanges
{
public:
  RecordChanges(const Frame& before, const Frame& after, CauseList& list);

  ///@{
  // The index of the first such finding in the list; -1: none.
  int GetOverlay() const { return this->Overlay; }
  int GetTone() const { return this->Tone; }
  int GetSettings() const { return this->Settings; }
  ///@}

private:
  int Overlay = -1, Tone = -1, Settings = -1;
};
}

#endif
