// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The order of a plan's needed nodes: each after those whose resources it reads, and before those
// that change the colour which it reads; within that by slot, order and name.
#ifndef vtkRelievoFrameOrder_h
#define vtkRelievoFrameOrder_h

#include "vtkRelievoFramePlan.h"

#include <string>
#include <utility>
#include <vector>

class vtkRelievoFrameOrder
{
public:
  explicit vtkRelievoFrameOrder(const std::vector<vtkRelievoFramePlan::Node>& nodes);

  // Places of the nodes, in order; of no use while some have to be refused.
  const std::vector<int>& Get() const { return this->Order; }

  // Nodes that have no place, and why, in words that name the stages.
  const std::vector<std::pair<int, std::string>>& GetRefused() const { return this->Refused; }

private:
  using Node = vtkRelievoFramePlan::Node;

  // The node that is waited for, and the resource that it writes.
  using Wait = std::pair<int, std::string>;

  std::vector<int> GetColorChain() const;
  void WaitForReads();
  void RefuseLate();
  void Sort();
  void RefuseCircle(const std::vector<bool>& done);

  const std::vector<Node>& Nodes;
  std::vector<std::vector<Wait>> Waits; // of each node
  std::vector<int> Order;
  std::vector<std::pair<int, std::string>> Refused;
};

#endif
