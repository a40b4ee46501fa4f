// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exchanges the traced meshes between processes, because rays need the whole scene. Processes that
// draw together trace rays either all or none. A frame without changes costs one reduction of a few
// numbers; otherwise the changes are sent, and all processes learn whether any of them has run out
// of memory for the scene.
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

  // Whether there are several processes. If so, every process calls, once per frame, either
  // Decline, or Share and, if that returns "", Confirm.
  bool IsOn() const { return this->Controller && this->Controller->GetNumberOfProcesses() > 1; }

  // Call if this process does not trace rays: because it failed before (`refused`), or by its
  // settings. Returns whether it should retry with the others after a change, by calling Share.
  bool Decline(bool refused);

  // Sends this process's part to all. `ready`: data made from the whole scene is still valid if
  // nothing has changed. Returns an error message if no rays can be traced.
  std::string Share(const vtkRelievoMeshPart& own, bool ready);

  // Whether the error comes from another process's settings, so that a retry makes sense.
  bool IsDeclined() const { return this->Declined; }

  // `fault`: this process's error with the whole scene, or "". Returns an error message if any
  // process failed.
  std::string Confirm(const std::string& fault);

  // The result of Share: the meshes in the processes' order, the merged boxes of receivers, and the
  // boxes of casters that other processes cannot trace.
  const vtkRelievoMeshPart& GetWhole() const { return this->Whole; }

  // The others' meshes; and the replacement of an own mesh in the whole: its cells without copies
  // of another process's.
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
    bool Lost = false; // a process has lost the others' data
  };
  Answer Ask(Voice voice, bool changed);
  std::vector<vtkRelievoBytes> Gather(const vtkRelievoBytes& own);
  void MakeWhole(const vtkRelievoMeshPart& own);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkRelievoMeshSender Sender;
  std::vector<vtkRelievoMeshReceiver> Others; // one for each process, this one included
  vtkRelievoMeshPart Whole;
  bool Lost = true;
  bool Changed = false;
  bool Declined = false;
  double Seconds = 0.0; // duration of the last exchange, and received amounts
  double Bytes = 0.0;
};

#endif
