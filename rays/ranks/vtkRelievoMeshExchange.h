// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What any process has in the way of rays, brought to all of them: rays need all of it. Processes
// that draw together send rays all or none. A frame in which nothing has changed takes one
// reduction of a few numbers; otherwise what has changed travels, and all hear whether any of them
// has no room for it.
#ifndef vtkRelievoMeshExchange_h
#define vtkRelievoMeshExchange_h

#include "vtkMultiProcessController.h"
#include "vtkRelievoMeshMessage.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoMeshExchange
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
  std::string Share(const vtkRelievoMeshPart& own, bool ready);

  // Whether that was another process's method: no reason not to ask again.
  bool IsDeclined() const { return this->Declined; }

  // Why this process cannot send rays with the whole scene, or ""; returns why not all of them can.
  std::string Confirm(const std::string& fault);

  // What Share has brought: the meshes in the order of the processes, the receivers' boxes joined,
  // and the boxes of what rays cannot follow in the others.
  const vtkRelievoMeshPart& GetWhole() const { return this->Whole; }

  // The others' meshes, and what is in the whole in the place of an own one: its cells that are no
  // copies of another process's.
  std::vector<vtkRelievoPlacedMesh> GetOthers() const;
  vtkPolyData* GetOwn(vtkPolyData* mesh) const { return this->Sender.GetOwn(mesh); }

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
  void MakeWhole(const vtkRelievoMeshPart& own);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkRelievoMeshSender Sender;
  std::vector<vtkRelievoMeshReceiver> Others; // one for each process, also for this one
  vtkRelievoMeshPart Whole;
  bool Lost = true;
  bool Changed = false;
  bool Declined = false;
  double Seconds = 0.0; // that the last exchange took, and what came
  double Bytes = 0.0;
};

#endif
