// Bend radius utilisation of a cantilever with an end moment, whose curvature is M / EI everywhere; on 1 and
// 2 ranks.
#include "../regression/runs.hpp"

namespace hawser::utilisation_test {
namespace {

// EI = 1 MN m², M = 200 kN m: a bend radius of 5 m.
std::string rolled_up(const std::string& radius, const std::string& name) {
  const std::string folder = runs::folder("utilisation");
  const std::string path = folder + "/" + name + ".yaml";
  runs::write_case(
      path,
      "hawser: 1\nenvironment: {gravity: 0}\nline_types:\n  pipe: {outer_diameter: 0.2, mass_per_length: "
      "100, EA: 1 GN, EI: 1 MN m2, GJ: 1 MN m2" +
          radius +
          "}\n  tip: {outer_diameter: 0.2, mass_per_length: 100, EA: 1 GN, EI: 1 MN m2, GJ: 1 MN m2}\n"
          "contact: {between_lines: false}\nlines:\n  l:\n    sections: [{type: pipe, length: 8, "
          "elements: 16}, {type: tip, length: 2, elements: 4}]\n    end_a: {anchor: [0, 0, 0], clamped: "
          "true, direction: [1, 0, 0]}\n    end_b: free\n    start: straight\n    loads: [{at: end_b, "
          "moment: [0, -200 kN m, 0]}]\n");
  runs::run(MPI_COMM_WORLD, {path, folder + "/" + name + ".h5", "", 0});
  return folder + "/" + name + ".h5";
}

std::string messages(const io::h5::Id& file) {
  if (!io::h5::exists(file, "messages")) return "";
  std::string all;
  for (const std::string& m : io::h5::read_texts(file, "messages")) all += m + "\n";
  return all;
}

TEST(Utilisation, OfAKnownCurvature) {
  const std::string sharp = rolled_up(", minimum_bend_radius: 6", "sharp");
  const std::string mild = rolled_up(", minimum_bend_radius: 4", "mild");
  const std::string none = rolled_up("", "none");
  if (runs::rank_of(MPI_COMM_WORLD) != 0) return;
  const io::h5::Id file = io::h5::open_read(sharp);
  const auto used = io::h5::read_row(file, "fields/bend_utilisation", 0).values;
  ASSERT_EQ(used.size(), 21u);
  for (size_t n = 0; n < used.size(); ++n) EXPECT_NEAR(used[n], n <= 16 ? 6. / 5 : 0, 1e-6) << n;
  EXPECT_NE(messages(file).find("line l is bent below its minimum bend radius"), std::string::npos);
  EXPECT_NE(messages(file).find("its bend radius utilisation is 1.2"), std::string::npos) << messages(file);
  const io::h5::Id at_ease = io::h5::open_read(mild);
  const io::h5::Id no_limits = io::h5::open_read(none);
  EXPECT_NEAR(io::h5::read_row(at_ease, "fields/bend_utilisation", 0).values[3], 4. / 5, 1e-6);
  EXPECT_EQ(messages(at_ease).find("sharply"), std::string::npos);
  EXPECT_FALSE(io::h5::exists(no_limits, "fields/bend_utilisation"));
}

}  // namespace
}  // namespace hawser::utilisation_test
