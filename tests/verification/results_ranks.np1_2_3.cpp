// A results file is the same, byte for byte, on any number of ranks, and a checkpoint is read bit for bit on
// another number of ranks.
#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>

#include "hawser/base/error.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/io/results.hpp"
#include "hawser/io/write_error.hpp"

namespace hawser::io::results_ranks {
namespace {

int rank_of(MPI_Comm comm) {
  int r = 0;
  MPI_Comm_rank(comm, &r);
  return r;
}
int size_of(MPI_Comm comm) {
  int n = 0;
  MPI_Comm_size(comm, &n);
  return n;
}

std::string temporary(const std::string& name) { return ::testing::TempDir() + "results_" + name; }

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ResultContents contents() {
  ResultContents c;
  c.run = {"hawser: 1\ntitle: test\n", "test.yaml", "0.1.0", "-ksp_view", "2024-01-01T00:00:00Z", 1};
  c.lines = {{0, 25}, {25, 5}, {30, 11}};
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) c.line_labels = {{"hose", {}}, {"mooring/1", {}}, {"mooring:1", {}}};
  for (size_t l = 0; l < c.line_labels.size(); ++l)
    for (int i = 0; i < c.lines[l].nodes; ++i) c.line_labels[l].arc.push_back(2.5 * i);
  c.fields = {{"position", "m", 3}, {"effective_tension", "N", 1}, {"bending_moment", "N m", 3}};
  c.series = {{"end A", {{"position", "m", 3}, {"effective_tension", "N", 1}}},
              {"energy", {{"kinetic", "J", 1}}},
              {"touchdown", {{"arc_length", "m", 1}, {"position", "m", 3}}, true}};
  c.bodies = {"reel"};
  static const std::vector<Vec3> kDrum = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 kFloor = {{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}};
  static const std::vector<std::array<int, 3>> kSides = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
                                               kTriangle = {{0, 1, 2}};
  c.volumes = {{"drum", 0, kDrum, kSides, {1, 0, 1, 1}, nullptr},
               {"floor", -1, kFloor, kTriangle, {1}, nullptr}};
  c.clashes = true;
  c.contact_points = true;
  c.expected_outputs = 3;  // small: the file is enlarged twice
  c.expected_steps = 4;
  return c;
}

// Nodes in groups of five, assigned to the ranks in turn; on three ranks the last one has none.
std::vector<int> owned_nodes(MPI_Comm comm, int total) {
  const int ranks = std::min(size_of(comm), 2);
  std::vector<int> owned;
  for (int n = 0; n < total; ++n)
    if (n / 5 % ranks == rank_of(comm)) owned.push_back(n);
  return owned;
}

double of_line(double t, size_t line, int column) { return t + 100. * static_cast<double>(line) + column; }

double value(int output, int field, int node, int component) {
  return std::sin(1.0 + output) * 1e3 + field * 100 + node + component / 7.0;
}

constexpr int kPoints = 97;  // so many that their tables must be enlarged

void write_rows(ResultsFile& file, MPI_Comm comm, const std::vector<int>& owned, int from, int to) {
  const auto& c = file.contents();
  for (int k = from; k < to; ++k) {
    for (int step = 0; step < 3; ++step) {
      std::vector<std::vector<double>> rows(3);
      const double t = k - 1 + (step + 1) / 3.0;
      if (rank_of(comm) == std::min(size_of(comm), 2) - 1) rows[0] = {t, 2 * t, 3 * t, 4 * t};
      if (rank_of(comm) == 0) rows[1] = {t * t};
      for (size_t l = 0; l < c.lines.size(); ++l)
        for (int i = 0; i < 4 && std::binary_search(owned.begin(), owned.end(), c.lines[l].first_node); ++i)
          rows[2].push_back(of_line(t, l, i));
      file.append_series(t, rows);
    }
    std::vector<std::vector<double>> fields(c.fields.size());
    for (size_t f = 0; f < fields.size(); ++f)
      for (const int n : owned)
        for (int i = 0; i < c.fields[f].components; ++i)
          fields[f].push_back(value(k, static_cast<int>(f), n, i));
    const BodyPose pose{Vec3(k, 0, 0), Quat(Eigen::AngleAxisd(0.1 * k, Vec3::UnitY()))};
    ClashTables clashes;
    if (rank_of(comm) == 0) {
      clashes.ended.resize(static_cast<size_t>(17 * k));
      clashes.open.resize(2);
    }
    // The first rank has some of the points, the other rank with nodes the rest.
    ContactRows contacts;
    const int others = std::min(size_of(comm), 2) - 1;
    for (int i = 0; i < kPoints * (k % 3); ++i)
      if (rank_of(comm) == (i < kPoints ? 0 : others))
        contacts.push_back({k, -1, i, -1, Vec3(k, i, 0.5), Vec3(-i, k, 0.25)});
    file.write_output(k, fields, {&pose, 1}, clashes, {}, contacts);
  }
}

Checkpoint checkpoint(const std::vector<int>& owned, double time) {
  Checkpoint c;
  c.time = time;
  c.scalars = {{"step", 0.1}, {"negative zero", -0.0}};
  auto& x = c.nodes["position"];
  x.components = 3;
  c.nodes["tension"].components = 1;
  c.records["none"];
  TermCheckpoint& drum = c.records["friction drum"];
  drum.kinds = {{"points of it", {{"slip of it", 1, "N m"}}}, {"sums", {{"work", 1, ""}}}};
  for (const int n : owned) {
    for (int i = 0; i < 3; ++i) x.values.push_back(std::sqrt(n + i / 3.0) * time);
    c.nodes["tension"].values.push_back(n % 4 == 0 ? std::numeric_limits<double>::denorm_min()
                                        : n % 4 == 1
                                            ? std::bit_cast<double>(0x7ff8dead00000001ULL + unsigned(n))
                                            : -1.0 / n);
    for (int key = n % 3; key > 0; --key)
      drum.records.push_back({n, key, std::vector<double>(static_cast<size_t>(n % 5), n + 0.1 * key), n % 2});
  }
  return c;
}

std::vector<std::uint64_t> bits(const std::vector<double>& v) {
  std::vector<std::uint64_t> b;
  for (const double x : v) b.push_back(std::bit_cast<std::uint64_t>(x));
  return b;
}

void expect_same(const Checkpoint& a, Checkpoint b) {
  EXPECT_EQ(a.time, b.time);
  ASSERT_EQ(a.scalars.size(), b.scalars.size());
  for (const auto& [name, v] : a.scalars) EXPECT_EQ(bits({v}), bits({b.scalars.at(name)})) << name;
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (const auto& [name, f] : a.nodes) {
    EXPECT_EQ(f.components, b.nodes.at(name).components);
    EXPECT_EQ(bits(f.values), bits(b.nodes.at(name).values)) << name;
  }
  ASSERT_EQ(a.records.size(), b.records.size());
  for (const auto& [name, kept] : a.records) {
    const auto& list = kept.records;
    auto& other = b.records.at(name).records;
    EXPECT_EQ(kept.kinds, b.records.at(name).kinds) << name;
    std::stable_sort(other.begin(), other.end(), [](const CheckpointRecord& p, const CheckpointRecord& q) {
      return p.node != q.node ? p.node < q.node : p.key < q.key;
    });
    ASSERT_EQ(list.size(), other.size()) << name;
    for (size_t i = 0; i < list.size(); ++i) {
      EXPECT_EQ(list[i].node, other[i].node);
      EXPECT_EQ(list[i].key, other[i].key);
      EXPECT_EQ(list[i].kind, other[i].kind);
      EXPECT_EQ(bits(list[i].values), bits(other[i].values));
    }
  }
}

void write_run(MPI_Comm comm, const std::string& path, bool finish) {
  const auto owned = owned_nodes(comm, contents().nodes_total());
  auto file = ResultsFile::create(comm, path, contents(), owned);
  write_rows(file, comm, owned, 0, 5);
  file.write_checkpoint(checkpoint(owned, 4));
  write_rows(file, comm, owned, 5, 8);
  file.write_checkpoint(checkpoint(owned, 7));
  if (finish)
    file.finish({{"max effective tension", "hose", 670e3, "N", 3, 25}, {"min", "mooring/1", -1, "N", 0, 0}});
}

// Outputs in quick succession are written together; nodes of bodies with mass come after those of the lines.
void expect_rows_of_lines(bool single) {
  constexpr int kOutputs = 40, kBodies = 2;
  ResultContents c = contents();
  c.body_nodes = kBodies;
  c.clashes = false;
  c.single_precision = single;
  const int nodes = c.nodes_total();
  const std::string path = temporary("bodies.h5");
  const auto owned = owned_nodes(MPI_COMM_WORLD, nodes + kBodies);
  {
    auto file = ResultsFile::create(MPI_COMM_WORLD, path, c, owned);
    write_rows(file, MPI_COMM_WORLD, owned, 0, kOutputs);
    file.finish({});
  }
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const h5::Id file = h5::open_read(path);
  for (size_t f = 0; f < c.fields.size(); ++f) {
    const int components = c.fields[f].components;
    std::vector<double> all(static_cast<size_t>(kOutputs * nodes * components));
    const h5::Id set = h5::open_dataset(file, "fields/" + c.fields[f].name);
    ASSERT_EQ(h5::shape_of(set)[0], static_cast<hsize_t>(kOutputs));
    const hid_t type = H5Dget_type(set);
    EXPECT_EQ(H5Tget_size(type), single ? 4U : 8U);
    H5Tclose(type);
    ASSERT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
    size_t i = 0;
    for (int k = 0; k < kOutputs; ++k)
      for (int n = 0; n < nodes; ++n)
        for (int j = 0; j < components; ++j) {
          const double v = value(k, static_cast<int>(f), n, j);
          ASSERT_EQ(all[i++], single ? static_cast<double>(static_cast<float>(v)) : v)
              << c.fields[f].name << " " << k << " " << n;
        }
  }
  std::ifstream xdmf(temporary("bodies.xdmf"));
  const std::string text(std::istreambuf_iterator<char>(xdmf), {});
  const auto at = text.find("bodies.h5:/fields/position");
  ASSERT_NE(at, std::string::npos);
  const auto precision = text.rfind("Precision=", at);
  EXPECT_EQ(text.substr(precision, 13), single ? "Precision=\"4\"" : "Precision=\"8\"");
}

TEST(ResultsRanks, RowsOfLinesBesideNodesOfBodies) { expect_rows_of_lines(false); }
TEST(ResultsRanks, RowsInSinglePrecision) { expect_rows_of_lines(true); }

TEST(ResultsRanks, FileIsTheSameAsFromOneRank) {
  for (const bool finish : {false, true}) {
    const std::string together = temporary("together.h5");
    const std::string alone = temporary("alone.h5");
    write_run(MPI_COMM_WORLD, together, finish);
    if (rank_of(MPI_COMM_WORLD) == 0) {
      write_run(MPI_COMM_SELF, alone, finish);
      const std::string a = bytes_of(together);
      const std::string b = bytes_of(alone);
      EXPECT_GT(a.size(), 10000u);
      EXPECT_TRUE(a == b) << "files differ";
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }
}

TEST(ResultsRanks, EveryValueIsInItsPlace) {
  const std::string path = temporary("values.h5");
  write_run(MPI_COMM_WORLD, path, true);
  if (rank_of(MPI_COMM_WORLD) == 0) {
    const auto c = contents();
    const auto file = h5::open_read(path);
    for (size_t f = 0; f < c.fields.size(); ++f) {
      const auto a = h5::read_array(file, "fields/" + c.fields[f].name);
      ASSERT_EQ(a.shape[0], 8u);
      ASSERT_EQ(a.shape[1], 41u);
      size_t at = 0;
      for (int k = 0; k < 8; ++k)
        for (int n = 0; n < 41; ++n)
          for (int i = 0; i < c.fields[f].components; ++i)
            ASSERT_EQ(a.values[at++], value(k, static_cast<int>(f), n, i));
    }
    const auto series = h5::read_array(file, "series/end_A");
    ASSERT_EQ(series.shape, (h5::Shape{24, 4}));
    const auto time = h5::read_array(file, "series/time");
    for (size_t i = 0; i < 24; ++i) {
      EXPECT_NEAR(time.values[i], -1 + (static_cast<double>(i) + 1) / 3, 1e-14);
      EXPECT_EQ(series.values[4 * i + 3], 4 * time.values[i]);
    }
    const auto by_line = h5::read_array(file, "line_series/touchdown");
    ASSERT_EQ(by_line.shape, (h5::Shape{24, 3, 4}));
    for (size_t i = 0; i < by_line.values.size(); ++i)
      EXPECT_EQ(by_line.values[i], of_line(time.values[i / 12], i / 4 % 3, static_cast<int>(i % 4)));
    const auto moved = h5::read_array(file, "volumes/drum/moved");
    // Vertex 1 is (1, 0, 0) in the body frame; about y by 0.7 rad, then moved by 7 along x.
    EXPECT_NEAR(moved.values[7 * 12 + 3], 7 + std::cos(0.7), 1e-6);
    EXPECT_NEAR(moved.values[7 * 12 + 5], -std::sin(0.7), 1e-6);
    const auto counts = h5::read_array(file, kContactCounts);
    const auto places = h5::read_array(file, kContactPositions);
    const auto forces = h5::read_array(file, kContactForces);
    const auto pairs = h5::read_array(file, kContactPairs);
    size_t row = 0;
    for (int k = 0; k < 8; ++k) {
      for (int i = 0; i < kPoints * (k % 3); ++i, ++row) {
        ASSERT_LT(row, places.shape[0]);
        EXPECT_EQ(pairs.values[4 * row], k);
        EXPECT_EQ(pairs.values[4 * row + 1], -1);
        EXPECT_EQ(pairs.values[4 * row + 2], i);
        EXPECT_EQ(places.values[3 * row + 1], i);
        EXPECT_EQ(forces.values[3 * row + 1], k);
      }
      EXPECT_EQ(counts.values[static_cast<size_t>(k)], static_cast<double>(row));
    }
    EXPECT_EQ(places.shape[0], row);
    EXPECT_EQ(h5::read_text(file, "case"), c.run.case_text);
    EXPECT_EQ(h5::read_texts(file, "lines/name")[2], "mooring:1");
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(ResultsRanks, CheckpointComesBackOnAnyRanks) {
  const std::string path = temporary("checkpoint.h5");
  write_run(MPI_COMM_WORLD, path, false);
  // Read by one rank with all nodes, and by the same ranks with another partition.
  std::vector<int> all;
  for (int n = 0; n < 41; ++n) all.push_back(n);
  expect_same(read_checkpoint(MPI_COMM_SELF, path, 41, all), checkpoint(all, 7));
  std::vector<int> mine;
  for (int n = 0; n < 41; ++n)
    if (n * size_of(MPI_COMM_WORLD) / 41 == rank_of(MPI_COMM_WORLD)) mine.push_back(n);
  expect_same(read_checkpoint(MPI_COMM_WORLD, path, 41, mine), checkpoint(mine, 7));
  // Written by one rank, read by all.
  if (rank_of(MPI_COMM_WORLD) == 0) write_run(MPI_COMM_SELF, path, true);
  MPI_Barrier(MPI_COMM_WORLD);
  expect_same(read_checkpoint(MPI_COMM_WORLD, path, 41, mine), checkpoint(mine, 7));
  EXPECT_THROW(read_checkpoint(MPI_COMM_WORLD, path, 40, {}), InputError);
}

TEST(ResultsRanks, ResumedFileIsTheSameAsOneInOneGo) {
  const std::string path = temporary("resumed.h5");
  const std::string straight = temporary("straight.h5");
  write_run(MPI_COMM_WORLD, straight, true);
  const auto owned = owned_nodes(MPI_COMM_WORLD, 41);
  {
    auto file = ResultsFile::create(MPI_COMM_WORLD, path, contents(), owned);
    write_rows(file, MPI_COMM_WORLD, owned, 0, 5);
    file.write_checkpoint(checkpoint(owned, 4));
    write_rows(file, MPI_COMM_WORLD, owned, 5, 6);  // accepted, but after the checkpoint
  }
  {
    const Checkpoint from = read_checkpoint(MPI_COMM_WORLD, path, 41, owned);
    auto file = ResultsFile::resume(MPI_COMM_WORLD, path, contents(), owned, from.time, from.sequence);
    EXPECT_EQ(file.outputs(), 5);
    write_rows(file, MPI_COMM_WORLD, owned, 5, 8);
    file.write_checkpoint(checkpoint(owned, 7));
    file.finish({{"max effective tension", "hose", 670e3, "N", 3, 25}, {"min", "mooring/1", -1, "N", 0, 0}});
  }
  if (rank_of(MPI_COMM_WORLD) == 0) {
    const auto a = h5::open_read(path);
    const auto b = h5::open_read(straight);
    for (const char* name :
         {"outputs/time", "fields/position", "fields/effective_tension", "series/time", "series/end_A",
          "series/energy", kContactCounts, kContactPairs, kContactPositions, kContactForces,
          "line_series/touchdown", "bodies/rotation", "volumes/drum/moved"}) {
      const auto p = h5::read_array(a, name);
      const auto q = h5::read_array(b, name);
      EXPECT_EQ(p.shape, q.shape) << name;
      EXPECT_EQ(bits(p.values), bits(q.values)) << name;
    }
  }
  MPI_Barrier(MPI_COMM_WORLD);
  auto other = contents();
  if (!other.line_labels.empty()) other.line_labels[1].arc[3] += 0.5;
  EXPECT_THROW(ResultsFile::resume(MPI_COMM_WORLD, path, other, owned, 4, 2), InputError);
  // A path below a file is invalid, also for root.
  EXPECT_THROW(ResultsFile::create(MPI_COMM_WORLD, path + "/run.h5", contents(), owned), WriteError);
}

// A checkpoint of three nodes as one array, on one rank.
struct Array {
  std::string index;
  std::vector<double> values;
};
Array array_of(const Checkpoint& c) {
  const std::vector<int> owned{0, 1, 2};
  const CheckpointRoom room = checkpoint_room(MPI_COMM_SELF, c, 3, owned);
  Array whole{room.index, std::vector<double>(static_cast<size_t>(room.size), -1)};
  write_checkpoint_array(MPI_COMM_SELF, c, room, 3, owned,
                         [&](const std::vector<RowRun>& runs, const std::vector<double>& values) {
                           auto from = values.begin();
                           for (const RowRun& r : runs) {
                             std::copy_n(from, r.count, whole.values.begin() + r.first);
                             from += r.count;
                           }
                         });
  return whole;
}
Checkpoint unpack(const Array& whole, const std::vector<int>& owned, std::vector<int>* asked = nullptr) {
  return unpack_checkpoint(whole.index, std::ssize(whole.values), 3, owned, [&](const RowRun& run) {
    for (long long at = run.first; asked && at < run.first + run.count; ++at) ++asked->at(at);
    const auto first = whole.values.begin() + run.first;
    return std::vector<double>(first, first + run.count);
  });
}

// Node 1 has the first records of "friction drum", with one value each. Layout: the time, two scalars, two
// fields; then the number of records, and their node, kind, key and number of values.
constexpr size_t kRecords = 3 + 3 * 3 + 3;

TEST(ResultsRanks, CorruptedCountersOfACheckpointAreReported) {
  const Array whole = array_of(checkpoint({0, 1, 2}, 7));
  ASSERT_EQ(whole.values[kRecords + 1], 1);
  ASSERT_EQ(whole.values[kRecords + 4], 1);
  const size_t begins = kRecords + 1 + static_cast<size_t>(whole.values[kRecords]);
  for (const size_t at : {kRecords, kRecords + 1, kRecords + 2, kRecords + 4, begins})
    for (const double wrong : {-1.0, std::nan(""), 1e300}) {
      Array other = whole;
      other.values[at] = wrong;
      EXPECT_THROW(unpack(other, {0, 1, 2}), InputError) << at << ": " << wrong;
    }
}

// A rank reads the node data of its own nodes only; all ranks together read everything.
TEST(ResultsRanks, NodesOfOthersAreNotRead) {
  const Array whole = array_of(checkpoint({0, 1, 2}, 7));
  std::vector<int> asked(whole.values.size(), 0);
  for (int node = 0; node < 3; ++node) {
    std::vector<int> here(whole.values.size(), 0);
    expect_same(unpack(whole, {node}, &here), checkpoint({node}, 7));
    for (size_t at = 3; at < kRecords; ++at)
      EXPECT_EQ(here[at], (at < 12 ? (at - 3) / 3 : at - 12) == static_cast<size_t>(node))
          << node << " " << at;
    for (size_t at = 0; at < here.size(); ++at) asked[at] += here[at];
  }
  for (size_t at = 0; at < asked.size(); ++at) EXPECT_GT(asked[at], 0) << at;
  const long long read = std::accumulate(asked.begin(), asked.end(), 0LL);
  // Each of three ranks reads the time, the scalars and two lengths of records; two ranks also read where the
  // records of the second and the third node begin.
  EXPECT_EQ(read, std::ssize(asked) + 2 * (3 + 2) + 2);
}

// Changes a number of the array in a slot of the file `path`.
void damage(const std::string& path, const std::string& slot, hsize_t at) {
  const h5::Id access = h5::serial_access();
  const h5::Id file = h5::own(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose, path);
  const h5::Id set = h5::open_dataset(file, slot + "/values");
  const h5::Id from = h5::own(H5Dget_space(set), H5Sclose, path);
  const hsize_t one = 1;
  const h5::Id memory = h5::own(H5Screate_simple(1, &one, nullptr), H5Sclose, path);
  H5Sselect_hyperslab(from, H5S_SELECT_SET, &at, nullptr, &one, nullptr);
  const double wrong = 1.25;
  h5::check(H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, from, H5P_DEFAULT, &wrong), path);
}

// If the newer checkpoint is damaged at any place, in the part of any rank, all ranks read the older one.
TEST(ResultsRanks, DamagedCheckpointIsPassedOver) {
  const std::string path = temporary("damaged.h5");
  const auto owned = owned_nodes(MPI_COMM_WORLD, 41);
  for (const double place : {0.0, 0.5, 1.0}) {
    {
      auto file = ResultsFile::create(MPI_COMM_WORLD, path, contents(), owned);
      file.write_checkpoint(checkpoint(owned, 4));
      file.write_checkpoint(checkpoint(owned, 5));
    }
    EXPECT_EQ(read_checkpoint(MPI_COMM_WORLD, path, 41, owned).sequence, 2);
    const auto change = [&](const std::string& slot) {
      MPI_Barrier(MPI_COMM_WORLD);
      if (rank_of(MPI_COMM_WORLD) == 0) {
        std::uint64_t header[4] = {};
        h5::read_part(h5::open_dataset(h5::open_read(path), slot + "/header"), H5T_NATIVE_UINT64, 0, 4,
                      header);
        damage(path, slot, static_cast<hsize_t>(place * static_cast<double>(header[1] - 1)));
      }
      MPI_Barrier(MPI_COMM_WORLD);
    };
    change("checkpoint/0");
    const Checkpoint older = read_checkpoint(MPI_COMM_WORLD, path, 41, owned);
    EXPECT_EQ(older.sequence, 1) << place;
    expect_same(older, checkpoint(owned, 4));
    change("checkpoint/1");
    EXPECT_THROW(read_checkpoint(MPI_COMM_WORLD, path, 41, owned), InputError) << place;
  }
}

TEST(ResultsRanks, WhatOneRankCannotReadIsReportedByAll) {
  const std::string path = temporary("unreadable.h5");
  write_run(MPI_COMM_WORLD, path, false);
  const bool last = rank_of(MPI_COMM_WORLD) == size_of(MPI_COMM_WORLD) - 1;
  const auto owned = owned_nodes(MPI_COMM_WORLD, 41);
  EXPECT_THROW(read_checkpoint(MPI_COMM_WORLD, last ? path + ".none" : path, 41, owned), InputError);
  // The error of one rank that requests nodes that do not exist.
  EXPECT_THROW(read_checkpoint(MPI_COMM_WORLD, path, 41, last ? std::vector<int>{1000} : owned), InputError);
}

TEST(ResultsRanks, ErrorOfOneRankReachesAll) {
  const auto owned = owned_nodes(MPI_COMM_WORLD, 41);
  auto file = ResultsFile::create(MPI_COMM_WORLD, temporary("error.h5"), contents(), owned);
  std::vector<std::vector<double>> fields{std::vector<double>(owned.size() * 3),
                                          std::vector<double>(owned.size()),
                                          std::vector<double>(owned.size() * 3)};
  if (rank_of(MPI_COMM_WORLD) == 0) fields[1].pop_back();
  const BodyPose pose;
  EXPECT_THROW(file.write_output(0, fields, {&pose, 1}), std::runtime_error);
  EXPECT_EQ(file.outputs(), 0);
}

}  // namespace
}  // namespace hawser::io::results_ranks
