// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFormulas.h"
#include "vtkRelievoGltfParts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
// A node's transform to its parent: a matrix, or its three parts.
glm::dmat4 ReadMatrix(const GltfValue& node, std::optional<NodeParts>& parts)
{
  const GltfValue matrix = node.Get("matrix");
  glm::dmat4 m(1.);
  if (matrix.IsThere())
  {
    const std::vector<double> columns = matrix.GetNumbers(std::vector<double>(16));
    for (int i = 0; i < 16; ++i)
    {
      m[i / 4][i % 4] = columns[static_cast<std::size_t>(i)];
    }
    return m;
  }
  const std::vector<double> place = node.Get("translation").GetNumbers({ 0., 0., 0. });
  const std::vector<double> turn = node.Get("rotation").GetNumbers({ 0., 0., 0., 1. });
  const std::vector<double> scale = node.Get("scale").GetNumbers({ 1., 1., 1. });
  glm::dvec4 q(turn[0], turn[1], turn[2], turn[3]);
  const double length = glm::length(q);
  if (length < 1e-12)
  {
    node.Get("rotation").Fail("has no length, expected a quaternion of length 1");
  }
  q /= length;
  const glm::dmat3 axes = f64::relievoQuaternionMatrix(q);
  for (int i = 0; i < 3; ++i)
  {
    m[i] = glm::dvec4(axes[i] * scale[static_cast<std::size_t>(i)], 0.);
  }
  m[3] = glm::dvec4(place[0], place[1], place[2], 1.);
  parts = NodeParts{ glm::dvec3(m[3]), q, glm::dvec3(scale[0], scale[1], scale[2]) };
  return m;
}

// The parents of the file's nodes, -1 for roots. Throws for nodes with two parents or in a cycle.
std::vector<int> ReadParents(const GltfValue& nodes, std::vector<std::vector<int>>& children)
{
  const std::size_t count = nodes.GetSize();
  std::vector<int> parents(count, -1);
  children.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const GltfValue list = nodes.At(i).Get("children");
    for (std::size_t j = 0; j < list.GetSize(); ++j)
    {
      const auto child = static_cast<std::size_t>(list.At(j).GetIndex("nodes", count));
      if (parents[child] >= 0)
      {
        list.At(j).Fail("names nodes[" + std::to_string(child) + "], which is a child of nodes[" +
          std::to_string(parents[child]) + "] already; expected one parent");
      }
      parents[child] = static_cast<int>(i);
      children[i].push_back(static_cast<int>(child));
    }
  }
  // A root is reached within as many steps as there are nodes, or never.
  std::vector<int> depths(count, -1);
  std::vector<int> chain;
  for (std::size_t i = 0; i < count; ++i)
  {
    chain.clear();
    int at = static_cast<int>(i);
    while (at >= 0 && depths[static_cast<std::size_t>(at)] < 0)
    {
      chain.push_back(at);
      if (chain.size() > count)
      {
        nodes.At(i).Fail("is below itself: its parents, one after the other, go around");
      }
      at = parents[static_cast<std::size_t>(at)];
    }
    int depth = at < 0 ? -1 : depths[static_cast<std::size_t>(at)];
    for (auto each = chain.rbegin(); each != chain.rend(); ++each)
    {
      depths[static_cast<std::size_t>(*each)] = ++depth;
    }
    if (depth >= gltf::DeepestNodes)
    {
      nodes.At(i).Fail("is below more than " + std::to_string(gltf::DeepestNodes) +
        " others; at most these are read");
    }
  }
  return parents;
}

