// Energy balance of friction on a rotating drum, of damped cables that come taut, and of a chain heap.
#include <algorithm>
#include <numbers>

#include "regression/runs.hpp"

namespace hawser::runs::contact_energy {
namespace {

// A cable lies half round a drum that rotates under it: the power of the drum is that of friction, (T_a -
// T_b) (R + r) times the angular velocity, and the tension ratio is exp(mu pi) (Euler).
TEST(ContactEnergy, ADrumTurnsUnderACable) {
  std::string points = "[-0.51, 0, -5]";
  for (int i = 0; i <= 32; ++i) {
    const double angle = std::numbers::pi * i / 32;
    points += ", [" + std::to_string(-0.51 * std::cos(angle)) + ", 0, " +
              std::to_string(0.51 * std::sin(angle)) + "]";
  }
  points += ", [0.51, 0, -5]";
  const std::string path = folder("turning_drum");
  const std::string file = path + "/case.yaml";
  const std::string out = path + "/case.h5";
  write_case(file, R"(
hawser: 1
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.02, mass_per_length: 1, EA: 2.0e6, bending: false, stiffness_damping: 0.003}
bodies:
  drum: {motion: {rotation: {axis: [0, 1, 0], rate: 0.5}, ramp: 1}}
volumes:
  drum: {shape: {cylinder: {from: [0, -1, 0], to: [0, 1, 0], radius: 0.5}}, body: drum, friction: 0.3}
lines:
  rope:
    sections: [{type: rope, length: 11.6022, element_length: 0.05}]
    end_a: {anchor: [-0.51, 0, -5]}
    end_b: free
    start: {points: [)" +
                       points + R"(]}
    loads: [{at: end_b, force: [0, 0, -1000]}]
dynamics: {duration: 4}
output: {every: 1, histories: [{line: rope, at: end_a, name: a}]}
)");
  run_on_all({file, out});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(out);
  const std::vector<double> friction = named(out, r, "energy", "friction");
  const std::vector<double> work = named(out, r, "energy", "brought_in");
  const std::vector<double> tension = r.column("a", kTension);
  const auto from = static_cast<size_t>(
      std::find_if(r.step_times.begin(), r.step_times.end(), [](double t) { return t >= 2; }) -
      r.step_times.begin());
  const double time = r.step_times.back() - r.step_times[from];
  const double taken = (friction.back() - friction[from]) / time;
  const double given = (work.back() - work[from]) / time;
  const double ratio = tension.back() / 1000;
  const double power = (tension.back() - 1000) * 0.51 * 0.5;
  printf("  ratio %.4f, friction %.2f W, brought in %.2f W, by the tensions %.2f W\n", ratio, taken, given,
         power);
  EXPECT_NEAR(ratio, std::exp(0.3 * std::numbers::pi), 0.01 * ratio);
  EXPECT_NEAR(taken, power, 0.01 * power);
  EXPECT_NEAR(given, power, 0.01 * power);
}

// A slightly slack wire with 100 kg at its end comes taut. Damping increases the number of steps by less than
// half; the largest tension is printed.
TEST(ContactEnergy, AWireThatComesTautMayBeDamped) {
  const std::string path = folder("comes_taut");
  const std::string file = path + "/case.yaml";
  const std::string out = path + "/case.h5";
  size_t undamped = 0;
  for (const std::string damping : {"0", "1e-4", "1e-3", "1e-2", "0.1", "1"}) {
    write_case(file, R"(
hawser: 1
line_types:
  wire: {outer_diameter: 0.02, mass_per_length: 2.5, EA: 5.0e7, bending: false, stiffness_damping: DAMPING}
lines:
  wire:
    sections: [{type: wire, length: 3.8, element_length: 0.05}]
    end_a: {anchor: [0, 0, 0]}
    end_b: free
    start: {points: [[0, 0, 0], [0.03, 0, -1.9], [0, 0, -3.7987]]}
    masses: [{at: end_b, mass: 100}]
contact: {between_lines: false}
statics: false
dynamics: {duration: 0.5}
output: {every: 0.5, histories: [{line: wire, at: end_a, name: top}]}
)",
               {{"DAMPING", damping}});
    run_on_all({file, out});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results r = read(out);
    if (damping == "0") undamped = r.step_times.size();
    printf("  stiffness_damping %s: %zu steps, largest tension at the top %.0f N\n", damping.c_str(),
           r.step_times.size(), largest(r.column("top", kTension)));
    EXPECT_LT(r.step_times.size(), 3 * undamped / 2) << damping;
  }
}

// A vertical chain is lowered into a heap of its own links, which touch each other with friction.
TEST(ContactEnergy, AChainIsHeapedUp) {
  const std::string path = folder("heap");
  const std::string file = path + "/case.yaml";
  const std::string out = path + "/case.h5";
  write_case(file, R"(
hawser: 1
environment: {water: {depth: 50}, seabed: {depth: 50, damping: 1.0e4}}
line_types: {c: {outer_diameter: 0.1, mass_per_length: 60, EA: 250 MN, bending: false, stiffness_damping: 0.01}}
contact: {between_lines: {friction: 0.3}}
bodies:
  b: {motion: {table: {interpolation: monotone, rows: [[0, 0, 0, 0, 0, 0, 0], [2, 0, 0, 0, 0, 0, 0],
      [14, 0, 0, -12, 0, 0, 0], [16, 0, 0, -12, 0, 0, 0]]}}}
lines:
  m: {sections: [{type: c, length: 49, elements: 98}], end_a: {body: b, at: [0, 0, 0]}, end_b: free}
dynamics: {duration: 6}
output: {every: 1}
)");
  run_on_all({file, out});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(out);
  const double made = largest(named(out, r, "energy", "error"));
  printf("  energy made %.3f J, %zu steps\n", made, r.step_times.size());
  EXPECT_LT(made, 25);  // 1 % of m g h of the part in the heap
}

}  // namespace
}  // namespace hawser::runs::contact_energy
