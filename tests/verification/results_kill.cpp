// Every output, series row and checkpoint that was reported as accepted survives kill -9 at any moment. A
// child (this program again) writes as fast as it can, grows its file, writes checkpoints and resumes from
// the last one; the parent kills it at random moments and reads the file.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <mpi.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

#include "hawser/io/hdf5.hpp"
#include "hawser/io/results.hpp"

namespace hawser::io::results_kill_test {
namespace {

// So large that writing takes much of the time and many kills interrupt it.
constexpr int kNodes = 5000, kState = 30, kSteps = 3, kOutputs = 60;
const char* const kFileVariable = "HAWSER_TEST_KILL_FILE";

ResultContents contents() {
  ResultContents c;
  c.run = {"hawser: 1\n", "kill.yaml", "0.1.0", "", "2024-01-01T00:00:00Z", 1};
  c.lines = {{0, kNodes}};
  c.line_labels = {{"hose", std::vector<double>(kNodes)}};
  for (int i = 0; i < kNodes; ++i) c.line_labels[0].arc[static_cast<size_t>(i)] = i;
  c.fields = {{"position", "m", 3}, {"state", "", kState}};
  c.series = {{"end A", {{"effective_tension", "N", 1}}}};
  c.bodies = {"reel"};
  static const std::vector<Vec3> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  static const std::vector<std::array<int, 3>> kTriangle = {{0, 1, 2}};
  c.volumes = {{"drum", 0, kCorners, kTriangle, {1}, nullptr}};
  c.clashes = true;
  c.contact_points = true;
  c.expected_outputs = 2;  // small: it is often killed while the file is enlarged
  c.expected_steps = 5;
  return c;
}

std::vector<int> all_nodes() {
  std::vector<int> n;
  for (int i = 0; i < kNodes; ++i) n.push_back(i);
  return n;
}

double value(int output, int i) { return output * 1e6 + i + 0.25; }

Checkpoint checkpoint(int output) {
  Checkpoint c;
  c.time = output;
  c.nodes["state"].components = kState;
  for (int i = 0; i < kNodes * kState; ++i) c.nodes["state"].values.push_back(value(output, i));
  TermCheckpoint& friction = c.records["friction"];
  friction.kinds = {{"points", {{"slip", 1, "m"}, {"force", 1, "N"}}}};
  for (int i = 0; i < kNodes; ++i)
    if (i % 100 < output % 100) friction.records.push_back({i, 0, {1.0 * i, 1.0 * output}});
  return c;
}

// Rows of output k; so many that the tables must be enlarged.
ClashRow clash(int output, int i) {
  ClashRow r;
  r.line = output;
  r.volume = i;
  r.start = output + 0.5;
  r.impulse = value(output, i);
  return r;
}
ClashTables clashes(int output) {
  ClashTables t;
  for (int i = 0; i < output % 7; ++i) t.ended.push_back(clash(output, i));
  for (int i = 0; i < 3 * (output % 40); ++i) t.open.push_back(clash(output, -1 - i));
  return t;
}
// Rows of output k: none for some outputs, and so many that the tables must be enlarged.
ContactRows contacts(int output) {
  ContactRows rows;
  for (int i = 0; i < 400 * (output % 30); ++i)
    rows.push_back({output, -1, i, -1, Vec3(output, i, 0.5), Vec3(-i, output, 0.25)});
  return rows;
}
bool same(const ClashRow& a, const ClashRow& b) {
  return a.line == b.line && a.volume == b.volume && a.start == b.start && a.impulse == b.impulse;
}

void write_for_ever(const std::string& path) {
  const auto owned = all_nodes();
  int next = 0;
  std::unique_ptr<ResultsFile> file;
  if (access(path.c_str(), F_OK) == 0) {
    double time = -1;
    long long sequence = 0;
    try {
      const Checkpoint from = read_checkpoint(MPI_COMM_SELF, path, kNodes, owned);
      time = from.time;
      sequence = from.sequence;
    } catch (const std::exception&) {  // killed before the first checkpoint
    }
    next = static_cast<int>(time) + 1;
    ReportedClashes message;
    for (int k = 0; k < next; ++k) message.ended += static_cast<long long>(clashes(k).ended.size());
    if (next > 0) message.open = clashes(next - 1).open;
    file = std::make_unique<ResultsFile>(
        ResultsFile::resume(MPI_COMM_SELF, path, contents(), owned, time, sequence, message));
    std::printf("resumed %d\n", next);
  } else {
    file = std::make_unique<ResultsFile>(ResultsFile::create(MPI_COMM_SELF, path, contents(), owned));
  }
  for (int k = next; k < kOutputs; ++k) {
    for (int s = 0; s < kSteps; ++s) file->append_series(k - 1 + (s + 1.0) / kSteps, {{value(k, s)}});
    std::vector<std::vector<double>> fields(2);
    for (int i = 0; i < 3 * kNodes; ++i) fields[0].push_back(value(k, i));
    for (int i = 0; i < kNodes * kState; ++i) fields[1].push_back(value(k, -i));
    const BodyPose pose{Vec3(k, 0, 0), Quat::Identity()};
    file->write_output(k, fields, {&pose, 1}, clashes(k), {}, contacts(k));
    std::printf("output %lld\n", file->written() - 1);
    std::fflush(stdout);
    if (k % 3 != 2) continue;  // several outputs are written together
    file->write_checkpoint(checkpoint(k));
    std::printf("checkpoint %d\n", k);
    std::fflush(stdout);
  }
  file->finish({{"max", "hose", 1, "N", 0, 0}}, clashes(kOutputs));
  std::printf("end\n");
}

// Main function of the child; runs only if the variable is set.
TEST(ResultsKill, Child) {
  const char* path = std::getenv(kFileVariable);
  if (!path) GTEST_SKIP() << "run by ResultsKill.AcceptedOutputsSurvive";
  write_for_ever(path);
}

struct Progress {
  int outputs = -1, checkpoint = -1;  // last accepted
  bool end = false, spoke = false;
};

// Runs the child, kills it `seconds` after its first output, and returns the progress it has reported.
Progress run_and_kill(const std::string& path, double seconds) {
  int pipe_ends[2];
  if (pipe(pipe_ends)) throw std::runtime_error("pipe");
  const pid_t child = fork();
  if (child == 0) {
    dup2(pipe_ends[1], 1);
    close(pipe_ends[0]);
    close(pipe_ends[1]);
    // A new environment, so that MPI does not take the child for a part of the parent's job.
    const std::string file = std::string(kFileVariable) + "=" + path;
    std::vector<std::string> env{file};
    for (const char* name :
         {"PATH", "HOME", "TMPDIR", "TEST_TMPDIR", "LD_LIBRARY_PATH", "OMPI_ALLOW_RUN_AS_ROOT",
          "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_btl_vader_single_copy_mechanism",
          "OMPI_MCA_hwloc_base_binding_policy"})
      if (const char* v = std::getenv(name)) env.push_back(std::string(name) + "=" + v);
    std::vector<char*> envp;
    for (auto& e : env) envp.push_back(e.data());
    envp.push_back(nullptr);
    char self[] = "/proc/self/exe", filter[] = "--gtest_filter=ResultsKill.Child";
    char* argv[] = {self, filter, nullptr};
    execve(self, argv, envp.data());
    _exit(127);
  }
  close(pipe_ends[1]);
  std::string text;
  char buffer[4096];
  const auto has_begun = [&] {
    return text.find("output ") != std::string::npos || text.find("resumed ") != std::string::npos;
  };
  ssize_t n = 0;
  while (!has_begun() && (n = read(pipe_ends[0], buffer, sizeof buffer)) > 0)
    text.append(buffer, static_cast<size_t>(n));
  usleep(static_cast<useconds_t>(seconds * 1e6));
  kill(child, SIGKILL);
  while ((n = read(pipe_ends[0], buffer, sizeof buffer)) > 0) text.append(buffer, static_cast<size_t>(n));
  close(pipe_ends[0]);
  waitpid(child, nullptr, 0);

  Progress progress;
  progress.spoke = has_begun();
  for (size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    const std::string line = text.substr(at, end - at);
    std::sscanf(line.c_str(), "output %d", &progress.outputs);
    std::sscanf(line.c_str(), "checkpoint %d", &progress.checkpoint);
    progress.end = progress.end || line == "end";
  }
  return progress;
}

void expect_whole(const std::string& path, const Progress& progress) {
  const auto file = h5::open_read(path);
  std::int64_t written[2];
  {
    const auto set = h5::open_dataset(file, "written");
    const auto type = h5::own(H5Dget_type(set), H5Tclose, "type");
    ASSERT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, written), 0);
  }
  ASSERT_GE(written[0], progress.outputs + 1);
  ASSERT_EQ(written[1], kSteps * written[0]);
  const auto n = static_cast<size_t>(written[0]);
  const auto time = h5::read_array(file, "outputs/time");
  const auto x = h5::read_array(file, "fields/position");
  const auto state = h5::read_array(file, "fields/state");
  const auto end = h5::read_array(file, "series/end_A");
  const auto body = h5::read_array(file, "bodies/position");
  const auto moved = h5::read_array(file, "volumes/drum/moved");
  long wrong = 0;
  for (size_t k = 0; k < n; ++k) {
    const int out = static_cast<int>(k);
    wrong += time.values[k] != out;
    for (int i = 0; i < 3 * kNodes; ++i)
      wrong += x.values[3 * kNodes * k + static_cast<size_t>(i)] != value(out, i);
    for (int i = 0; i < kNodes * kState; ++i)
      wrong += state.values[kNodes * kState * k + static_cast<size_t>(i)] != value(out, -i);
    for (int s = 0; s < kSteps; ++s)
      wrong += end.values[kSteps * k + static_cast<size_t>(s)] != value(out, s);
    wrong += body.values[3 * k] != out;
    wrong += moved.values[9 * k + 3] != out + 1;
  }
  EXPECT_EQ(wrong, 0);

