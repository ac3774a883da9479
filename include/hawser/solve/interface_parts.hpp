// Interface between ranks in independent parts.
//
// The unknowns that some rank has as ghosts form the interface. Two of its blocks belong to the same part if
// they are connected through the pattern of the rows of some rank. Each platform that is cut between ranks
// forms a part, which its ranks solve without the others. A part is solved by the rank that owns its first
// block.
#pragma once

#include <petscmat.h>
#include <petscsf.h>

#include <vector>

#include "hawser/base/handle.hpp"

namespace hawser {

using SfHandle = Handle<PetscSF, PetscSFDestroy>;

// This rank's share of a part. Blocks are of three unknowns.
struct InterfacePart {
  std::vector<int> rows;    // own blocks connected with it, ascending
  std::vector<int> shared;  // places in `rows` of those that are ghosts of other ranks
  std::vector<int> ghosts;  // columns of the matrix of other ranks' unknowns, ascending
  int solver = 0;           // rank that solves it
};

class InterfaceParts {
 public:
  // A: MPIBAIJ with blocks of three rows and a symmetric pattern, assembled. Collective.
  explicit InterfaceParts(Mat A);

  const std::vector<InterfacePart>& parts() const { return parts_; }
  // Blocks of each part that this rank solves.
  const std::vector<int>& solved() const { return solved_; }
  // Unknowns of the largest part of any rank.
  int largest() const { return largest_; }

  // Sends the values of the shared blocks of `parts`, part by part, to the ranks that solve the parts, where
  // they arrive in the order of `solved`.
  void send_shared(const std::vector<double>& shared, std::vector<double>& solved) const;
  // Returns the values of the ghosts of `parts`, part by part.
  void send_ghosts(const std::vector<double>& solved, std::vector<double>& ghosts) const;
  // Sends matrices of shared rows and ghost columns, by rows of blocks of nine numbers, to the ranks that
  // solve the parts, as entries of the matrices of `solved`; other entries are zero.
  void send_matrices(const std::vector<double>& shared_ghosts, std::vector<double>& solved) const;

 private:
  std::vector<InterfacePart> parts_;
  std::vector<int> solved_;
  int largest_ = 0;
  SfHandle shared_, ghosts_, matrices_;
};

}  // namespace hawser
