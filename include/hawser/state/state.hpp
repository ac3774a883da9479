// Position, velocity and acceleration of this rank's nodes as owned arrays, and the retraction.
#pragma once

#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

// By local node including ghosts; see kinematics.hpp for the quantities.
struct State {
  double time = 0;              // s
  std::vector<Vec3> x, v, a;    // m, m/s, m/s², space axes
  std::vector<Quat> q;          // rotation from node axes to space axes
  std::vector<Vec3> w, alpha;   // rad/s, rad/s², node axes
  std::vector<Mat3> directors;  // accelerations of the node axes; empty outside time integration
  double director_weight = 0;
  StepMean mean;

  explicit State(int nodes = 0) { resize(nodes); }
  void resize(int nodes) {
    const size_t n = nodes;
    for (auto* s : {&x, &v, &a, &w, &alpha}) s->assign(n, Vec3::Zero());
    q.assign(n, Quat::Identity());
    directors.clear();
  }
  // As a state of statics, at the start of the motion with a first step of h [s], and at the end of a step of
  // h.
  Kinematics at_rest() const { return view(0, Phase::statics); }
  Kinematics at_start(double h) const { return view(h, Phase::start); }
  Kinematics after_step(double h) const { return view(h, Phase::step); }

 private:
  Kinematics view(double step, Phase phase) const {
    return {time, step, x, v, a, q, w, alpha, directors, director_weight, mean, phase};
  }
};

// to = x + u_x, R exp(u_theta): the configuration of `from` moved by the local block vector u[3 * blocks],
// including ghosts.
void retract(const LocalMesh& mesh, const State& from, const double* u, State& to);

// `from` with the constant velocities v, w that lead to `to` in the time h [s]: x + h v, R exp(h w).
State straight_path(const LocalMesh& mesh, const State& from, const State& to, double h);

}  // namespace hawser
