// Randomly corrupted mesh files are read or refused with one sentence.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/io/mesh_reader.hpp"

namespace hawser::case_mesh_fuzz_test {
namespace {

std::string text_of(const std::string& path) {
  std::ostringstream s;
  s << std::ifstream(path, std::ios::binary).rdbuf();
  return s.str();
}

// Overwrites, deletes or duplicates bytes, or truncates the text.
std::string broken(std::string text, std::mt19937& gen) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(gen()) % n; };
  for (std::size_t k = 1 + below(6); k > 0 && !text.empty(); --k) {
    const std::size_t at = below(text.size());
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text[at] = "0123456789.-e/ \n"[below(16)];
        break;
      case 2:
        text.erase(at, 1 + below(20));
        break;
      case 3:
        text.insert(at, text.substr(at, 1 + below(60)));
        break;
      default:
        if (below(10) == 0) text.resize(at);
    }
  }
  return text;
}

TEST(CaseMeshFuzz, BrokenFilesAreReadOrRefused) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  std::string stl = "solid t\n";
  for (const char* v : {"0 0 0 0 1 0 1 0 0", "0 0 0 1 0 0 0 0 1", "0 0 0 0 0 1 0 1 0", "1 0 0 0 1 0 0 0 1"}) {
    std::istringstream in(v);
    std::string a, b, c;
    stl += "facet normal 0 0 0\nouter loop\n";
    while (in >> a >> b >> c) stl += "vertex " + a + " " + b + " " + c + "\n";
    stl += "endloop\nendfacet\n";
  }
  stl += "endsolid t\n";
  // The same mesh as binary STL: 80 bytes, the number of triangles, 50 bytes for each.
  std::string binary(80, ' ');
  const auto put = [&](const auto& x) { binary.append(reinterpret_cast<const char*>(&x), sizeof x); };
  put(std::uint32_t{4});
  for (const auto& t : {std::array<float, 9>{0, 0, 0, 0, 1, 0, 1, 0, 0},
                        {0, 0, 0, 1, 0, 0, 0, 0, 1},
                        {0, 0, 0, 0, 0, 1, 0, 1, 0},
                        {1, 0, 0, 0, 1, 0, 0, 0, 1}}) {
    put(std::array<float, 3>{});
    put(t);
    put(std::uint16_t{0});
  }
  std::string binary_ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const auto put_ply = [&](const auto& x) { binary_ply.append(reinterpret_cast<const char*>(&x), sizeof x); };
  put_ply(std::array<float, 12>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (const auto& t : {std::array<int, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    put_ply(std::uint8_t{3});
    put_ply(t);
  }
  const std::vector<std::pair<std::string, std::string>> files = {
      {".obj", text_of(HAWSER_SOURCE_DIR "/tests/data/bad/box.obj")},
      {".stl", stl},
      {".stl", binary},
      {".ply", ply},
      {".ply", binary_ply}};
  for (const auto& [extension, text] : files) {  // intact files are read
    const std::string path = testing::TempDir() + "hawser_whole" + extension;
    std::ofstream(path, std::ios::binary) << text;
    EXPECT_GE(io::read_mesh(path).mesh.triangles.size(), 4U) << extension;
  }
  std::mt19937 gen(1);
  int read = 0, refused = 0;
  const std::string folder = testing::TempDir() + "hawser_broken";
  std::filesystem::create_directories(folder);
  const int files_tried = std::getenv("HAWSER_FULL") ? 2500 : 800;
  for (int i = 0; i < files_tried; ++i) {
    const auto& [extension, text] = files[static_cast<std::size_t>(i) % files.size()];
    const std::string path = folder + "/mesh" + extension;
    std::ofstream(path, std::ios::binary) << broken(text, gen);
    try {
      const io::LoadedMesh m = io::read_mesh(path);
      const MeshSurface s(m.mesh, {}, {true, 40 * M_PI / 180, m.open});
      const auto q = s.query(Vec3(0.3, 0.2, 0.1), 1e300);
      if (q) {
        ASSERT_FALSE(std::isnan(q->distance)) << i;
        ASSERT_NEAR(q->normal.norm(), 1, 1e-9) << i;
        ASSERT_TRUE(q->curvature.allFinite()) << i;
      }
      ++read;
    } catch (const InputError& e) {
      const std::string s = e.what();
      ASSERT_EQ(s.find('\n'), std::string::npos) << s;
      ASSERT_NE(s.find("mesh" + extension), std::string::npos) << s;
      ++refused;
    } catch (const std::invalid_argument& e) {
      FAIL() << i << ": " << e.what();
    }
  }
  EXPECT_GT(read, files_tried / 13);
  EXPECT_GT(refused, files_tried / 13);
}

TEST(CaseMeshFuzz, APlyFileThatNamesNoVertex) {
  const std::string path = testing::TempDir() + "hawser_index.ply";
  std::ofstream(path)
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n3 0 1 363\n";
  try {
    io::read_mesh(path);
    FAIL() << "was accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("face number 1 names vertex 363, but there are 3"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace hawser::case_mesh_fuzz_test
