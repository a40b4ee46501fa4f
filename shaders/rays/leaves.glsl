// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Indices into a tree of vtkRelievoBoxTree, from the numbers of leaves that its nodes have in w.

// The number of nodes in a subtree with so many leaves.
int relievoTreeNodesOf(float leaves)
{
  return 2 * int(leaves) - 1;
}

// The index of a leaf; -1 - index is stored.
int relievoTreeLeaf(float w)
{
  return int(float(-1.0) - w);
}

// The first triangle of a leaf; all leaves of a mesh but the last are full.
int relievoTreeLeafFirst(float w)
{
  return 4 * relievoTreeLeaf(w);
}