  if (n > 0) {
    const auto counts = h5::read_array(file, kContactCounts);
    const auto pairs = h5::read_array(file, kContactPairs);
    const auto at = h5::read_array(file, kContactPositions);
    const auto force = h5::read_array(file, kContactForces);
    size_t row = 0;
    for (size_t k = 0; k < n; ++k) {
      for (const ContactRow& r : contacts(static_cast<int>(k))) {
        ASSERT_LT(row, at.shape[0]);
        wrong += pairs.values[4 * row] != r.line || pairs.values[4 * row + 1] != -1 ||
                 pairs.values[4 * row + 2] != r.volume || pairs.values[4 * row + 3] != -1;
        for (int i = 0; i < 3; ++i) {
          wrong += at.values[3 * row + static_cast<size_t>(i)] != r.position[i];
          wrong += force.values[3 * row + static_cast<size_t>(i)] != r.force[i];
        }
        ++row;
      }
      wrong += counts.values[k] != static_cast<double>(row);
    }
    EXPECT_EQ(wrong, 0);
    if (progress.end) {
      EXPECT_EQ(at.shape[0], row);
    }
  }

  const int last = static_cast<int>(n) - 1;
  if (last >= 0) {
    const ClashTables tables = read_clashes(path);
    ClashTables right;
    for (int k = 0; k <= last + progress.end; ++k)
      for (const ClashRow& r : clashes(k).ended) right.ended.push_back(r);
    right.open = clashes(last + progress.end).open;
    ASSERT_EQ(tables.ended.size(), right.ended.size());
    EXPECT_TRUE(std::equal(right.ended.begin(), right.ended.end(), tables.ended.begin(), same));
    ASSERT_EQ(tables.open.size(), right.open.size()) << last;
    EXPECT_TRUE(std::equal(right.open.begin(), right.open.end(), tables.open.begin(), same));
  }

