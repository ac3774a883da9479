// The interface between ranks in parts that do not depend on each other.
//
// The unknowns that some rank sees as ghosts are the interface. Two blocks of it belong to the same part
// where they are connected through the pattern of the rows of some rank. Platforms that are cut between ranks
// are so many parts, each of which its ranks solve without the others. A part is solved by the rank that owns
// its first block.
#pragma once

#include <petscmat.h>
#include <petscsf.h>

#include <vector>

#include "hawser/base/handle.hpp"

namespace hawser {

using SfHandle = Handle<PetscSF, PetscSFDestroy>;

// What this rank has of a part. Blocks are of three unknowns.
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

  // Values of the unknowns of `parts`' shared blocks, part by part, at the ranks that solve them: those of
  // the parts of `solved`, one after another.
  void bring_shared(const std::vector<double>& shared, std::vector<double>& solved) const;
  // The way back: values of the ghosts of `parts`, part by part.
  void send_ghosts(const std::vector<double>& solved, std::vector<double>& ghosts) const;
  // Matrices of shared rows and ghost columns, each by rows of blocks of nine numbers, as part of the
  // matrices of `solved`, likewise; the rest of these is zero.
  void bring_matrices(const std::vector<double>& shared_ghosts, std::vector<double>& solved) const;

 private:
  std::vector<InterfacePart> parts_;
  std::vector<int> solved_;
  int largest_ = 0;
  SfHandle shared_, ghosts_, matrices_;
};

}  // namespace hawser
