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

  // At the start of a run. InputError where a tension is reached at rest already. Collective.
  void begin();

  // After an accepted step, or the start: what happens there, a sentence each. Collective.
  std::vector<std::string> happen();

  // Of the end of a run: what has not happened, a sentence each.
  std::vector<std::string> missed() const;

  void save(io::Checkpoint& to) const;
  // What had happened by then; before the state is restored. InputError when an event of the case would have
  // happened by then and had not.
  void restore(const io::Checkpoint& from);

 private:
  struct Event {
    model::Release what;
    int node = -1;  // of the mesh
    std::string name;
    double happened = -1;  // s; < 0: not yet
  };
  // Effective tension at the end of each event [N], on all ranks.
  std::vector<double> tensions(const Kinematics& at);
  bool beyond(const Kinematics& trial);
  std::vector<Support> left() const;  // of the supports there are, those of no event that has happened

  MPI_Comm comm_;
  Simulation& sim_;
  EndForces ends_;
  std::vector<Event> events_;
};

}  // namespace hawser::app
