// Models of contact between lines: the two lines of the suite, one of three beams and one of three cables,
// cross each other or lie on each other, with one step of history.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "hawser/terms/line_pairs.hpp"
#include "support/taylor_model.hpp"

namespace hawser::test {

struct PairCase {
  std::string name;
  double angle = 0;   // between the lines
  double gap = 0;     // m, between the surfaces in the trial
  double before = 0;  // m, between the surfaces at the start of the step
  double slip = 0;    // m, of the first line in the step
  double friction = 0;
  double shift = 0;                         // m, of the crossing point along the second line
  double radius = 0.1, other_radius = 0.1;  // m, of the first line and of the second
  bool tuned = false;                       // the law belongs to the pair, not to all pairs
  double reach() const { return radius + other_radius; }
};

inline std::vector<PairCase> pair_cases() {
  std::vector<PairCase> out;
  for (const double friction : {0.0, 0.3})
    for (const auto& [angle, name] : {std::pair{1.3, "crossing"}, {0.35, "oblique"}, {0.0, "parallel"}}) {
      const std::string what = std::string(name) + (friction > 0 ? ", rough" : ", smooth");
      out.push_back({what + ", open", angle, 0.01, 0.012, 1e-4, friction});
      out.push_back({what + ", ramp", angle, 5e-4, 4e-4, 1e-4, friction});
      out.push_back({what + ", pressed", angle, -6e-3, -5e-3, 1e-4, friction});
      out.push_back({what + ", slides", angle, -5e-3, -5e-3, 0.02, friction});
      if (angle > 0) out.push_back({what + ", sweeps", angle, -5e-3, -5e-3, 0.4, friction});
      out.push_back({what + ", first touch", angle, -4e-3, 0.01, 3e-4, friction});
      out.push_back({what + ", at a joint", angle, -5e-3, -5e-3, 1e-4, friction, 0.604});
      out.push_back({what + ", at an end", angle, -5e-3, -5e-3, 1e-4, friction, 1.795});
      if (friction == 0) continue;
      // Unequal shares of the two sides, and all of the force on the thinner line.
      for (const auto& [first, second] : {std::pair{0.1, 0.125}, {0.03, 0.12}, {0.12, 0.03}}) {
        const std::string radii = fmt::format(", radii {} and {}", first, second);
        out.push_back({what + ", pressed" + radii, angle, -5.4e-3, -4e-3, 1e-4, friction, 0, first, second});
        out.push_back({what + ", slides" + radii, angle, -4.4e-3, -4e-3, 0.02, friction, 0, first, second});
        out.push_back(
            {what + ", at a joint" + radii, angle, -5.3e-3, -4e-3, 1e-4, friction, 0.604, first, second});
      }
    }
  return out;
}

inline constexpr double kPairStiffness = 1e5;  // N/m²

struct PairModel : SuiteModel {
  LinePairs* contact = nullptr;

  explicit PairModel(const PairCase& what, MPI_Comm comm = PETSC_COMM_SELF, const Placement& at = {})
      : SuiteModel(comm, at) {
    LinePairOptions o;
    o.general.basis = model::StiffnessBasis::per_length;
    o.general.normal_stiffness = kPairStiffness;
    o.general.smoothing = 1e-3;
    o.general.relative_damping = 0.1;
    o.general.friction = what.friction;
    o.general.mobilisation_length = 4e-3;
    if (what.tuned) o.tuned[{0, 1}] = o.general;
    o.candidates.excluded = {{0, 0}, {1, 1}};
    std::vector<LinePairType> types = {{what.radius, 50}, {what.other_radius, 50}};
    auto term = std::make_unique<LinePairs>(comm, system->mesh(), std::move(types), o);
    contact = term.get();
    system->add(std::move(term));
    // First the ghosts: they depend on the positions of the lines.
    State before = place(what, at, -1);
    before.time = trial.from.time - trial.h;
    if (system->update_couplings(before.after_step(trial.h), trial.h) == CouplingChange::layout_changed)
      before = place(what, at, -1);
    before.time = trial.from.time - trial.h;
    const LocalMesh& l = system->mesh();
    trial.from = place(what, at, 0);
    trial.from.time = 1;
    const State end = place(what, at, 1);
    trial.rates = end;
    trial.u.assign(3 * static_cast<size_t>(l.blocks()), 0);
    for (int n = 0; n < l.nodes(); ++n) {
      const size_t i = static_cast<size_t>(n);
      double* u = trial.u.data() + 3 * l.block[i];
      Eigen::Map<Vec3>(u, 3) = end.x[i] - trial.from.x[i];
      if (l.rotates(n)) Eigen::Map<Vec3>(u + 3, 3) = log_so3(trial.from.q[i].conjugate() * end.q[i]);
    }
    system->prepare(before.after_step(trial.h), trial.h);
    system->commit(trial.from.after_step(trial.h));
    system->prepare(trial.from.after_step(trial.h), trial.h);
    trial.length = 2e-5;
    trial.angle = 2e-5;
  }

  // The lines before the step of history (-1), at the start of the trial (0) and in the trial (1).
  State place(const PairCase& what, const Placement& at, int stage) const {
    const LocalMesh& l = system->mesh();
    State s(l.nodes());
    const double gap = stage > 0 ? what.gap : what.before + (stage < 0 ? 1e-4 : 0.0);
    const double slip = stage > 0 ? what.slip : stage < 0 ? -2e-4 : 0.0;
    const Vec3 along(std::cos(what.angle), std::sin(what.angle), 0);
    for (int n = 0; n < l.nodes(); ++n) {
      const size_t i = static_cast<size_t>(n);
      const int g = l.global[i];
      Vec3 x = g < 4 ? Vec3(1.2 * g - 1.7 + slip, 0.013 + 0.7 * slip, what.reach() + gap)
                     : Vec3((1.2 * (g - 4) - 1.8 - what.shift) * along);
      x += 1e-3 * noise3(g, 1);
      x.z() -= 9e-4 * noise3(g, 1).z();
      s.x[i] = at.point(x);
      s.v[i] = at.rotation * (0.1 * noise3(g, 5));
      if (!l.rotates(n)) continue;
      s.q[i] = at.rotation * exp_so3(Vec3(0.4, 0, 0) + 2e-3 * noise3(g, 4) + 3e-3 * stage * noise3(g, 6));
      s.w[i] = 0.1 * noise3(g, 7);
    }
    return s;
  }
};

}  // namespace hawser::test
