// Selection of the start shapes that a rank computes: those of lines with nodes on this rank, and of lines
// that cross these or share a joint with them.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/model/cut_lines.hpp"

namespace hawser {

// True for each given line whose group contains a `required` line. Two lines are in one group if they share a
// joint or their boxes overlap in plan. The search replaces overlapping boxes by the box around them, which
// can only enlarge groups. Raising a line does not change its extent in plan. O(lines log lines).
std::vector<bool> with_groups(const model::Case& c, const std::vector<model::GivenLine>& lines,
                              const std::vector<Box>& boxes, const std::vector<bool>& required);

// A note on the start of a line. Notes are printed in the order of (first, second).
struct StartNote {
  int first = 0;
  int second = 0;
  std::string text;
};

// First `limit` notes of all ranks in order, and the number of further ones. Collective.
struct FirstNotes {
  std::vector<std::string> texts;
  int more = 0;
};
FirstNotes first_notes(MPI_Comm comm, std::vector<StartNote> notes, int limit);

}  // namespace hawser
