// Forces that lines exert at their ends, from case file to results file: bridles against the elastic
// catenary, a clump weight, a cantilever. The same on one rank and on two.
#include <fmt/format.h>

#include "../regression/runs.hpp"
#include "hawser/kernels/catenary.hpp"

namespace hawser::test::end_forces_test {
namespace {

constexpr double kGravity = 9.80665;

runs::Results run(const std::string& name, const std::string& text, const runs::Edits& edits = {}) {
  const std::string base = runs::folder("end_forces") + "/" + name;
  runs::write_case(base + ".yaml", text, edits);
  runs::run_on_all({base + ".yaml", base + ".h5"});
  return runs::read(base + ".h5");
}

// ends/<field> of an end (2 l: end A of line l; 2 l + 1: its end B) at an output.
Vec3 at_end(const std::string& name, const std::string& field, size_t output, size_t end) {
  const auto file = io::h5::open_read(runs::folder("end_forces") + "/" + name + ".h5");
  const auto a = io::h5::read_array(file, "ends/" + field);
  EXPECT_EQ(a.shape.size(), 3u);
  return Eigen::Map<const Vec3>(a.values.data() + (output * a.shape[1] + end) * 3);
}

struct Leg {
  Vec3 anchor;
  double length, mass, EA;
};
const Leg kLegs[] = {{{-40, -30, 0}, 58, 20, 4e7}, {{-40, 35, 5}, 62, 12, 2e7}, {{70, 0, 12}, 88, 30, 5e7}};

std::string bridle(const std::string& more) {
  std::string types, lines;
  for (size_t i = 0; i < 3; ++i) {
    const Leg& l = kLegs[i];
    types += fmt::format("  type{}: {{outer_diameter: 0.05, mass_per_length: {}, EA: {}, bending: false}}\n",
                         i, l.mass, l.EA);
    // Leg 0 starts at the joint, the others end there.
    const std::string held =
        i ? fmt::format("anchor: [{}, {}, {}]", l.anchor.x(), l.anchor.y(), l.anchor.z())
          : fmt::format("body: ship, at: [{}, {}, {}]", l.anchor.x(), l.anchor.y(), l.anchor.z());
    lines += fmt::format(
        "  leg{}:\n    sections: [{{type: type{}, length: {}, elements: 40}}]\n    {}: {{joint: knot}}\n"
        "    {}: {{{}}}\n",
        i, i, l.length, i ? "end_b" : "end_a", i ? "end_a" : "end_b", held);
    if (i == 0) lines += more;
  }
  return "hawser: 1\nbodies: {ship: {motion: {harmonic: {amplitude: [1, 0, 0.5], period: 6}, ramp: 3}}}\n"
         "joints: {knot: {start: [0, 0, -30]}}\nline_types:\n" +
         types + "lines:\n" + lines +
         "contact: {between_lines: false}\n"
         "dynamics: {duration: 3, step: 0.02}\n"
         "output: {every: 0.5, histories: [{name: knot, line: leg0, at: end_a}, {name: far, line: leg0, at: "
         "end_b}]}\n";
}

// Force of the legs on the joint at x, and their tensions there and at the anchors.
struct Pull {
  Vec3 sum = Vec3::Zero(), at_joint[3], at_anchor[3];
};
Pull pull(const Vec3& x) {
  Pull p;
  for (size_t i = 0; i < 3; ++i) {
    const Leg& l = kLegs[i];
    const CatenaryShape s =
        catenary(x, l.anchor, {{l.length, Vec3(0, 0, -l.mass * kGravity), l.EA, Vec3::Zero()}});
    p.at_joint[i] = s.tension_a();
    p.at_anchor[i] = -s.tension_b();
    p.sum += p.at_joint[i];
  }
  return p;
}

// Equilibrium position of the joint under a load: damped Newton iteration with a difference quotient.
Vec3 at_rest(const Vec3& load) {
  Vec3 x(0, 0, -30);
  for (int i = 0; i < 200; ++i) {
    const Vec3 r = pull(x).sum + load;
    Mat3 K;
    for (int c = 0; c < 3; ++c) K.col(c) = (pull(x + 1e-4 * Vec3::Unit(c)).sum + load - r) / 1e-4;
    Vec3 d = -K.inverse() * r;
    if (d.norm() > 1) d.normalize();
    x += d;
    if (d.norm() < 1e-10) break;
  }
  EXPECT_LT((pull(x).sum + load).norm(), 1e-5);
  return x;
}

// Three legs with no load, a point load and a mass at the joint: tensions in fields, histories and summary.
// The forces at the joint are in balance at rest and in motion.
TEST(EndForces, BridleOfThreeLegs) {
  struct Row {
    const char *name, *more;
    Vec3 load;
    double mass;
  };
  for (const Row& row :
       {Row{"plain", "", Vec3::Zero(), 0},
        Row{"loaded", "    loads: [{at: end_a, force: [3000, -2000, -8000]}]\n", Vec3(3000, -2000, -8000), 0},
        Row{"mass", "    masses: [{at: end_a, mass: 1500}]\n", Vec3(0, 0, -1500 * kGravity), 1500}}) {
    const runs::Results r = run(row.name, bridle(row.more));
    const Pull exact = pull(at_rest(row.load));
    const size_t nodes = r.fields.at("effective_tension").size() / r.output_times.size();
    double worst = 0, size = 0;
    Vec3 sum = row.load;
    for (size_t i = 0; i < 3; ++i) {
      const size_t joint = i ? 2 * i + 1 : 0;
      const size_t anchor = i ? 2 * i : 1;
      const Vec3 f = at_end(row.name, "force", 0, joint);
      const Vec3 g = at_end(row.name, "force", 0, anchor);
      sum += f;
      size = std::max(size, f.norm());
      const double T = exact.at_joint[i].norm();
      const double U = exact.at_anchor[i].norm();
      worst = std::max({worst, (f - exact.at_joint[i]).norm() / T, (g - exact.at_anchor[i]).norm() / U});
      const size_t a = 41 * i;
      const size_t b = 41 * i + 40;
      EXPECT_NEAR(r.fields.at("effective_tension")[i ? b : a], T, 1e-3 * T) << row.name << i;
      EXPECT_NEAR(r.fields.at("effective_tension")[i ? a : b], U, 1e-3 * U) << row.name << i;
      // The direction at end A is that of the cable's tension.
      const Vec3 out = (joint % 2 ? -1 : 1) * at_end(row.name, "direction", 0, joint);
      EXPECT_LT((out - exact.at_joint[i] / T).norm(), 3e-3) << row.name << i;
    }
    EXPECT_EQ(nodes, 123u);
    EXPECT_LT(worst, 1e-3) << row.name;
    EXPECT_LT(sum.norm(), 1e-6 * size) << row.name;
    // In motion the forces balance within the error of the step.
    double off = 0, largest = 0;
    const auto velocity = r.fields.at("velocity");
    for (size_t o = 1; o < r.output_times.size(); ++o) {
      Vec3 all = row.mass ? Vec3::Zero() : row.load;
      for (size_t i = 0; i < 3; ++i) all += at_end(row.name, "force", o, i ? 2 * i + 1 : 0);
      if (row.mass > 0) {  // acceleration from the history of velocity
        const auto& t = r.step_times;
        const size_t k =
            static_cast<size_t>(std::lower_bound(t.begin(), t.end(), r.output_times[o] - 1e-9) - t.begin());
        if (k + 1 >= t.size()) continue;
        Vec3 a;
        for (size_t c = 0; c < 3; ++c) {
          const auto v = r.column("knot", 3 + c);
          a[static_cast<Eigen::Index>(c)] = (v[k + 1] - v[k - 1]) / (t[k + 1] - t[k - 1]);
        }
        all -= row.mass * (a + kGravity * Vec3::UnitZ());
      }
      off = std::max(off, all.norm());
      for (size_t i = 0; i < 3; ++i)
        largest = std::max(largest, at_end(row.name, "force", o, i ? 2 * i + 1 : 0).norm());
    }
    EXPECT_LT(off, 1e-2 * largest) << row.name;
    // The history has the same force, and the summary its maximum.
    const Vec3 f = at_end(row.name, "force", 0, 0);
    const std::string file = runs::folder("end_forces") + "/" + row.name + ".h5";
    for (size_t c = 0; c < 3; ++c)
      EXPECT_EQ(runs::named(file, r, "knot", std::string("end_force_") + "xyz"[c])[0],
                f[static_cast<Eigen::Index>(c)]);
    const auto knot = r.column("knot", runs::kTension);
    const auto far = r.column("far", runs::kTension);
    double most = 0;
    for (size_t k = 0; k < knot.size(); ++k) most = std::max({most, knot[k], far[k]});
    EXPECT_NEAR(r.summary[0], most, 1e-12 * most);
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  %s: %.4f %% off, adds up to %.1e of the largest, in motion %.1e\n", row.name, 100 * worst,
             sum.norm() / size, off / largest);
  }
}

// A clump weight of 2 t in the middle of a cable: tensions on both sides of it.
TEST(EndForces, ClumpWeight) {
  const runs::Results r = run("clump", R"(hawser: 1
line_types: {chain: {outer_diameter: 0.05, mass_per_length: 40, EA: 1e8, bending: false}}
lines:
  chain:
    sections: [{type: chain, length: 100, elements: 50}]
    masses: [{at: 40, mass: 2000}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [50, 0, 60]}
)");
  const Vec3 w(0, 0, -40 * kGravity);
  const CatenaryShape exact =
      catenary(Vec3::Zero(), Vec3(50, 0, 60),
               {{40, w, 1e8, Vec3(0, 0, -2000 * kGravity)}, {60, w, 1e8, Vec3::Zero()}});
  const double before = exact.tension(40).norm();
  const double after = (exact.tension(40) - Vec3(0, 0, -2000 * kGravity)).norm();
  const auto& f = r.fields;
  if (runs::rank_of(MPI_COMM_WORLD) == 0)
    printf("  before %.1f, exactly %.1f N; after %.1f, exactly %.1f N\n",
           f.at("effective_tension_before")[20], before, f.at("effective_tension_after")[20], after);
  ASSERT_GT(std::abs(before - after), 0.1 * before);
  EXPECT_NEAR(f.at("effective_tension_before")[20], before, 1e-3 * before);
  EXPECT_NEAR(f.at("effective_tension_after")[20], after, 1e-3 * after);
  EXPECT_NEAR(f.at("effective_tension")[20], std::max(before, after), 1e-3 * before);
  // At other nodes both are equal.
  EXPECT_EQ(f.at("effective_tension_before")[30], f.at("effective_tension")[30]);
  EXPECT_EQ(f.at("effective_tension_after")[30], f.at("effective_tension")[30]);
  // The least tension is at the lowest point of the line, or beside the weight.
  double least = HUGE_VAL;
  for (double s = 0; s <= 100; s += 0.05) least = std::min(least, exact.tension(s).norm());
  EXPECT_NEAR(r.summary[3], std::min(least, after), 2e-3 * least);
}

// A stiff cantilever of two line types with its own weight, forces and a moment at its tip; clamped at end A,
// or reversed and clamped at end B. References are the sum of the loads and of their moments about the root.
TEST(EndForces, Cantilever) {
  const char* const text = R"(hawser: 1
line_types:
  thick: {outer_diameter: 0.5, mass_per_length: 80, EA: 1e12, EI: [4e10, 9e10], GJ: 5e10}
  thin: {outer_diameter: 0.5, mass_per_length: 50, EA: 1e12, EI: 1e10, GJ: 5e10}
lines:
  arm:
    sections: SECTIONS
    ENDS
    loads: [{at: TIP, force: [900, 2500, -4000], moment: [6000, 0, 0]}]
    start: straight
)";
  for (const bool turned : {false, true}) {
    const std::string name = turned ? "arm_b" : "arm_a";
    const runs::Results r = run(
        name, text,
        {{"SECTIONS", turned
                          ? "[{type: thin, length: 6, elements: 6}, {type: thick, length: 4, elements: 4}]"
                          : "[{type: thick, length: 4, elements: 4}, {type: thin, length: 6, elements: 6}]"},
         {"ENDS", turned
                      ? "end_a: free\n    end_b: {anchor: [0, 0, 0], clamped: true, direction: [-1, 0, 0]}"
                      : "end_a: {anchor: [0, 0, 0], clamped: true, direction: [1, 0, 0]}\n    end_b: free"},
         {"TIP", turned ? "end_a" : "end_b"}});
    const double g = kGravity;
    const double along = turned ? -1 : 1;
    const Vec3 tip(900, 2500, -4000);
    const Vec3 weight(0, 0, -(80 * 4 + 50 * 6) * g);
    const Vec3 force = tip + weight;  // on the root, by the beam
    const Vec3 moment = Vec3(6000, 0, 0) + Vec3(10, 0, 0).cross(tip) +
                        Vec3(2, 0, 0).cross(Vec3(0, 0, -320 * g)) + Vec3(7, 0, 0).cross(Vec3(0, 0, -300 * g));
    const size_t root = turned ? 1 : 0;
    const size_t n = turned ? 10 : 0;
    const Vec3 F = at_end(name, "force", 0, root);
    const Vec3 M = at_end(name, "moment", 0, root);
    // It deflects by 1e-5 of its length.
    EXPECT_LT((F - force).norm(), 1e-6 * force.norm());
    EXPECT_LT((M - moment).norm(), 1e-5 * moment.norm());
    EXPECT_LT((at_end(name, "direction", 0, root) - along * Vec3::UnitX()).norm(), 1e-9);
    // The end force at the free end is the reaction to the load.
    EXPECT_LT((at_end(name, "force", 0, 1 - root) + tip).norm(), 1e-6 * tip.norm());
    const auto& f = r.fields;
    const auto axis = [&](const char* of, size_t at) {
      return Vec3(Eigen::Map<const Vec3>(f.at(of).data() + 3 * at));
    };
    const Vec3 d2 = axis("axis_2", n);
    const Vec3 d3 = axis("axis_1", n).cross(d2);
    // Section forces: of the part beyond the section on the part before it.
    const Vec3 section = along * moment;
    EXPECT_NEAR(f.at("effective_tension")[n], 900, 1e-4 * 900);
    EXPECT_NEAR(f.at("shear_force")[n], std::hypot(force.y(), force.z()), 1e-6 * force.norm());
    EXPECT_NEAR(f.at("bending_moment_2")[n], section.dot(d2), 1e-5 * section.norm());
    EXPECT_NEAR(f.at("bending_moment_3")[n], section.dot(d3), 1e-5 * section.norm());
    EXPECT_NEAR(f.at("bending_moment")[n], std::hypot(moment.y(), moment.z()), 1e-5 * moment.norm());
    EXPECT_NEAR(f.at("torsion_moment")[n], 6000, 0.5);  // -M about -x at end B is the same torsion
    // Where the type changes: the moment, and the curvature of the thinner part.
    const size_t c = turned ? 6 : 4;
    const Vec3 there = Vec3(6, 0, 0).cross(tip) + Vec3(3, 0, 0).cross(Vec3(0, 0, -300 * g));
    EXPECT_NEAR(f.at("bending_moment")[c], there.norm(), 1e-5 * there.norm());
    EXPECT_NEAR(f.at("curvature")[c], there.norm() / 1e10, 0.01 * there.norm() / 1e10);
    // In the middle of the thinner part, averaged over both elements at the node.
    const size_t m = turned ? 3 : 7;
    const Vec3 V = tip + Vec3(0, 0, -150 * g);
    const Vec3 middle = Vec3(3, 0, 0).cross(tip) + Vec3(1.5, 0, 0).cross(Vec3(0, 0, -150 * g));
    EXPECT_NEAR(f.at("shear_force")[m], std::hypot(V.y(), V.z()), 1e-3 * V.norm());
    EXPECT_NEAR(f.at("bending_moment_2")[m], along * middle.dot(axis("axis_2", m)), 5e-3 * middle.norm());
    EXPECT_NEAR(f.at("bending_moment_3")[m], along * middle.dot(axis("axis_1", m).cross(axis("axis_2", m))),
                5e-3 * middle.norm());
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  end %c: force %.1e, moment %.1e, shear %.1e off\n", turned ? 'B' : 'A',
             (F - force).norm() / force.norm(), (M - moment).norm() / moment.norm(),
             f.at("shear_force")[n] / std::hypot(force.y(), force.z()) - 1);
  }
}

}  // namespace
}  // namespace hawser::test::end_forces_test
