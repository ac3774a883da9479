// The results file is valid at every moment because writing changes only bytes of rows. The XDMF file is well
// formed, and its references exist.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "hawser/io/hdf5.hpp"
#include "hawser/io/results.hpp"
#include "hawser/io/results_build.hpp"
#include "hawser/io/xdmf.hpp"

namespace hawser::io::results_structure_test {
namespace {

std::string temporary(const std::string& name) { return testing::TempDir() + "results_" + name; }

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ResultContents contents(int lines, int nodes) {
  ResultContents c;
  c.run.case_path = "a <strange> & \"quoted\" case.yaml";
  for (int l = 0; l < lines; ++l) {
    c.line_nodes.push_back(nodes);
    c.line_labels.push_back({fmt::format("line {}", l), std::vector<double>(static_cast<size_t>(nodes))});
  }
  c.fields = {{"position", "m", 3}, {"contact force", "N", 3}, {"penetration", "m", 1}};
  c.series = {{"time", {{"value", "", 1}}}};
  c.bodies = 1;
  c.body_names = {"reel"};
  // Meshes are views of memory that is owned elsewhere.
  static const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, many(30, Vec3(1, 2, 3));
  static const std::vector<std::array<int, 3>> one = {{0, 1, 2}}, two = {{0, 1, 2}, {3, 4, 5}};
  c.volumes = {{"drum & flange", 0, corners, one, {1}, {}},
               {"drum / flange", 0, many, two, {1, 0}, {}},
               {"deck", -1, corners, one, {}, {}}};
  c.volumes[1].coarse = {{Vec3(1, 2, 3), Vec3(2, 2, 3), Vec3(1, 3, 3)}, {{0, 1, 2}}, {1}};
  c.volumes[1].coarse_active = {0};
  c.expected_outputs = 4;
  c.expected_steps = 4;
  return c;
}

std::vector<int> all_nodes(const ResultContents& c) {
  std::vector<int> n;
  for (int i = 0; i < c.nodes_total(); ++i) n.push_back(i);
  return n;
}

void write(ResultsFile& file, double time) {
  const auto& c = file.contents();
  file.append_series(time, {{time}});
  std::vector<std::vector<double>> fields;
  for (const auto& f : c.fields)
    fields.emplace_back(static_cast<size_t>(c.nodes_total() * f.components), time + 1);
  const BodyPose pose;
  file.write_output(time, fields, {&pose, 1});
}

// Byte ranges of the raw data of all datasets: [first byte, end).
std::vector<std::pair<size_t, size_t>> data_of(const std::string& path) {
  const auto file = h5::open_read(path);
  std::vector<std::pair<size_t, size_t>> places;
  H5Ovisit2(
      file, H5_INDEX_NAME, H5_ITER_NATIVE,
      [](hid_t root, const char* name, const H5O_info_t* info, void* out) -> herr_t {
        if (info->type != H5O_TYPE_DATASET) return 0;
        const auto set = h5::open_dataset(root, name);
        const haddr_t at = H5Dget_offset(set);
        if (at != HADDR_UNDEF)
          static_cast<std::vector<std::pair<size_t, size_t>>*>(out)->emplace_back(
              at, at + H5Dget_storage_size(set));
        return 0;
      },
      &places, H5O_INFO_BASIC);
  return places;
}

TEST(ResultsStructure, WritingChangesRowsOnly) {
  const std::string path = temporary("structure.h5");
  auto file = ResultsFile::create(MPI_COMM_SELF, path, contents(2, 11), all_nodes(contents(2, 11)));
  Checkpoint checkpoint;
  checkpoint.scalars["step"] = 1;
  file.write_checkpoint(checkpoint);  // makes room for checkpoints, once
  const std::string before = text_of(path);
  const auto data = data_of(path);
  EXPECT_GT(data.size(), 20u);
  for (int k = 0; k < 4; ++k) {
    write(file, k);
    file.write_checkpoint(checkpoint);
    const std::string after = text_of(path);
    ASSERT_EQ(after.size(), before.size());
    size_t changed = 0, outside = 0;
    for (size_t i = 0; i < after.size(); ++i) {
      if (after[i] == before[i]) continue;
      ++changed;
      outside += std::none_of(data.begin(), data.end(), [&](auto p) { return i >= p.first && i < p.second; });
    }
    EXPECT_GT(changed, 200u);
    EXPECT_EQ(outside, 0u) << "structure changed by output " << k;
  }
  // The counter is a single write within one memory page, so that the end of the process cannot split it.
  const auto h5 = h5::open_read(path);
  const auto at = H5Dget_offset(h5::open_dataset(h5, "written"));
  EXPECT_EQ(at / 4096, (at + 15) / 4096);
}

TEST(ResultsStructure, SafeNames) {
  EXPECT_EQ(safe_name("hose@12.5"), "hose@12.5");
  EXPECT_EQ(safe_names({"a/b", "a:b", "", "..", "a_b"}),
            (std::vector<std::string>{"a_b", "a_b_2", "_", "__", "a_b_3"}));
}

// Tags open and close in order, without bare & or <.
void expect_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  const std::regex tag(
      "<(/?)([A-Za-z?][A-Za-z0-9]*)((?: [A-Za-z]+=\"[^\"<&]*(?:&#[0-9]+;[^\"<&]*)*\")*)([/?]?)>");
  size_t at = 0;
  std::smatch m;
  for (auto it = std::sregex_iterator(xml.begin(), xml.end(), tag); it != std::sregex_iterator(); ++it) {
    const std::string between = xml.substr(at, static_cast<size_t>(it->position()) - at);
    ASSERT_EQ(between.find('<'), std::string::npos) << between;
    at = static_cast<size_t>(it->position() + it->length());
    if ((*it)[4].length()) continue;
    if ((*it)[1].length()) {
      ASSERT_FALSE(open.empty());
      ASSERT_EQ(open.back(), (*it)[2].str());
      open.pop_back();
    } else {
      open.push_back((*it)[2].str());
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(xml.substr(at), "\n");
}

std::vector<hsize_t> numbers(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<hsize_t>(in), {}};
}

// Checks every reference: the dataset exists, the box is inside it, and its size equals Dimensions.
int check_references(const std::string& folder, const std::string& xml) {
  const std::regex item(
      "<DataItem Dimensions=\"([0-9 ]+)\" NumberType=\"(\\w+)\" Precision=\"(\\d)\" "
      "Format=\"HDF\">([^:<]+):/([^|<]+)(?:\\|([0-9 ]+):([0-9 ]+):([0-9 ]+):([0-9 ]+))?</DataItem>");
  int n = 0;
  for (auto it = std::sregex_iterator(xml.begin(), xml.end(), item); it != std::sregex_iterator();
       ++it, ++n) {
    const auto& m = *it;
    const auto file = h5::open_read(folder + m[4].str());
    const auto set = h5::open_dataset(file, m[5].str());
    const auto type = h5::own(H5Dget_type(set), H5Tclose, "type");
    EXPECT_EQ(H5Tget_size(type), std::stoul(m[3].str())) << m[0].str();
    EXPECT_EQ(H5Tget_class(type), m[2].str() == "Float" ? H5T_FLOAT : H5T_INTEGER) << m[0].str();
    const auto shape = h5::shape_of(set);
    hsize_t size = 1, expected = 1;
    for (const auto k : numbers(m[1].str())) expected *= k;
    if (m[6].matched) {
      const auto start = numbers(m[6].str());
      const auto count = numbers(m[8].str());
      const auto message = numbers(m[9].str());
      EXPECT_EQ(start.size(), shape.size()) << m[0].str();
      EXPECT_EQ(count.size(), shape.size()) << m[0].str();
      for (size_t i = 0; i < shape.size(); ++i) {
        EXPECT_LE(start[i] + count[i], message[i]) << m[0].str();
        EXPECT_LE(message[i], shape[i]) << m[0].str();
        size *= count[i];
      }
    } else {
      for (const auto k : shape) size *= k;
    }
    EXPECT_EQ(size, expected) << m[0].str();
  }
  return n;
}

// A moving mesh is written once, with the poses of its body; only ParaView has its positions at outputs.
TEST(ResultsXdmf, MeshesAreMovedForParaViewAlone) {
  for (const bool xdmf : {true, false}) {
    const std::string path = temporary(xdmf ? "drawn.h5" : "posed.h5");
    auto c = contents(1, 3);
    c.xdmf = xdmf;
    auto file = ResultsFile::create(MPI_COMM_SELF, path, c, all_nodes(c));
    for (int k = 0; k < 3; ++k) write(file, 0.5 * k);
    file.finish({});
    const h5::Id results = h5::open_read(path);
    const std::vector<std::string> places = volume_places(c);
    for (size_t i = 0; i < places.size(); ++i) {
      ASSERT_TRUE(h5::exists(results, places[i] + "/vertices")) << places[i];
      EXPECT_EQ(h5::exists(results, places[i] + "/moved"), xdmf && c.volumes[i].body >= 0);
    }
    EXPECT_EQ(h5::shape_of(h5::open_dataset(results, "bodies/rotation")), (h5::Shape{3, 1, 4}));
    EXPECT_EQ(std::filesystem::exists(temporary("posed.xdmf")), false);
  }
}

TEST(ResultsXdmf, PointsAtWhatIsThere) {
  for (const int lines : {3, 20}) {  // one grid for each line, and one grid for all lines
    for (const bool finish : {false, true}) {
      const std::string path = temporary("xdmf.h5");
      int written = 0;
      {
        const auto c = contents(lines, 7);
        auto file = ResultsFile::create(MPI_COMM_SELF, path, c, all_nodes(c));
        EXPECT_EQ(file.xdmf_path(), temporary("xdmf.xdmf"));
        for (int k = 0; k < 6; ++k) write(file, 0.5 * k);
        if (finish) file.finish({});
        written = static_cast<int>(file.written());
      }
      const std::string xml = text_of(temporary("xdmf.xdmf"));
      expect_well_formed(xml);
      // In each output: a line has topology, 3 fields, arc length, line number and rank; the drum and its
      // coarser neighbour have 3 each, the deck has 2.
      const int each = 7 * (lines == 3 ? 3 : 1) + 8;
      const int n = check_references(testing::TempDir(), xml);
      EXPECT_EQ(n, written * each);
      EXPECT_GT(written, finish ? 5 : 0);
    }
  }
}

}  // namespace
}  // namespace hawser::io::results_structure_test
