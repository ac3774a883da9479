// A piece of a term's committed history that belongs to a node: what a checkpoint stores.
#pragma once

#include <vector>

namespace hawser {

struct HistoryRecord {
  int node = 0;  // mesh node (file order)
  int key = 0;   // whatever the term tells its records apart by (a volume, say)
  std::vector<double> values;
};

}  // namespace hawser
