// Meshes from files: welding, closing, orientation, scale; notes on repairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/io/mesh_reader.hpp"

namespace hawser::case_mesh_reader_test {
namespace {

namespace fs = std::filesystem;

const std::string kBox = HAWSER_SOURCE_DIR "/tests/data/bad/box.obj";

std::string temporary(const std::string& name, const std::string& text) {
  const fs::path folder = fs::path(testing::TempDir()) / "hawser_meshes";
  fs::create_directories(folder);
  std::ofstream(folder / name) << text;
  return (folder / name).string();
}

std::string facet(const char* a, const char* b, const char* c) {
  return std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b + "\nvertex " + c +
         "\nendloop\nendfacet\n";
}

std::string tetrahedron(const std::string& name, const char* o, const char* x, const char* y, const char* z,
                        bool outward) {
  std::string s = "solid " + name + "\n";
  if (outward)
    s += facet(o, y, x) + facet(o, x, z) + facet(o, z, y) + facet(x, y, z);
  else
    s += facet(o, x, y) + facet(o, z, x) + facet(o, y, z) + facet(x, z, y);
  return s + "endsolid " + name + "\n";
}

TEST(CaseMeshReader, ObjWithGroups) {
  const io::LoadedMesh m = io::read_mesh(kBox, 0.5);
  EXPECT_EQ(m.mesh.triangles.size(), 12U);
  EXPECT_EQ(m.mesh.vertices.size(), 8U);
  EXPECT_TRUE(m.report.valid());
  EXPECT_DOUBLE_EQ(m.report.volume, 1);  // 2 m box at half scale
  EXPECT_TRUE(m.notes.empty());
  model::Volume v;
  v.active_part = "top";
  std::vector<bool> active = io::active_triangles(m.mesh, v);
  EXPECT_EQ(std::count(active.begin(), active.end(), true), 2);
  v.active_part.clear();
  active = io::active_triangles(m.mesh, v);
  EXPECT_EQ(std::count(active.begin(), active.end(), true), 12);
  v.active_box = model::Box{Vec3(-1, -1, 0.9), Vec3(2, 2, 1.1)};
  active = io::active_triangles(m.mesh, v);
  EXPECT_EQ(std::count(active.begin(), active.end(), true), 2);
  v.active_box = model::Box{Vec3(5, 5, 5), Vec3(6, 6, 6)};
  EXPECT_THROW(io::active_triangles(m.mesh, v), InputError);
}

// The drum's file repeats every corner, in single precision.
TEST(CaseMeshReader, DrumIsWeldedAndClosed) {
  const io::LoadedMesh m = io::read_mesh(HAWSER_SOURCE_DIR "/cases/reel/drum.stl");
  EXPECT_TRUE(m.report.valid());
  EXPECT_EQ(m.report.components, 1);
  // Euler: V - E + F = 2 with 2 E = 3 F.
  EXPECT_EQ(2 * m.mesh.vertices.size(), m.mesh.triangles.size() + 4);
  EXPECT_EQ(m.report.welded, static_cast<int>(3 * m.mesh.triangles.size() - m.mesh.vertices.size()));
  // Barrel and two flanges with 96-gons for circles: area of a regular n-gon is n/2 sin(2 pi/n) R².
  const double area = 48 * std::sin(2 * std::numbers::pi / 96);
  EXPECT_NEAR(m.report.volume, area * (3.6 * 3.6 * 5.5 + 2 * 6.4 * 6.4 * 0.15), 0.01);
}

TEST(CaseMeshReader, StlSolidsAreParts) {
  const std::string path =
      temporary("two.stl", tetrahedron("left", "0 0 0", "1 0 0", "0 1 0", "0 0 1", true) +
                               tetrahedron("right", "5 0 0", "6 0 0", "5 1 0", "5 0 1", true));
  const io::LoadedMesh m = io::read_mesh(path);
  EXPECT_EQ(m.mesh.parts, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(m.mesh.part, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(m.mesh.vertices.size(), 8U);
  EXPECT_NEAR(m.report.volume, 2.0 / 6, 1e-12);
}

TEST(CaseMeshReader, InsideOutIsTurnedWithANote) {
  const io::LoadedMesh m =
      io::read_mesh(temporary("inside.stl", tetrahedron("t", "0 0 0", "1 0 0", "0 1 0", "0 0 1", false)));
  EXPECT_TRUE(m.report.valid());
  EXPECT_NEAR(m.report.volume, 1.0 / 6, 1e-12);
  ASSERT_EQ(m.notes.size(), 1U);
  EXPECT_NE(m.notes[0].find("inside.stl"), std::string::npos);
}

TEST(CaseMeshReader, CornersThatDifferByRoundingAreWelded) {
  std::string text = tetrahedron("t", "1000 0 0", "1001 0 0", "1000 1 0", "1000 0 1", true);
  text.replace(text.find("1001 0 0"), 8, "1001.0001 0 0");  // half a unit in the last place of a float
  EXPECT_TRUE(io::read_mesh(temporary("rounded.stl", text)).report.valid());
  std::string apart = tetrahedron("t", "1000 0 0", "1001 0 0", "1000 1 0", "1000 0 1", true);
  apart.replace(apart.find("1001 0 0"), 8, "1001.02 0 0");
  EXPECT_THROW(io::read_mesh(temporary("apart.stl", apart), 1, true), InputError);
}

TEST(CaseMeshReader, PlyWithQuadrilaterals) {
  const io::LoadedMesh m = io::read_mesh(
      temporary("cube.PLY",
                "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
                "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                "4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n4 4 5 6 7\n"),
      3);
  EXPECT_EQ(m.mesh.triangles.size(), 12U);
  EXPECT_NEAR(m.report.volume, 27, 1e-12);
}

TEST(CaseMeshReader, OpenMeshIsRefusedWhereClosedIsRequired) {
  try {
    io::read_mesh(HAWSER_SOURCE_DIR "/tests/data/bad/open_box.obj", 1, true);
    FAIL() << "was accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("3 open edges"), std::string::npos) << e.what();
  }
}

TEST(CaseMeshReader, StlTextsAsTheyAreWritten) {
  const std::string small = tetrahedron("Left Part", "0 0 0", "1 0 0", "0 1e0 0", "+0 0 1.0", true);
  std::string upper = small;
  std::string windows;
  std::string tabs = small;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const char c : small) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::replace(tabs.begin(), tabs.end(), ' ', '\t');
  const std::pair<const char*, std::string> texts[] = {{"small", small},
                                                       {"upper case", upper},
                                                       {"line ends", windows},
                                                       {"tabs", tabs},
                                                       {"blanks", " \n\n  " + small},
                                                       {"mark", "\xef\xbb\xbf" + small},
                                                       {"no end", small.substr(0, small.find("endsolid"))}};
  for (const auto& [what, text] : texts) {
    const io::LoadedMesh m = io::read_mesh(temporary("text.stl", text));
    EXPECT_TRUE(m.report.valid()) << what;
    EXPECT_NEAR(m.report.volume, 1.0 / 6, 1e-15) << what;
    ASSERT_EQ(m.mesh.parts.size(), 1U) << what;
  }
  EXPECT_EQ(io::read_mesh(temporary("text.stl", small)).mesh.parts[0], "Left Part");
}

// 80 bytes of header, the number of facets, 50 bytes each.
std::string binary(std::string header, std::uint32_t message, int facets) {
  const std::array<std::array<float, 9>, 4> corners = {{{0, 0, 0, 0, 1, 0, 1, 0, 0},
                                                        {0, 0, 0, 1, 0, 0, 0, 0, 1},
                                                        {0, 0, 0, 0, 0, 1, 0, 1, 0},
                                                        {1, 0, 0, 0, 1, 0, 0, 0, 1}}};
  header.resize(80, ' ');
  const auto put = [&](const auto& x) { header.append(reinterpret_cast<const char*>(&x), sizeof x); };
  put(message);
  for (int f = 0; f < facets; ++f) {
    put(std::array<float, 3>{});
    put(corners[static_cast<std::size_t>(f % 4)]);
    put(std::uint16_t{0});
  }
  return header;
}

TEST(CaseMeshReader, BinaryStlOfAnyHeader) {
  for (const char* header : {"", "solid", "SOLID exported", "COLOR=..."})
    EXPECT_NEAR(io::read_mesh(temporary("b.stl", binary(header, 4, 4))).report.volume, 1.0 / 6, 1e-7)
        << header;
}

TEST(CaseMeshReader, StlFilesThatAreRefusedReportWhatWasFound) {
  const std::string well_formed = tetrahedron("t", "0 0 0", "1 0 0", "0 1 0", "0 0 1", true);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string s = well_formed;
    return s.replace(s.find(from), from.size(), to);
  };
  const std::pair<std::string, const char*> files[] = {
      {binary("", 4, 4).substr(0, 200), "it states 4 facets, which are 284 bytes, but there are 200"},
      {binary("", 4000000000, 4), "it states 4000000000 facets"},
      {binary("", 0, 0), "has a number of facets of 0"},
      {"solid t\nendsolid t\n", "the STL text has no facets"},
      {"hello", "is no STL file: a text begins with 'solid'"},
      {with("vertex 0 1 0", "vertex 0 1,5 0"), "line 5 of the STL text should have a number, not '1,5'"},
      {with("endloop", "vertex 1 1 1"), "line 7 of the STL text should have 'endloop', as a facet has three"},
      {well_formed.substr(0, well_formed.rfind("endloop")),
       "should have 'endloop', as a facet has three corners, not the end"}};
  for (const auto& [text, expected] : files) try {
      io::read_mesh(temporary("refused.stl", text));
      FAIL() << "was accepted: " << expected;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(expected), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("refused.stl"), std::string::npos) << e.what();
    }
}

// A deck listed twice, back to back, is kept once; a box without thickness is refused, whatever its
// triangulation.
TEST(CaseMeshReader, DoubledDecksStayAndSheetsAreRefused) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  const std::string box = vertices +
                          "f 1 4 3\nf 1 3 2\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\n"
                          "f 4 1 5\nf 4 5 8\nf 5 6 7\nf 5 7 8\n";
  const io::LoadedMesh m = io::read_mesh(temporary("deck.obj", box + "f 5 7 6\nf 5 8 7\n"), 1, true);
  EXPECT_TRUE(m.report.valid());
  EXPECT_DOUBLE_EQ(m.report.volume, 1);
  ASSERT_EQ(m.notes.size(), 1U);
  EXPECT_NE(m.notes[0].find("deck.obj: 2 triangles that are listed more than once, excluded"),
            std::string::npos)
      << m.notes[0];
  for (const char* faces : {"f 1 2 3\nf 1 3 4\nf 1 3 2\nf 1 4 3\n", "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n"})
    try {
      io::read_mesh(temporary("flat.obj", vertices + faces));
      FAIL() << "was accepted: " << faces;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("a sheet needs a thickness"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace hawser::case_mesh_reader_test
