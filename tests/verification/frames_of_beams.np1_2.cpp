// Rigidly joined beams against closed forms of slender frames.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../regression/runs.hpp"
#include "support/rig.hpp"

namespace hawser::test::frames_of_beams {
namespace {

// A column of 4 m, clamped at its foot, with an arm of 3 m joined rigidly to its head and loaded at the tip.
// For small slopes and negligible axial strain the deflections are: down P b³/3EI + P b² a/EI, sideways P (a³
// + b³)/3EI + P b² a/GJ.
TEST(FramesOfBeams, ArmOnAColumn) {
  const double a = 4, b = 3, EI = 1e6, GJ = 8e5;
  for (const bool sideways : {false, true}) {
    model::Case c;
    c.environment.gravity = 0;
    c.line_types = {beam_type(1e10, EI, GJ)};
    c.joints = {{"head", {0, 0, a}, true}};
    model::End head;
    head.kind = model::EndKind::joint;
    head.carrier = "head";
    head.at = {0, 0, a};
    model::End arm = head;
    arm.direction = Vec3::UnitX();
    for (const bool column : {true, false}) {
      model::Line l;
      l.name = column ? "column" : "arm";
      l.sections.push_back({"beam", column ? a : b, 8, 1});
      l.end_a = column ? clamp(Vec3::Zero(), Vec3::UnitZ()) : arm;
      if (column) l.end_b = head;
      l.start = model::Start::straight;
      if (!column) {
        model::PointLoad p;
        p.at = b;
        p.force = sideways ? Vec3(0, 10, 0) : Vec3(0, 0, -10);
        l.point_loads.push_back(p);
      }
      c.lines.push_back(l);
    }
    Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    const int tip = s.local().find(s.mesh().lines[1].first_node + 8);
    double moved = 0;
    if (tip >= 0 && tip < s.local().owned) {
      const Vec3& x = s.state().x[static_cast<size_t>(tip)];
      moved = sideways ? x.y() : a - x.z();
    }
    MPI_Allreduce(MPI_IN_PLACE, &moved, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    const double exact = sideways ? 10 * ((a * a * a + b * b * b) / (3 * EI) + b * b * a / GJ)
                                  : 10 * (b * b * b / (3 * EI) + b * b * a / EI);
    printf("arm on a column, %s: %.6e m, closed form %.6e m (%.4f %%)\n", sideways ? "sideways" : "down",
           moved, exact, 100 * (moved / exact - 1));
    EXPECT_NEAR(moved, exact, 1e-3 * exact);
  }
}

// A portal: a beam of length L on two columns of height h and the same section with clamped feet, under the
// weight w of the beam. With k = h/L the moments are w L²/(6 (k + 2)) at the corners and half of that at the
// feet (Kleinlogel, Rahmenformeln). The automatic start shape of the members is straight; a sagging shape
// would give the rigid joints wrong angles.
TEST(FramesOfBeams, PortalUnderItsWeight) {
  const double L = 6, h = 4, w = 2000;
  const std::string base = runs::folder("frames_of_beams") + "/portal";
  for (const double gravity : {1e-2, 10.}) {
    const std::string type = "{outer_diameter: 0.5, EA: 1e10, EI: 1e7, GJ: 8e6, mass_per_length: ";
    runs::write_case(
        base + ".yaml",
        fmt::format(
            "hawser: 1\nenvironment: {{gravity: {}}}\n"
            "line_types: {{beam: {}{}}}, column: {}0.001}}}}\n"
            "joints: {{left: {{start: [0, 0, {h}], rigid: true}}, right: {{start: [{L}, 0, {h}], rigid: "
            "true}}}}\nlines:\n"
            "  left column: {{sections: [{{type: column, length: {h}, elements: 8}}], end_a: {{anchor: [0, "
            "0, 0], direction: [0, 0, 1], clamped: true}}, end_b: {{joint: left}}}}\n"
            "  right column: {{sections: [{{type: column, length: {h}, elements: 8}}], end_a: {{anchor: "
            "[{L}, 0, 0], direction: [0, 0, 1], clamped: true}}, end_b: {{joint: right}}}}\n"
            "  beam: {{sections: [{{type: beam, length: {L}, elements: 12}}], end_a: {{joint: left}}, "
            "end_b: {{joint: right}}}}\ncontact: {{between_lines: false}}\n",
            gravity, type, w / 10, type, fmt::arg("h", h), fmt::arg("L", L)));
    runs::run_on_all({base + ".yaml", base + ".h5"});
    if (runs::rank_of(MPI_COMM_WORLD) != 0) continue;
    const io::h5::Id file = io::h5::open_read(base + ".h5");
    const std::vector<double> m = io::h5::read_row(file, "ends/moment", 0).values;
    const double corner = w * gravity / 10 * L * L / (6 * (h / L + 2));
    for (const bool foot : {true, false}) {
      const double found = std::abs(m[foot ? 1 : 4]);
      const double exact = foot ? 0.5 * corner : corner;
      printf("portal, g = %g, %s: %.8g N m, closed form %.8g N m\n", gravity, foot ? "foot" : "corner", found,
             exact);
      EXPECT_NEAR(found, exact, 1e-3 * exact + 1e-4);
    }
  }
}

}  // namespace
}  // namespace hawser::test::frames_of_beams
