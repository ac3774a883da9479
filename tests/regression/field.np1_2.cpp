// A field declared by a force term appears where its declaration states: at outputs, in histories, in
// statistics over steps and at stations, and in the table of extremes; attributes describe it for other
// tools.
#include <memory>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/record/recorder.hpp"
#include "hawser/run/simulation.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::field {
namespace {

const char* const kWeight = R"(hawser: 1
title: A weight on a winch
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 0.02}
lines:
  rope:
    sections: [{type: rope, length: 60, elements: 30}]
    end_a: {anchor: [0, 0, 100], feed: {stock: 40.5, speed_table: [[0, 0], [2, 0.5]]}}
    end_b: free
    masses: [{at: end_b, mass: 1000}]
dynamics: {duration: 1}
output: {every: 0.5, histories: [{line: rope, at: end_b, name: weight}]}
contact: {between_lines: false}
)";

// A term with fields and no force: the height of nodes, and the tension plus 1 N.
class Height : public ForceTerm {
 public:
  explicit Height(const LocalMesh& mesh) : mesh_(mesh) {}
  std::string_view checkpoint_key() const override { return "height"; }
  void evaluate(const Kinematics&, Assembler&) override {}
  void fields(FieldRegistry& registry) const override {
    registry.add({{.name = "height",
                   .unit = "m",
                   .label = "height above the sea",
                   .history = Field::History::yes,
                   .statistics = true,
                   .at_stations = true,
                   .extreme = "height of it",
                   .smallest = true,
                   .report = Field::Report::table,
                   .order = 0},
                  [this](const Kinematics& state, std::span<double> out) {
                    for (size_t n = 0; n < static_cast<size_t>(mesh_.owned); ++n) out[n] = state.x[n].z();
                  }});
    registry.add({{.name = "raised_tension", .unit = "N", .history = Field::History::after_end_columns},
                  [](const Kinematics&, std::span<double> out) {
                    for (double& v : out) v += 1;
                  },
                  "effective_tension"});
  }

 private:
  const LocalMesh& mesh_;
};

std::string attribute(const io::h5::Id& file, const std::string& set, const char* name) {
  const auto data = io::h5::open_dataset(file, set);
  const auto at = io::h5::own(H5Aopen(data, name, H5P_DEFAULT), H5Aclose, name);
  const auto type = io::h5::own(H5Aget_type(at), H5Tclose, name);
  std::string text(H5Tget_size(type), '\0');
  io::h5::check(H5Aread(at, type, text.data()), name);
  return text.c_str();
}

TEST(Field, IsShownAsDeclared) {
  const std::string path = folder("field");
  const std::string input = path + "/case.yaml";
  const std::string output = path + "/run.h5";
  write_case(input, kWeight);
  model::Case c = io::read_case(input);
  c.output.file = output;
  {
    run::Simulation sim(MPI_COMM_WORLD, c);
    sim.system().add(std::make_unique<Height>(sim.local()));
    sim.solve_statics();
    record::Recorder recorder(sim.subject(), {}, {});
    sim.dynamics().start(sim.state());
    recorder.start(sim.state().at_rest());
    sim.dynamics().run(
        1, [](double) { return 1.0; },
        [&](const StepInfo& info) {
          recorder.step(info, sim.dynamics().committed_kinematics());
          return true;
        });
    recorder.output(sim.dynamics().committed_kinematics());
    recorder.finish({});
  }
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(output);
  ASSERT_EQ(r.output_times.size(), 2u);
  // At outputs: the height of the last node.
  EXPECT_EQ(r.fields.at("height").back(), r.fields.at("position").back());
  // Position in histories: after the ends' own columns, before accelerations.
  const auto z = named(output, r, "weight", "position_z");
  EXPECT_EQ(named(output, r, "weight", "height"), z);
  EXPECT_LT(z.back(), z.front() - 0.1);  // the winch lowers it
  const auto tension = named(output, r, "weight", "effective_tension");
  const auto raised = named(output, r, "weight", "raised_tension");
  EXPECT_GT(largest_difference(tension, raised), 0.5);  // tension of the element's middle; 1 N in addition
  EXPECT_LT(largest_difference(tension, raised), 200);
  const auto columns = columns_of(output, "weight");
  const auto place = [&](const char* name) { return std::find(columns.begin(), columns.end(), name); };
  EXPECT_LT(place("height"), place("end_force_x"));
  EXPECT_LT(place("end_force_x"), place("raised_tension"));
  EXPECT_LT(place("raised_tension"), place("acceleration_x"));
  // Statistics: minimum, its time, maximum.
  const auto file = io::h5::open_read(output);
  const auto every = io::h5::read_array(file, "statistics/height").values;
  ASSERT_EQ(every.size(), 31u * io::kStatistics);
  const double* last = every.data() + 30 * io::kStatistics;
  EXPECT_EQ(last[0], *std::min_element(z.begin(), z.end()));
  EXPECT_EQ(last[2], *std::max_element(z.begin(), z.end()));
  EXPECT_FALSE(io::h5::exists(file, "statistics/raised_tension"));
  // The station at the initially outside length has the height of the weight.
  const auto stations = io::h5::read_array(file, "statistics/height_at_stations").values;
  EXPECT_NEAR(stations[9 * io::kStatistics + 2], 100 - 18, 0.1);
  EXPECT_FALSE(io::h5::exists(file, "statistics/raised_tension_at_stations"));
  // First rows in the table of extremes: maximum, then minimum.
  ASSERT_GE(r.summary.size(), 6u);
  EXPECT_NEAR(r.summary[0], 100, 1e-9);
  EXPECT_EQ(r.summary[3], *std::min_element(z.begin(), z.end()));
  EXPECT_EQ(r.summary[5], 60);
  EXPECT_EQ(attribute(file, "fields/height", "label"), "height above the sea");
  EXPECT_EQ(attribute(file, "fields/height", "report"), "table");
  EXPECT_EQ(attribute(file, "fields/height", "unit"), "m");
  EXPECT_EQ(attribute(file, "fields/raised_tension", "label"), "raised tension");
  EXPECT_EQ(attribute(file, "fields/raised_tension", "report"), "no");
}

}  // namespace
}  // namespace hawser::runs::field
