// Events of a run, triggered by time, a condition or another event, and of stages of statics
// (docs/theory/events.md).
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

  // Statics of the case in its stages, or in one step without stages. `solve` finds an equilibrium from the
  // previous one. `report` receives the events of each stage, one sentence each; `rested` is called with the
  // index of each stage after its equilibrium. Throws SolveError if a stage cannot begin. Collective.
  void solve_stages(
      const std::function<void(StartsFrom)>& solve,
      const std::function<void(const std::string&)>& report = [](const std::string&) {},
      const std::function<void(size_t)>& rested = [](size_t) {});

  // Before the first step: performs events at t = 0 and sets up conditions at which steps end. Returns
  // messages, one sentence each. Throws InputError if a condition is already met. Collective.
  std::vector<std::string> begin();

  // After an accepted step or at a restart: performs the events that are due. Returns messages. Collective.
  std::vector<std::string> apply_due();

  // Time [s] of the next event that is due at a time or after another one; infinite: none.
  double next(double time) const;

  // Messages about events that did not happen by the end of the run.
  std::vector<std::string> not_happened() const;

  void save(io::Checkpoint& to) const;
  // True if the case has all events that happened before the checkpoint.
  static bool has_all_of(const io::Checkpoint& from, const model::Case& c);
  // Messages about events that had happened; called before the state is restored. Throws InputError if they
  // contradict the events of the case.
  std::vector<std::string> restore(const io::Checkpoint& from);

 private:
  struct ScheduledEvent {
    model::Event event;
    int node = -1;         // node of the mesh whose tension, position or distance is monitored
    int feeder = -1;       // feeder whose length is monitored
    int after = -1;        // index of the preceding event
    double happened = -1;  // s; < 0: not yet
    double order = 0;      // number of events before it
    Actions::Found placed;
  };
  static bool waits_for_condition(const ScheduledEvent& scheduled);
  double due(const ScheduledEvent& scheduled) const;  // s; infinite: unknown
  // Monitored tensions [N], positions, lengths and distances [m], the same on all ranks.
  std::vector<double> values(const Kinematics& state);
  double local_value(const ScheduledEvent& scheduled, const Kinematics& state) const;
  double local_tension(int node) const;
  // Excess of each waiting event's value over its condition, in units of its tolerance; >= 0: met.
  std::vector<double> conditions(const std::vector<double>& values) const;
  void refuse_conditions_met(const std::vector<double>& values) const;
  void watch();
  // Events due at a time with these values, or that begin a stage.
  std::vector<size_t> due_at(double time, const std::vector<double>& values, const std::string& stage) const;
  // Performs these events and then calls go_on(). If one of them is impossible, none has happened.
  void execute(const std::vector<size_t>& now, const Kinematics& state, const std::string& stage,
               std::vector<std::string>& messages, const std::function<void()>& go_on);
  // Performs and reports one event, without changing the system's tied nodes.
  void execute(size_t event, const Kinematics& state, const std::string& stage,
               std::vector<std::string>& messages);
  std::vector<std::string> at_rest(const std::string& stage);
  bool releases_end(const std::string& stage) const;
  void pay_out(const std::string& stage, const std::function<void(StartsFrom)>& solve);

  MPI_Comm comm_;
  Simulation& sim_;
  record::EndForces ends_;
  Actions actions_;
  std::vector<ScheduledEvent> events_;
};

}  // namespace hawser::run
