// Friction on volumes and between lines in statics, from case files to results files, against closed forms.
#include <fmt/format.h>

#include "../regression/runs.hpp"

namespace hawser::statics_friction {
namespace {

struct Shown {
  std::vector<double> position, tension;
  size_t nodes() const { return tension.size(); }
};

// Runs the case on all ranks and, if there are several, also on one; the positions must be equal.
Shown run(const std::string& name, const std::string& text) {
  const std::string base = runs::folder("statics_friction") + "/" + name;
  runs::write_case(base + ".yaml", text);
  runs::run_on_all({base + ".yaml", base + ".h5"});
  const bool more = runs::size_of(MPI_COMM_WORLD) > 1;
  if (more) runs::run_on_one({base + ".yaml", base + "_alone.h5"});
  MPI_Barrier(MPI_COMM_WORLD);
  const auto shown = [](const std::string& path) {
    const io::h5::Id file = io::h5::open_read(path);
    return Shown{io::h5::read_array(file, "fields/position").values,
                 io::h5::read_array(file, "fields/effective_tension").values};
  };
  const Shown all = shown(base + ".h5");
  const Shown one = more ? shown(base + "_alone.h5") : all;
  EXPECT_EQ(all.position.size(), one.position.size());
  for (size_t i = 0; i < std::min(all.position.size(), one.position.size()); ++i)
    EXPECT_NEAR(all.position[i], one.position[i], 1e-9) << name << ", number " << i;
  return all;
}

// A pipe of 100 kg/m along x on a deck, pulled at its end, within the elastic friction (5 mm) and beyond.
// Closed form of a pile in soil (Randolph and Wroth 1978) with tau = mu w = 500 N/m, EA 5e8 N. The elastic
// part decays over sqrt(EA 5 mm/tau) = 71 m, fourteen elements; 200 m slip.
TEST(StaticsFriction, PipePulledOnADeck) {
  struct Row {
    double force, u, tension;  // N, m; N, 50 m from the end
  };
  const bool several = runs::size_of(MPI_COMM_WORLD) > 1;
  for (const Row& r : {Row{17677.66953, 0.0025, 8716.305381908778}, Row{100000, 0.0225, 75000}}) {
    if (several && r.force < 1e5 && !std::getenv("HAWSER_FULL")) continue;
    const Shown s = run("deck", fmt::format(R"(hawser: 1
environment: {{gravity: 10}}
line_types:
  pipe: {{outer_diameter: 0.1, mass_per_length: 100, EA: 5e8, bending: false}}
volumes:
  deck: {{shape: {{plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}}}, normal_stiffness: {{per_length: 1e6}},
         friction: {{axial: 0.5, lateral: 0.5, mobilisation_length: 5 mm}}}}
lines:
  pipe:
    sections: [{{type: pipe, length: 400, elements: 40}}]
    end_a: free
    end_b: free
    start: {{points: [[0, 0, 0.049], [400, 0, 0.049]]}}
    loads: [{{at: end_b, force: [{}, 0, 0]}}]
statics: {{contact_friction: true}}
)",
                                            r.force));
    ASSERT_EQ(s.nodes(), 41U);
    EXPECT_NEAR(s.position[120] - 400, r.u, 5e-3 * r.u) << r.force;
    EXPECT_NEAR(s.tension[35], r.tension, 5e-3 * r.tension) << r.force;
  }
}

