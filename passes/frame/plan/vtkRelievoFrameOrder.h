// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The order of a plan's needed nodes: each after the writers of its resources, and before later
// changes of the colour that it reads; otherwise by slot, order and name.
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

  // Indices of the nodes, in order; meaningless while GetRefused() is not empty.
  const std::vector<int>& Get() const { return this->Order; }

  // Nodes without a place, and the reasons, in words that name the stages.
  const std::vector<std::pair<int, std::string>>& GetRefused() const { return this->Refused; }

private:
  using Node = vtkRelievoFramePlan::Node;

  // The awaited node, and its resource.
  using Wait = std::pair<int, std::string>;

  std::vector<int> GetColorChain() const;
  void WaitForReads();
  void RefuseLate();
  void Sort();
  void RefuseCircle(const std::vector<bool>& done);

  const std::vector<Node>& Nodes;
  std::vector<std::vector<Wait>> Waits; // by node
  std::vector<int> Order;
  std::vector<std::pair<int, std::string>> Refused;
};

#endif
