// What happens during a run: at a time, when a condition is met, or after something else;
// and what stages of statics begin with (docs/theory/events.md).
#pragma once

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/run/actions.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

class Events {
 public:
  Events(MPI_Comm comm, Simulation& simulation);

  // Statics of the case: its stages one after another, or all at once where it has none. `solve` finds a
  // rest, from the one before, given whether something was released that has to fall first; `report` gets
  // what begins each stage, a sentence each; `rested` which stage, by its place, has come to rest. SolveError
  // where a stage cannot begin. Collective.
  void come_to_rest(
      const std::function<void(bool falls)>& solve,
      const std::function<void(const std::string&)>& report = [](const std::string&) {},
      const std::function<void(size_t)>& rested = [](size_t) {});

  // Before a run starts from the simulation's state: what happens at t = 0 has happened in it, and steps will
  // end where a condition is met. Messages for the user, a sentence each; InputError where one is met
  // already. Collective.
  std::vector<std::string> begin();

  // After an accepted step, or when a run goes on: what happens there, likewise. Collective.
  std::vector<std::string> apply_due();

  // s: when something happens after another event that has happened; infinite: nothing does.
  double next(double time) const;

  // Of the end of a run: what has not happened, a sentence each.
  std::vector<std::string> not_happened() const;

  void save(io::Checkpoint& to) const;
  // What had happened by then, a sentence each; before the state is restored. InputError when what happened
  // and the events of the case contradict each other.
  std::vector<std::string> restore(const io::Checkpoint& from);

 private:
  struct Happening {
    model::Event what;
    int node = -1;         // of the mesh: whose tension, place or distance is waited for
    int feeder = -1;       // whose length is
    int after = -1;        // event
    double happened = -1;  // s; < 0: not yet
    double order = 0;      // how many had happened before it
    Actions::Found found;
  };
  static bool waits_for_condition(const Happening& h);
  double due(const Happening& h) const;  // s; infinite: not known
  // Tensions [N], positions, lengths and distances [m] that are waited for, on all ranks.
  std::vector<double> values(const Kinematics& at);
  double local_value(const Happening& h, const Kinematics& at) const;
  double local_tension(int node) const;
  // Of each event that waits for a condition what it lacks, in units of its tolerance, 0 and above: met.
  std::vector<double> conditions(const std::vector<double>& values) const;
  void refuse_met(const std::vector<double>& values) const;
  void watch();
  // Which are due at a time and these values, or begin a stage.
  std::vector<size_t> due_at(double time, const std::vector<double>& values, const std::string& stage) const;
  // All of these, with what goes on from there. Where one of them cannot be, none has happened.
  void happen(const std::vector<size_t>& now, const Kinematics& at, const std::string& stage,
              std::vector<std::string>& messages, const std::function<void()>& go_on);
  // One of them, done and reported; the system's tied nodes are not changed yet.
  void happen(size_t event, const Kinematics& at, const std::string& stage,
              std::vector<std::string>& messages);
  std::vector<std::string> at_rest(const std::string& stage);
  bool releases_end(const std::string& stage) const;
  void pay_out(const std::string& stage, const std::function<void(bool)>& solve);

  MPI_Comm comm_;
  Simulation& sim_;
  record::EndForces ends_;
  Actions actions_;
  std::vector<Happening> events_;
};

}  // namespace hawser::run
