// Which start shapes a rank computes: those of the lines that it has nodes of, and of lines that act on these
// at the start, because they cross or because joints hold them together.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// A line as the case gives it. Those of its parts that events cut off follow it in Case::lines.
struct GivenLine {
  int first = 0, parts = 1;  // in Case::lines
};
std::vector<GivenLine> given_lines(const model::Case& c);

// For each given line whether one with which it is in a group is `wanted`. Lines are in one group if they
// share a joint or their boxes overlap in plan; so do all within the box of both, which makes the groups no
// smaller. Raising a line does not change its extent in plan. O(lines log lines).
std::vector<bool> with_groups(const model::Case& c, const std::vector<GivenLine>& lines,
                              const std::vector<Box>& boxes, const std::vector<bool>& wanted);

// A sentence on the start of a line, and its place among all of them.
struct StartNote {
  int first = 0, second = 0;
  std::string text;
};

// The first `most` sentences of all ranks in their order, and how many more there are. Collective.
struct FirstNotes {
  std::vector<std::string> texts;
  int more = 0;
};
FirstNotes first_notes(MPI_Comm comm, std::vector<StartNote> mine, int most);

}  // namespace hawser