// The roots of the scene: the file's choice, otherwise the first scene's; without scenes all roots.
// A node below another listed node does not count as a root.
std::vector<int> ReadRoots(
  const GltfDocument& document, const std::vector<int>& parents, std::vector<std::string>& notes)
{
  const GltfValue scenes = document.Get("scenes");
  const int chosen = document.Get("scene").GetIndex("scenes", scenes.GetSize());
  std::vector<int> roots;
  if (scenes.GetSize() == 0)
  {
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
      if (parents[i] < 0)
      {
        roots.push_back(static_cast<int>(i));
      }
    }
    return roots;
  }
  const GltfValue list = scenes.At(static_cast<std::size_t>(std::max(chosen, 0))).Get("nodes");
  std::vector<bool> isNamed(parents.size(), false);
  for (std::size_t i = 0; i < list.GetSize(); ++i)
  {
    const int root = list.At(i).GetIndex("nodes", parents.size());
    isNamed[static_cast<std::size_t>(root)] = true;
  }
  for (std::size_t i = 0; i < list.GetSize(); ++i)
  {
    const int root = list.At(i).GetIndex("nodes", parents.size());
    const int parent = parents[static_cast<std::size_t>(root)];
    if (parent < 0)
    {
      roots.push_back(root);
      continue;
    }
    int above = parent;
    while (above >= 0 && !isNamed[static_cast<std::size_t>(above)])
    {
      above = parents[static_cast<std::size_t>(above)];
    }
    const std::string what = "names nodes[" + std::to_string(root) +
      "], which is a child of nodes[" + std::to_string(parent) + "]";
    if (above < 0)
    {
      list.At(i).Fail(what + "; expected a root");
    }
    notes.push_back(list.At(i).GetPlace() + " " + what + " and is drawn once, there");
  }
  return roots;
}

// Visits each root and everything below it, level by level, parents first.
void Walk(const std::vector<int>& roots, const std::vector<std::vector<int>>& children,
  std::vector<bool>& known, std::vector<int>& order)
{
  std::size_t next = order.size();
  const auto add = [&](int node) {
    if (!known[static_cast<std::size_t>(node)])
    {
      known[static_cast<std::size_t>(node)] = true;
      order.push_back(node);
    }
  };
  std::for_each(roots.begin(), roots.end(), add);
  for (; next < order.size(); ++next)
  {
    const std::vector<int>& below = children[static_cast<std::size_t>(order[next])];
    std::for_each(below.begin(), below.end(), add);
  }
}

// The roots of joints outside the trees of the scene.
std::vector<int> FindRootsOfJoints(const GltfDocument& document, const std::vector<int>& shown,
  const std::vector<int>& parents, const std::vector<bool>& known)
{
  std::vector<int> roots;
  const GltfValue skins = document.Get("skins");
  for (const int node : shown)
  {
    const int skin = document.Get("nodes")
                       .At(static_cast<std::size_t>(node))
                       .Get("skin")
                       .GetIndex("skins", skins.GetSize());
    const GltfValue joints =
      skin < 0 ? GltfValue(nullptr, "") : skins.At(static_cast<std::size_t>(skin)).Get("joints");
    for (std::size_t i = 0; i < joints.GetSize(); ++i)
    {
      int root = joints.At(i).GetIndex("nodes", parents.size());
      if (!known[static_cast<std::size_t>(root)])
      {
        while (parents[static_cast<std::size_t>(root)] >= 0)
        {
          root = parents[static_cast<std::size_t>(root)];
        }
        roots.push_back(root);
      }
    }
  }
  return roots;
}
}

//------------------------------------------------------------------------------
GltfNodes ReadGltfNodes(const GltfDocument& document, Model& model)
{
  const GltfValue list = document.Get("nodes");
  std::vector<std::vector<int>> children;
  const std::vector<int> parents = ReadParents(list, children);
  GltfNodes nodes;
  std::vector<bool> known(parents.size(), false);
  Walk(ReadRoots(document, parents, model.Notes), children, known, nodes.Shown);
  std::vector<int> order = nodes.Shown;
  Walk(FindRootsOfJoints(document, nodes.Shown, parents, known), children, known, order);
  nodes.Numbers.assign(parents.size(), -1);
  for (const int place : order)
  {
    const auto i = static_cast<std::size_t>(place);
    const GltfValue value = list.At(i);
    ModelNode node;
    node.Name = value.Get("name").GetText("");
    node.Name = node.Name.empty() ? value.GetPlace() : node.Name;
    node.Parent = parents[i] < 0 ? -1 : nodes.Numbers[static_cast<std::size_t>(parents[i])];
    node.Rest = ReadMatrix(value, node.Parts);
    nodes.Numbers[i] = static_cast<int>(model.Nodes.size());
    model.Nodes.push_back(node);
  }
  return nodes;
}
}
