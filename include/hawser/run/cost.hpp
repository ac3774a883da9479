// What a run will about cost, from a trial run on this machine.
#pragma once

#include <functional>
#include <string>

#include "hawser/io/results_size.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

// s, of this process.
double cpu_time();

// The beginning of a run, without results.
struct TrialRun {
  double iteration = 0;              // CPU s, of one iteration of statics where that did not end; 0: it did
  double spent = 0, reached = 0;     // CPU s; s, simulated
  double rate = 0;                   // CPU s a simulated second, of the second half of what dynamics spent
  double duration = 0, longest = 0;  // s, of the run and its longest step; duration 0: no dynamics
  double steps = 0;     // accepted ones, to the end of the run if the rest is like the second half
  bool moved = false;   // dynamics has begun
  std::string failure;  // why the run stops there, if it does
};
// Runs statics and dynamics until they have spent that many CPU s, a step of each at least. On one rank: each
// looks at its own clock. look: at the equilibrium and after every step.
TrialRun trial_run(Simulation& sim, const model::Case& c, double budget,
                   const std::function<void(const Kinematics&)>& look = {});

// CPU s
double expected_cost(const TrialRun& trial);
// "expected cost: about 12 CPU s, by its first 3.2 of 400 s"
std::string cost_sentence(const TrialRun& trial);

// "expected results: about 24 MB (fields 18, histories 4, ...)", and a note below it where that is much or
// more than the disk of the folder has left.
std::string size_sentence(const io::ResultsSize& size, const std::string& folder);

// Bytes: the most that this process has had in memory so far, and what it has.
double peak_memory();
double memory_now();
// Bytes on one rank: the most by the time that the files were read; what every rank of several keeps of all
// lines (the case, the mesh, its owners); and the most in trial_run() with all of that.
struct MemoryUse {
  double read = 0, shared = 0, measured = 0;
  bool moved = true;  // as in TrialRun
};
// "expected memory: about 0.9 GB", or of the rank with most of the work, a share of all; 1: there is one
// rank.
std::string memory_sentence(const MemoryUse& use, double most_of_work);

}  // namespace hawser::run
