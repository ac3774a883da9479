// Expected cost of a run, from a trial run on this machine.
#pragma once

#include <functional>
#include <string>

#include "hawser/io/results_size.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

// CPU time of this process, s.
double cpu_time();

// Beginning of a run, without results.
struct TrialRun {
  double iteration = 0;           // CPU s per static iteration if statics did not end; 0: it ended
  double spent = 0, reached = 0;  // CPU s; simulated time, s
  double rate = 0;  // CPU s per simulated second, in the second half of the CPU time of dynamics
  double duration = 0, longest = 0;  // s, of the run and its longest step; duration 0: no dynamics
  double steps = 0;                  // accepted steps of the whole run, extrapolated from the second half
  bool moved = false;                // dynamics has started
  std::string failure;               // reason why the run stops; empty: none
};
// Runs statics and dynamics for `budget` CPU s, at least one step each. On one rank, because each rank reads
// its own clock. on_state: called at the equilibrium and after every step.
TrialRun trial_run(Simulation& sim, const model::Case& c, double budget,
                   const std::function<void(const Kinematics&)>& on_state = {});

// CPU s of the whole run.
double expected_cost(const TrialRun& trial);
// "expected cost: about 12 CPU s, by its first 3.2 of 400 s"
std::string cost_sentence(const TrialRun& trial);

// "expected results: about 24 MB (fields 18, histories 4, ...)", followed by a note if the size is large or
// exceeds the free space of the folder's disk.
std::string size_sentence(const io::ResultsSize& size, const std::string& folder);

// Bytes: largest memory of this process so far, and present memory.
double peak_memory();
double memory_now();
// Of that the pages of files, which are mostly those of libraries.
double file_memory_now();
// Bytes on one rank: largest memory until the files were read; data of all lines on every rank (the case, the
// mesh, its owners); largest memory in trial_run() including these; and the pages of files among these that
// trial_run() added, which every rank has.
struct MemoryUse {
  double read = 0, shared = 0, measured = 0;
  bool moved = true;  // as in TrialRun
  double of_files = 0;
};
// "expected memory: about 0.9 GB", or of the rank with the largest work, `imbalance` times the mean.
std::string memory_sentence(const MemoryUse& use, double imbalance, int ranks);

}  // namespace hawser::run
