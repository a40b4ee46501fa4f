// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What casts in any process, brought to all of them: rays need all of it. Processes that draw
// together send rays all or none. A frame in which nothing has changed takes one reduction of a few
// numbers; otherwise what has changed travels, and all hear whether any of them has no room for it.
#ifndef vtkRelievoCasterExchange_h
#define vtkRelievoCasterExchange_h

#include "vtkMultiProcessController.h"
#include "vtkRelievoCasterMessage.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

struct vtkRelievoSurface;

class vtkRelievoCasterExchange
{
public:
  void SetController(vtkMultiProcessController* controller);

  // Whether there is anybody to exchange with. If so, every process calls, once in a frame, either
  // Decline, or Share and, if that is "", Confirm.
  bool IsOn() const { return this->Controller && this->Controller->GetNumberOfProcesses() > 1; }

  // This process sends no rays: because it could not before (`refused`), or is not to. Whether it
  // is to try again with the others, for which something has changed: then it calls Share.
  bool Decline(bool refused);

  // The part of this process becomes known to all. `ready`: what is made of the whole scene is
  // still right if nothing has changed. Returns why there are no rays, in words.
  std::string Share(const vtkRelievoCasterPart& own, bool ready);

  // Whether that was another process's method: no reason not to ask again.
  bool IsDeclined() const { return this->Declined; }

  // Why this process cannot send rays with the whole scene, or ""; returns why not all of them can.
  std::string Confirm(const std::string& fault);

  // What Share has brought: the casters in the order of the processes, the receivers' boxes joined,
  // and the others' casters that cannot be followed.
  const vtkRelievoCasterPart& GetWhole() const { return this->Whole; }

  // What the others cast with, and where own meshes have copies of the others' cells, what casts in
  // their place.
  void AddTo(std::vector<vtkRelievoSurface>& surfaces) const;

  std::string GetReport() const;
  void Clear();

private:
  enum Voice
  {
    Never,
    Refused,
    Ready
  };
  struct Answer
  {
    int Least = Never;
    int Most = Never;
    bool Changed = false;
    bool Lost = false; // what one of them knew of the others
  };
  Answer Ask(Voice voice, bool changed);
  std::vector<vtkRelievoBytes> Gather(const vtkRelievoBytes& own);
  void MakeWhole(const vtkRelievoCasterPart& own);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkRelievoCasterSender Sender;
  std::vector<vtkRelievoCasterReceiver> Others; // one for each process, also for this one
  vtkRelievoCasterPart Whole;
  bool Lost = true;
  bool Changed = false;
  bool Declined = false;
  double Seconds = 0.0; // that the last exchange took, and what came
  double Bytes = 0.0;
};

#endif
