// What happens during a run: ends of lines that let go at a time or a tension.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/app/end_forces.hpp"
#include "hawser/app/simulation.hpp"
#include "hawser/io/checkpoint.hpp"

namespace hawser::app {

class Events {
 public:
  // Steps of the simulation will end where a tension is reached.
  Events(MPI_Comm comm, Simulation& simulation);

  // Before a run starts from the simulation's state: ends that are released at t = 0 are free in it. What is
  // to be told, a sentence each; InputError where a tension is reached already. Collective.
  std::vector<std::string> begin();

  // After an accepted step, or when a run goes on: what happens there, likewise. Collective.
  std::vector<std::string> apply_due();

  // Of the end of a run: what has not happened, a sentence each.
  std::vector<std::string> not_happened() const;

  void save(io::Checkpoint& to) const;
  // What had happened by then, a sentence each; before the state is restored. InputError when what happened
  // and the events of the case contradict each other.
  std::vector<std::string> restore(const io::Checkpoint& from);

 private:
  struct Event {
    model::Release what;
    int node = -1;  // of the mesh
    std::string name;
    double happened = -1;  // s; < 0: not yet
  };
  // Effective tension at the end of each event [N], on all ranks.
  std::vector<double> tensions(const Kinematics& at);
  std::vector<double> functions(const Kinematics& at);  // for Dynamics::watch
  void refuse_reached(const std::vector<double>& pull) const;
  std::vector<std::string> release(const Kinematics& at, const std::vector<double>& pull);
  std::vector<Support> remaining_supports()
      const;  // of the supports there are, those of no event that has happened

  MPI_Comm comm_;
  Simulation& sim_;
  EndForces ends_;
  std::vector<Event> events_;
};

}  // namespace hawser::app