// A beam on a slope of 10 degrees with both ends free is at rest if mu > tan 10 = 0.1763, and has no
// equilibrium below.
TEST(StaticsFriction, PipeOnASlope) {
  const auto slope = [](double mu) {
    return fmt::format(R"(hawser: 1
line_types:
  pipe: {{outer_diameter: 0.2, mass_per_length: 100, EA: 1e8, EI: 1e6, GJ: 1e6}}
volumes:
  slope: {{shape: {{plane: {{point: [0, 0, 0], normal: [0.17364817766693033, 0, 0.984807753012208]}}}},
          normal_stiffness: {{per_length: 1e7}}, friction: {}}}
lines:
  pipe:
    sections: [{{type: pipe, length: 10, elements: 10}}]
    end_a: free
    end_b: free
    start: {{points: [[-4.906691312112113, 0, 0.9666231828605713], [4.941386218009966, 0, -0.769858593808732]]}}
statics: {{contact_friction: true, relaxation_steps: 600}}
)",
                       mu);
  };
  const Shown s = run("slope", slope(0.178));
  ASSERT_EQ(s.nodes(), 11U);
  EXPECT_NEAR(s.position[30], 4.941386218009966, 2.5e-3);  // mobilisation length and penetration
  const std::string base = runs::folder("statics_friction") + "/slides";
  runs::write_case(base + ".yaml", slope(0.174));
  run::RunOptions o;
  o.case_path = base + ".yaml";
  o.quiet = true;
  EXPECT_THROW(
      {
        try {
          run::run(MPI_COMM_WORLD, o);
        } catch (const std::exception& e) {
          EXPECT_NE(std::string(e.what()).find("not at rest after"), std::string::npos) << e.what();
          throw;
        }
      },
      std::exception);
}

// Half a turn of rope, pulled at one end: ratio exp(mu theta) on a drum with a given stiffness and with the
// automatic one, which the pull raises a hundredfold, and on a thick line.
TEST(StaticsFriction, RopeOnADrumAndOnALine) {
  const double reach = 1.01, pull = 1000, mu = 0.3;
  std::string points = fmt::format("[{}, 0, -1.5]", reach);
  const int arcs = 96;
  for (int i = 0; i <= arcs; ++i) {
    const double a = M_PI * i / arcs;
    points += fmt::format(", [{:.12f}, 0, {:.12f}]", reach * std::cos(a), reach * std::sin(a));
  }
  points += fmt::format(", [{}, 0, -1.5]", -reach);
  const double length = 3 + 2 * arcs * reach * std::sin(M_PI / 2 / arcs);
  for (const std::string on : {"drum", "automatic", "post"}) {
    const bool line = on == "post";
    const int elements = line ? 160 : 80;
    std::string text = fmt::format(R"(hawser: 1
environment: {{gravity: 0}}
line_types:
  rope: {{outer_diameter: 0.02, mass_per_length: 1, EA: 1e6, bending: false}}
  post: {{outer_diameter: 2, mass_per_length: 500, EA: 1e12, EI: 1e12, GJ: 1e12}}
lines:
  rope:
    sections: [{{type: rope, length: {}, elements: {}}}]
    end_a: free
    end_b: {{anchor: [{}, 0, -1.5]}}
    loads: [{{at: end_a, force: [0, 0, {}]}}]
    start: {{points: [{}]}}
)",
                                   length, elements, -reach, -pull, points);
    text += line ? R"(  post:
    sections: [{type: post, length: 2, elements: 2}]
    end_a: {anchor: [0, -1, 0], direction: [0, 1, 0], clamped: true}
    end_b: {anchor: [0, 1, 0], direction: [0, 1, 0], clamped: true}
contact:
  between_lines: {normal_stiffness: {per_length: 1e7}, friction: 0.3, mobilisation_length: 1e-5}
)"
                 : fmt::format(R"(volumes:
  drum: {{shape: {{cylinder: {{from: [0, -2, 0], to: [0, 2, 0], radius: 1}}}}, normal_stiffness: {},
         friction: {{axial: 0.3, lateral: 0.3, mobilisation_length: 1e-5}}}}
)",
                               on == "drum" ? "{per_length: 1e7}" : "auto");
    const Shown s = run(on, text + "statics: {contact_friction: true}\n");
    ASSERT_EQ(s.nodes(), line ? 164U : 81U);
    EXPECT_NEAR(s.tension[0], pull, 1e-3 * pull);
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  %s: %.4f of exp(mu theta)\n", on.c_str(),
             pull / s.tension[static_cast<size_t>(elements)] / std::exp(mu * M_PI));
    EXPECT_NEAR(pull / s.tension[static_cast<size_t>(elements)], std::exp(mu * M_PI),
                0.01 * std::exp(mu * M_PI));
  }
}

}  // namespace
}  // namespace hawser::statics_friction
