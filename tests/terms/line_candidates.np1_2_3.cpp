// Candidate pairs of elements: no touching pair is missing from the list, and the list, the forces and the
// motion are the same on any number of ranks, in statics and in dynamics.
#include <algorithm>

#include "hawser/mesh/partition.hpp"
#include "hawser/run/node_owners.hpp"
#include "support/tangle.hpp"
#include "support/taylor.hpp"

namespace hawser::test::line_candidates {
namespace {

struct Model {
  // places: shared by two ends, given by the nodes of these ends.
  Model(MPI_Comm comm, const model::Case& c, double radius, double stiffness, CandidateSettings settings = {},
        std::vector<SharedPlace> places = {})
      : sim(comm, c), shared(comm, sim.local(), ContactRadii({radius, radius}), std::move(places), {}) {
    settings.shared = &shared;
    auto term = std::make_unique<MiddleSprings>(comm, sim.local(), radius, stiffness, std::move(settings));
    springs = term.get();
    sim.system().add(std::move(term));
  }
  // Pairs of mesh elements in the list of this rank.
  std::vector<std::pair<int, int>> pairs(bool counted = false) const {
    std::vector<std::pair<int, int>> out;
    for (const CandidatePair& p : springs->list.pairs())
      if (p.counted || !counted)
        out.emplace_back(springs->list.segments()[static_cast<size_t>(p.a)].global,
                         springs->list.segments()[static_cast<size_t>(p.b)].global);
    return out;
  }
  run::Simulation sim;
  SharedPlaces shared;
  MiddleSprings* springs = nullptr;
};

long sum(long x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_LONG, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}

// Points on the axis of an element: Hermite's cubic for a beam.
std::vector<Vec3> points(const Mesh& mesh, const State& s, int element) {
  const Element& e = mesh.element(static_cast<size_t>(element));
  const size_t i = static_cast<size_t>(e.first);
  const size_t j = static_cast<size_t>(e.second);
  std::vector<Vec3> out;
  constexpr int kPoints = 12;
  for (int k = 0; k <= kPoints; ++k) {
    const double z = 1.0 * k / kPoints;
    const double z2 = z * z;
    const double z3 = z2 * z;
    if (!e.beam) {
      out.push_back((1 - z) * s.x[i] + z * s.x[j]);
      continue;
    }
    out.push_back((1 - 3 * z2 + 2 * z3) * s.x[i] + (3 * z2 - 2 * z3) * s.x[j] +
                  e.length *
                      ((z - 2 * z2 + z3) * (s.q[i] * Vec3::UnitX()) + (z3 - z2) * (s.q[j] * Vec3::UnitX())));
  }
  return out;
}

double nearest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double best = 1e30;
  for (const Vec3& p : a)
    for (const Vec3& q : b) best = std::min(best, (p - q).norm());
  return best;
}

// A step of a random motion, the same on every rank, which follows the prediction from the rates only
// approximately.
void move(const LocalMesh& l, State& s, int step, double h) {
  for (int n = 0; n < l.nodes(); ++n) {
    const size_t i = static_cast<size_t>(n);
    const int g = l.global[i];
    const Vec3 v = noise3(g, 3 * (step / 5)) + Vec3(3, 0, 0);
    s.x[i] += h * s.v[i] + 0.02 * h * noise3(g, 1000 + step);
    s.q[i] = (s.q[i] * exp_so3(h * s.w[i])).normalized();
    s.v[i] = v;
    if (l.rotates(n)) s.w[i] = noise3(g, 2000 + step / 5);
  }
  s.time += h;
}

TEST(LineCandidates, NoneIsMissedAndRanksAgree) {
  const model::Case c = tangle(9, 14);
  const double radius = 0.25, h = 0.05;
  CandidateSettings settings;
  settings.exclusion_diameters = 3;
  settings.excluded = {{4, 1}, {2, 2}};
  const std::vector<SharedPlace> ends = {{{0}, {15}}};  // ends A of lines 0 and 1, although far apart
  Model all(PETSC_COMM_WORLD, c, radius, 1, settings, ends);
  Model one(PETSC_COMM_SELF, c, radius, 1, settings, ends);
  State& a = all.sim.state();
  State& b = one.sim.state();
  const Mesh& mesh = one.sim.mesh();
  const LocalMesh& l = all.sim.local();
  // The axes of beams are bent away from their chords.
  for (auto [mesh_of, s] : {std::pair(&l, &a), std::pair(&one.sim.local(), &b)})
    for (int n = 0; n < mesh_of->nodes(); ++n)
      if (mesh_of->rotates(n))
        s->q[static_cast<size_t>(n)] *= exp_so3(1.2 * noise3(mesh_of->global[static_cast<size_t>(n)], 99));
  const auto held = [](Model& m, int n) {
    const LocalMesh& mesh_of = m.sim.local();
    return m.sim.system().tied_nodes().held()[static_cast<size_t>(mesh_of.block[static_cast<size_t>(n)])];
  };
  long touching = 0, layout_changed = 0, listed = 0, kept = 0, held_ghosts = 0;
  for (int step = 0; step < 60; ++step) {
    const CouplingChange r = all.sim.system().update_couplings(a.after_step(h), h);
    one.sim.system().update_couplings(b.after_step(h), h);
    if (r == CouplingChange::layout_changed) {
      all.sim.system().update_ghosts(a);
      ++layout_changed;
    }
    ASSERT_EQ(a.x.size(), static_cast<size_t>(l.nodes()));
    for (size_t n = 0; n < a.x.size(); ++n) {
      const size_t g = static_cast<size_t>(l.global[n]);
      ASSERT_LT((a.x[n] - b.x[g]).norm() + (a.v[n] - b.v[g]).norm() + (a.w[n] - b.w[g]).norm(), 1e-13);
      ASSERT_LT((a.q[n].coeffs() - b.q[g].coeffs()).norm(), 1e-13);
      ASSERT_EQ(held(all, static_cast<int>(n)), held(one, static_cast<int>(g)));
      held_ghosts += static_cast<int>(n) >= l.element_ghosts_end && held(one, static_cast<int>(g)) != 0;
    }
    // The pairs of this rank are those pairs of the whole list of which it owns a node.
    auto list = one.pairs();
    const auto have = all.pairs();
    std::vector<std::pair<int, int>> expected;
    for (const auto& p : list) {
      bool mine = false;
      for (int e : {p.first, p.second}) {
        const Element& g = mesh.element(static_cast<size_t>(e));
        for (int n : {g.first, g.second}) mine |= l.find(n) >= 0 && l.find(n) < l.owned;
      }
      if (mine) expected.push_back(p);
    }
    ASSERT_EQ(have, expected) << "step " << step;
    EXPECT_EQ(sum(static_cast<long>(all.pairs(true).size())), static_cast<long>(list.size()));
    listed = std::max(listed, static_cast<long>(list.size()));

    // The end of the next step is covered: all touching pairs are in the list.
    move(l, a, step, h);
    move(one.sim.local(), b, step, h);
    const bool covered = all.sim.system().check_step(a.after_step(h)).accepted();
    kept += covered;
    if (!covered) continue;
    std::vector<std::vector<Vec3>> axes;
    for (int e = 0; e < mesh.elements(); ++e) axes.push_back(points(mesh, b, e));
    for (int e = 0; e < static_cast<int>(axes.size()); ++e)
      for (int o = e + 1; o < static_cast<int>(axes.size()); ++o) {
        const Element& p = mesh.element(static_cast<size_t>(e));
        const Element& q = mesh.element(static_cast<size_t>(o));
        const bool never = (p.line == 1 && q.line == 4) || (p.line == 2 && q.line == 2) ||
                           (p.line == q.line && o - e - 1 < 1.5) ||
                           (p.line == 0 && q.line == 1 && e + (o - 14) < 1.5);
        const bool in = std::binary_search(list.begin(), list.end(), std::pair(e, o));
        if (never) {
          EXPECT_FALSE(in) << e << " and " << o;
        } else if (nearest(axes[static_cast<size_t>(e)], axes[static_cast<size_t>(o)]) <= 2 * radius) {
          ++touching;
          EXPECT_TRUE(in) << e << " and " << o << ", step " << step;
        }
      }
  }
  int size = 1;
  MPI_Comm_size(PETSC_COMM_WORLD, &size);
  if (size > 1) {
    EXPECT_GT(sum(held_ghosts), 0);
  }
  EXPECT_GT(touching, 500);
  EXPECT_GT(kept, 50);
  EXPECT_GT(layout_changed, 2);
  EXPECT_LT(listed * 2, static_cast<long>(mesh.elements()) * mesh.elements() / 4);
  const long builds = all.springs->list.builds();
  EXPECT_EQ(builds, one.springs->list.builds());
  EXPECT_GT(builds, 3);
  EXPECT_LT(builds, 40);  // a list is valid for several steps
}

// Without skins and motion the list is the tightest possible: pairs of bent axes are still in it.
TEST(LineCandidates, BentAxes) {
  const model::Case c = tangle(10, 14);
  CandidateSettings settings;
  settings.skin_diameters = settings.skin_lengths = 0;
  Model m(PETSC_COMM_SELF, c, 0.1, 1, settings);
  State& s = m.sim.state();
  const Mesh& mesh = m.sim.mesh();
  int touching = 0;
  for (int trial = 0; trial < 10; ++trial) {
    for (size_t n = 0; n < s.q.size(); ++n) {
      s.x[n] += 0.3 * noise3(static_cast<int>(n), 200 + trial);
      if (mesh.node(n).rotates) s.q[n] *= exp_so3(1.5 * noise3(static_cast<int>(n), 100 + trial));
    }
    m.sim.system().update_couplings(s.at_rest(), 0);
    const auto list = m.pairs();
    std::vector<std::vector<Vec3>> axes;
    for (int e = 0; e < mesh.elements(); ++e) axes.push_back(points(mesh, s, e));
    for (int e = 0; e < static_cast<int>(axes.size()); ++e)
      for (int o = e + 1; o < static_cast<int>(axes.size()); ++o) {
        if (mesh.element(static_cast<size_t>(e)).line == mesh.element(static_cast<size_t>(o)).line) continue;
        if (nearest(axes[static_cast<size_t>(e)], axes[static_cast<size_t>(o)]) > 0.2) continue;
        ++touching;
        EXPECT_TRUE(std::binary_search(list.begin(), list.end(), std::pair(e, o))) << e << " and " << o;
      }
    EXPECT_LT(list.size(), 300u);
  }
  EXPECT_GT(touching, 100);
}

// Four lines in two bundles, alternately in the file: the partition puts the two lines of a bundle on one
// rank, because the pairs of their nodes are couplings.
TEST(LineCandidates, BundlesStayOnOneRank) {
  model::Case c = one_line(cable_type(1e6, 1), 10, 40, anchor({0, 0, 0}), anchor({10, 0, 0}));
  for (int i = 1; i < 4; ++i) c.lines.push_back(c.lines[0]);
  for (int i = 0; i < 4; ++i) {
    model::Line& l = c.lines[static_cast<size_t>(i)];
    l.name += std::to_string(i);
    const double y = i % 2 * 50 + i / 2 * 0.12;
    l.end_a.at.y() = l.end_b.at.y() = y;
  }
  const run::Simulation one(PETSC_COMM_SELF, c);
  const Mesh& mesh = one.mesh();
  const auto coupled = run::coupled_nodes(PETSC_COMM_SELF, c, mesh, one.bodies());
  EXPECT_EQ(run::coupled_nodes(PETSC_COMM_WORLD, c, mesh, one.bodies()), coupled);
  EXPECT_GT(coupled.size(), 320u);
  const NodeRanks owner = partition(mesh, 2, coupled);
  EXPECT_EQ(cut_elements(mesh, owner), 0);
  for (size_t n = 0; n < 82; ++n) EXPECT_EQ(owner[n], owner[n + 82]) << n;
  EXPECT_NE(owner[0], owner[41]);
}

// Two lines from one anchor: near it, the pairs of their elements are not contact pairs.
TEST(LineCandidates, JoinedEnds) {
  model::Case c = one_line(cable_type(1e6, 1), 10, 20, anchor({0, 0, 0}), anchor({10, 0, 0}));
  c.lines.push_back(c.lines[0]);
  c.lines[1].name = "other";
  c.lines[1].end_b = anchor({9.9, 1, 0});
  CandidateSettings settings;
  Model apart(PETSC_COMM_SELF, c, 0.2, 1, settings);
  Model joined(PETSC_COMM_SELF, c, 0.2, 1, settings, {{{0}, {21}}});
  for (Model* m : {&apart, &joined}) m->sim.system().update_couplings(m->sim.state().at_rest(), 0);
  const auto has = [](const Model& m, int a, int b) {
    const auto p = m.pairs();
    return std::binary_search(p.begin(), p.end(), std::pair(a, b));
  };
  EXPECT_TRUE(has(apart, 0, 20));
  EXPECT_FALSE(has(joined, 0, 20));
  EXPECT_TRUE(has(joined, 1, 21));  // 1 m apart along the lines through the anchor, more than two diameters
}

TEST(LineCandidates, NothingToDoForOneStraightLine) {
  model::Case c = one_line(cable_type(1e6, 1), 100, 50, anchor({0, 0, 0}), anchor({100, 0, 0}));
  Model m(PETSC_COMM_WORLD, c, 0.3, 1);
  State& s = m.sim.state();
  EXPECT_NE(m.sim.system().update_couplings(s.at_start(0.1), 0.1), CouplingChange::layout_changed);
  EXPECT_EQ(sum(static_cast<long>(m.pairs().size())), 0);
  EXPECT_FALSE(m.sim.system().coupled());
}

// Two parallel lines move sideways together, so their list has no pairs. When the first line stops within the
// predicted path, the second reaches it: the list is rejected and the new list contains the pairs.
TEST(LineCandidates, OneStopsTheNextComesOn) {
  model::Case c = one_line(cable_type(1e6, 1), 10, 10, anchor({0, 0, 0}), anchor({10, 0, 0}));
  c.lines.push_back(c.lines[0]);
  c.lines[1].name = "behind";
  for (model::End* e : {&c.lines[1].end_a, &c.lines[1].end_b}) e->at.y() = -1;
  const double radius = 0.1, h = 0.1;
  for (const bool stops : {false, true}) {
    Model m(PETSC_COMM_WORLD, c, radius, 1);
    State& s = m.sim.state();
    const LocalMesh& l = m.sim.local();
    const auto first = [&](size_t n) { return l.global[n] < 11; };
    for (Vec3& v : s.v) v = Vec3(0, 4, 0);
    m.sim.system().update_couplings(s.after_step(h), h);
    EXPECT_EQ(sum(static_cast<long>(m.pairs().size())), 0);
    bool predicted = true;
    for (int step = 0; step < 2 && predicted; ++step) {
      // After the first step the first line does not move.
      for (size_t n = 0; n < s.x.size(); ++n) s.x[n].y() += stops && step > 0 && first(n) ? 0 : 0.4;
      s.time += h;
      predicted = m.sim.system().check_step(s.after_step(h)).accepted();
    }
    EXPECT_EQ(predicted, !stops);
    for (size_t n = 0; n < s.v.size(); ++n)
      if (stops && first(n)) s.v[n] = Vec3::Zero();
    m.sim.system().update_couplings(s.after_step(h), h);
    EXPECT_EQ(sum(static_cast<long>(m.pairs(true).size())) >= 10, stops);
  }
}

// The same in statics, where no time passes: the first step moves both lines to its end, then the first line
// goes back. Both lines are on the predicted path, but at different places of it.
TEST(LineCandidates, OneGoesBackInStatics) {
  model::Case c = one_line(cable_type(1e6, 1), 10, 10, anchor({0, 0, 0}), anchor({10, 0, 0}));
  c.lines.push_back(c.lines[0]);
  c.lines[1].name = "behind";
  for (model::End* e : {&c.lines[1].end_a, &c.lines[1].end_b}) e->at.y() = -1;
  for (const bool back : {false, true}) {
    Model m(PETSC_COMM_WORLD, c, 0.1, 1);
    System& system = m.sim.system();
    State& s = m.sim.state();
    const LocalMesh& l = m.sim.local();
    system.update_couplings(s.at_rest(), 0);
    State to = s;
    for (Vec3& x : to.x) x.y() += 1;
    EXPECT_FALSE(system.check_step(to.at_rest()).accepted());
    system.update_couplings(straight_path(l, s, to, 1).at_rest(), 1 / CandidateSettings{}.steps);
    EXPECT_EQ(sum(static_cast<long>(m.pairs().size())), 0);
    EXPECT_TRUE(system.check_step(to.at_rest()).accepted());
    // The next iteration starts at this place or, if the step was rejected, at its old place: the list
    // remains valid.
    const long builds = m.springs->list.builds();
    for (const State* at : {&to, &s, &to}) system.update_couplings(at->at_rest(), 0);
    EXPECT_EQ(m.springs->list.builds(), builds);
    State next = to;
    for (size_t n = 0; n < next.x.size(); ++n)
      if (back && l.global[n] < 11) next.x[n].y() -= 1;
    EXPECT_EQ(system.check_step(next.at_rest()).accepted(), !back);
    EXPECT_EQ(system.check_step(next.at_rest()).kind == Verdict::Kind::prepare_again, back);
    system.update_couplings(straight_path(l, to, next, 1).at_rest(), 1 / CandidateSettings{}.steps);
    EXPECT_EQ(sum(static_cast<long>(m.pairs(true).size())) >= 10, back);
  }
}

// A line rotates about its end with few steps in a turn: its curved path leaves the skin within one step, and
// its list is still valid.
TEST(LineCandidates, WayThatBends) {
  const model::Case c = one_line(beam_type(1e6, 1, 1, 1), 10, 10, clamp(Vec3::Zero(), Vec3::UnitX()), {});
  Model m(PETSC_COMM_WORLD, c, 0.02, 1);
  State& s = m.sim.state();
  const LocalMesh& l = m.sim.local();
  const double rate = 6, h = 0.04;  // a quarter of a radian in a step
  const auto turn = [&](double t) {
    const Quat q = exp_so3(rate * t * Vec3::UnitZ());
    for (size_t n = 0; n < s.x.size(); ++n) {
      const Vec3 arm(l.mesh->node(static_cast<size_t>(l.global[n])).arc, 0, 0);
      s.x[n] = q * arm;
      s.q[n] = q;
      s.w[n] = rate * Vec3::UnitZ();
      s.alpha[n] = Vec3::Zero();
      s.v[n] = q * (rate * Vec3::UnitZ().cross(arm));
      s.a[n] = -rate * rate * s.x[n];
    }
    s.time = t;
  };
  turn(0);
  for (int step = 1; step <= 25; ++step) {
    m.sim.system().update_couplings(s.after_step(h), h);
    turn(step * h);
    EXPECT_TRUE(m.sim.system().check_step(s.after_step(h)).accepted()) << step;
  }
}

// Forces, and the product of the tangent with a vector, equal those on one rank.
TEST(LineCandidates, ResidualAndTangent) {
  const model::Case c = tangle(6, 12);
  Model all(PETSC_COMM_WORLD, c, 0.6, 100);
  Model one(PETSC_COMM_SELF, c, 0.6, 100);
  std::vector<std::vector<double>> r(2), y(2);
  double energy[2];
  for (int i = 0; i < 2; ++i) {
    Model& m = i == 0 ? all : one;
    System& system = m.sim.system();
    State& s = m.sim.state();
    const LocalMesh& l = m.sim.local();
    for (int step = 0; step < 8; ++step) {
      if (system.update_couplings(s.after_step(0.1), 0.1) == CouplingChange::layout_changed)
        system.update_ghosts(s);
      system.prepare(s.after_step(0.1), 0.1);
      if (step < 7) move(l, s, step, 0.1);
    }
    energy[i] = m.springs->energy(s.after_step(0.1)).strain;
    VecHandle f = system.create_vector();
    VecHandle w = system.create_vector();
    VecHandle Jw = system.create_vector();
    MatHandle J = system.create_matrix();
    system.residual(s.after_step(0.1), f.get());
    const std::vector<double> zero(3 * static_cast<size_t>(l.blocks()), 0);
    system.tangent(s.after_step(0.1), {1, 0, 2, 0, 0}, zero, false, J.get());
    PetscScalar* p = nullptr;
    check(VecGetArray(w.get(), &p));
    for (int n = 0; n < l.owned; ++n)
      for (int b = 0; b <= l.rotates(n); ++b)
        Eigen::Map<Vec3>(p + 3 * (l.block[static_cast<size_t>(n)] + b)) =
            noise3(l.global[static_cast<size_t>(n)], 50 + b);
    check(VecRestoreArray(w.get(), &p));
    check(MatMult(J.get(), w.get(), Jw.get()));
    for (auto [from, to] :
         {std::pair(f.get(), &r[static_cast<size_t>(i)]), {Jw.get(), &y[static_cast<size_t>(i)]}}) {
      const PetscScalar* q = nullptr;
      check(VecGetArrayRead(from, &q));
      to->assign(q, q + 3 * l.owned_blocks);
      check(VecRestoreArrayRead(from, &q));
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, energy, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_GT(energy[1], 1);
  EXPECT_NEAR(energy[0], energy[1], 1e-12 * energy[1]);
  const LocalMesh& l = all.sim.local();
  const LocalMesh& g = one.sim.local();
  const double sizes[2] = {Eigen::Map<Eigen::VectorXd>(r[1].data(), static_cast<long>(r[1].size())).norm(),
                           Eigen::Map<Eigen::VectorXd>(y[1].data(), static_cast<long>(y[1].size())).norm()};
  for (int n = 0; n < l.owned; ++n)
    for (int k = 0; k < 3 * (1 + l.rotates(n)); ++k) {
      const size_t i = static_cast<size_t>(3 * l.block[static_cast<size_t>(n)] + k);
      const size_t j =
          static_cast<size_t>(3 * g.block[static_cast<size_t>(l.global[static_cast<size_t>(n)])] + k);
      EXPECT_NEAR(r[0][i], r[1][j], 1e-13 * sizes[0]);
      EXPECT_NEAR(y[0][i], y[1][j], 1e-13 * sizes[1]);
    }
}

// Compares node positions with those on one rank.
void expect_same(Model& all, const State& a, const State& b, double tolerance) {
  const LocalMesh& l = all.sim.local();
  double worst = 0;
  for (size_t n = 0; n < a.x.size(); ++n)
    worst = std::max(worst, (a.x[n] - b.x[static_cast<size_t>(l.global[n])]).norm());
  EXPECT_LT(worst, tolerance);
}

// A bundle of lines is thrown across another: pairs appear and disappear, and some steps are rejected.
model::Case two_bundles() {
  model::Case c = tangle(0, 0);
  for (int i = 0; i < 6; ++i) {
    model::Line l;
    l.name = "line" + std::to_string(i);
    const bool across = i >= 3;
    l.sections.push_back({c.line_types[static_cast<size_t>(i % 2)].name, 10, 20, 1});
    const double at = i % 3 - 1;
    l.end_a = anchor(across ? Vec3(at, -5, 0.8) : Vec3(-5, at, 0));
    l.end_b = anchor(across ? Vec3(at, 5, 0.8) : Vec3(5, at, 0));
    l.start = model::Start::straight;
    c.lines.push_back(l);
  }
  c.dynamics.step = 0.01;
  return c;
}

TEST(LineCandidates, DynamicsWithARefusedStep) {
  const model::Case c = two_bundles();
  Model all(PETSC_COMM_WORLD, c, 0.2, 2e3);
  Model one(PETSC_COMM_SELF, c, 0.2, 2e3);
  long layouts = 0;
  int rejected = 0;
  for (Model* m : {&all, &one}) {
    m->springs->refuse = 0.008;
    m->springs->refuse_from = 0.1;
    m->springs->refuse_to = 0.12;
    const LocalMesh& l = m->sim.local();
    State& s = m->sim.state();
    for (int n = 0; n < l.nodes(); ++n) {
      const Node& node = l.mesh->node(static_cast<size_t>(l.global[static_cast<size_t>(n)]));
      if (node.line >= 3) s.v[static_cast<size_t>(n)].z() = -4 * std::sin(M_PI * node.arc / 10);
    }
    Dynamics& d = m->sim.dynamics();
    d.start(s);
    int blocks = l.blocks();
    rejected = 0;
    d.run(
        1, [](double) { return 2.0; },
        [&](const StepInfo& info) {
          rejected += info.rejected;
          layouts += l.blocks() != blocks;
          blocks = l.blocks();
          return true;
        });
  }
  EXPECT_GT(rejected, 0);
  int size = 1;
  MPI_Comm_size(PETSC_COMM_WORLD, &size);
  if (size > 1) {
    EXPECT_GT(sum(layouts), 1);
  }
  EXPECT_GT(one.springs->located, 3);
  expect_same(all, all.sim.dynamics().committed().s, one.sim.dynamics().committed().s, 1e-9);
}

// The upper bundle comes to rest on the lower bundle, and both hang.
TEST(LineCandidates, Statics) {
  model::Case c = two_bundles();
  c.environment.gravity = 9.81;
  for (auto& t : c.line_types) {
    t.mass_per_length = 50;
    t.EA = 2e4;
  }
  for (auto& l : c.lines) {
    l.start = model::Start::catenary;
    l.sections[0].length = l.name > "line2" ? 10.3 : 10.1;
  }
  Model all(PETSC_COMM_WORLD, c, 0.45, 1e4);
  Model one(PETSC_COMM_SELF, c, 0.45, 1e4);
  for (Model* m : {&all, &one}) EXPECT_LE(m->sim.solve_statics().negative_eigenvalues, 0);
  EXPECT_GT(one.springs->energy(one.sim.state().at_rest()).strain, 0.1);
  expect_same(all, all.sim.state(), one.sim.state(), 1e-8);
}

}  // namespace
}  // namespace hawser::test::line_candidates
