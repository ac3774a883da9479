// Messages about the expected cost of a run, estimated from a trial run.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hawser::advice {

// Point at which the trial ended.
struct Trial {
  bool by_statics = false;           // during statics
  double reached = 0, duration = 0;  // s, simulated time; duration of the run
};
// cost: CPU s; not finite: unknown. "expected cost: about 12 CPU s, by its first 3.2 of 400 s"
std::string expected_cost(double cost, const Trial& trial);
std::string trial_fails(const std::string& why);

// "expected results: about 24 MB (fields 18 MB, histories 4 MB, ...)", followed by a note if the size is
// large or exceeds the free space of the folder's disk. All in bytes; available: free space, below 0:
// unknown.
struct ResultBytes {
  std::vector<std::pair<std::string, double>> parts;
  double total = 0, available = -1;
  double contact_point = 0;  // of each point of contact, in addition to `total`
};
std::string expected_results(const ResultBytes& size, const std::string& folder);

// nodes: per rank; imbalance: largest work of a rank over the mean. "partition: 2 ranks, 71 + 72 nodes, on
// one of them 1.02 times the mean work; 1 cut line, 1 cut element"
std::string partition(std::span<const int> nodes, double imbalance, int cut_lines, int cut_elements);

// In bytes; "expected memory: about 0.9 GB".
std::string expected_memory(double bytes, bool of_each_rank);

}  // namespace hawser::advice