  if (progress.checkpoint >= 0) {
    const auto read = read_checkpoint(MPI_COMM_SELF, path, kNodes, all_nodes());
    const int k = static_cast<int>(read.time);
    EXPECT_GE(k, progress.checkpoint);
    EXPECT_LT(k, written[0]);
    const auto right = checkpoint(k);
    EXPECT_EQ(read.nodes.at("state").values, right.nodes.at("state").values);
    const auto& found = read.records.at("friction").records;
    const auto& records = right.records.at("friction").records;
    ASSERT_EQ(found.size(), records.size());
    for (size_t i = 0; i < records.size(); ++i) EXPECT_EQ(found[i].values, records[i].values);
  }

  std::ifstream in(path.substr(0, path.size() - 3) + ".xdmf");
  const std::string xml{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(xml.find("</Xdmf>\n"), std::string::npos);
}

TEST(ResultsKill, AcceptedOutputsSurvive) {
  const std::string path = ::testing::TempDir() + "results_kill.h5";
  std::mt19937 random(20240101);
  std::uniform_real_distribution<double> moment(0, 0.1);  // s; an output with its checkpoint takes some ms
  int kills = 0, resumed = 0, files = 0;
  std::remove(path.c_str());
  while (kills < 40) {
    const bool fresh = access(path.c_str(), F_OK) != 0;
    const Progress progress = run_and_kill(path, moment(random));
    ASSERT_TRUE(progress.spoke) << "the child did not start";
    expect_whole(path, progress);
    if (::testing::Test::HasFatalFailure() || ::testing::Test::HasNonfatalFailure())
      FAIL() << "after kill " << kills;
    if (fresh) ++files;
    if (progress.end || kills % 8 == 7) std::remove(path.c_str());
    if (progress.end) continue;
    ++kills;
    resumed += !fresh;
  }
  std::remove(path.c_str());
  std::printf("%d kills, %d of runs that had resumed, %d files\n", kills, resumed, files);
}

}  // namespace
}  // namespace hawser::io::results_kill_test
