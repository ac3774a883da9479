// One HDF5 file per run, with an XDMF file beside it for ParaView. The structure of the file is fixed when it
// is created: outputs fill existing rows, and a counter written last states how many are valid. The file is
// therefore valid at every moment, even if the run is killed (docs/decisions/010-files-that-survive.md;
// contents: docs/user-guide/results.md).
#pragma once

#include <mpi.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hawser/base/runs.hpp"
#include "hawser/geometry/coarse_mesh.hpp"
#include "hawser/io/checkpoint.hpp"
#include "hawser/io/clash_rows.hpp"
#include "hawser/io/contact_rows.hpp"
#include "hawser/math/types.hpp"
#include "hawser/system/field.hpp"

namespace hawser::io {

// On rank 0, which writes it.
struct RunInfo {
  std::string case_text, case_path, version, options, date;
  int ranks = 1;
  std::string changes = {};                // by --set, one KEY=VALUE per line; case_text excludes them
  std::string case_read = {};              // case_json.hpp
  std::vector<std::string> messages = {};  // notes and warnings up to creation; finish() writes all
};

// What rank 0 writes of a line.
struct ResultLineLabels {
  std::string name;
  std::vector<double> arc;  // m from end A, one a node
};

using ResultField = Field;  // only the columns name, unit and components

// Statistics per node and component: minimum and its time, maximum and its time, mean, standard deviation.
inline constexpr int kStatistics = 6;

// A named row of numbers at every step: a point of a line or sums such as the energies; or a table with one
// row per line.
struct ResultSeries {
  std::string name;
  std::vector<ResultField> columns;
  bool by_line = false;  // each rank writes the columns of the lines of which it has end A
};

struct BodyPose {
  Vec3 position = Vec3::Zero();      // m
  Quat rotation = Quat::Identity();  // body frame to space
};

struct VolumeMesh {
  std::string name;
  int body = -1;                   // index into the poses; -1: fixed, vertices in space axes
  std::span<const Vec3> vertices;  // m, in the body's frame
  std::span<const std::array<int, 3>> triangles;
  std::vector<char> active;          // one per triangle: takes part in contact
  std::shared_ptr<const void> keep;  // owner of the memory of vertices and triangles, if needed
  // Mesh for ParaView, with the `active` flags of its triangles; empty: the mesh itself. XDMF cannot express
  // rigid motion, so the vertices of a moving mesh are written at every output.
  CoarseMesh coarse{};
  std::vector<char> coarse_active{};

  bool moves() const { return body >= 0; }
  bool coarsened() const { return !coarse.vertices.empty(); }
  std::span<const Vec3> displayed_vertices() const { return coarsened() ? coarse.vertices : vertices; }
  std::span<const std::array<int, 3>> displayed_triangles() const {
    return coarsened() ? coarse.triangles : triangles;
  }
};

// Waves for visualisation: rows of amplitude [m], omega [rad/s], wave number [1/m], x and y of the direction,
// phase [rad]. The surface is at `level` + sum a cos(number (x, y)·position - omega t + phase), times the
// ramp.
struct ResultWaves {
  std::vector<std::array<double, 6>> components;  // empty: still water or no water
  double level = 0, ramp = 0;                     // m; s
};

// Contents of a results file. Equal on all ranks, except for the parts that only rank 0 writes.
struct ResultContents {
  RunInfo run;
  // Number of nodes of each line. They are consecutive in file order from end A to end B; lines are
  // consecutive as well.
  Runs<int> line_nodes;
  std::vector<ResultLineLabels> line_labels;  // of each line; on rank 0
  std::vector<int> ranks;                     // owner of each line node; on rank 0. Empty: rank 0 owns all
  std::vector<ResultField> fields;  // node fields; `position` [m, 3 components] always exists and is first
  // Fields at line ends; number 2 l is end A of line l, 2 l + 1 its end B.
  std::vector<ResultField> end_fields;
  std::vector<ResultField> statistics;  // node fields with statistics over the run
  std::vector<ResultSeries> series;
  int bodies = 0;                       // with a pose in each output
  std::vector<std::string> body_names;  // on rank 0
  std::vector<VolumeMesh> volumes;
  ResultWaves waves;
  std::vector<std::string> stages;  // of statics: outputs at times -n + 1, ..., -1 and 0 are their equilibria
  bool clashes = false;             // there is a clash report; its volumes are `volumes`
  bool contact_points = false;      // likewise
  bool xdmf = true;
  bool single_precision = false;  // for `fields` and `end_fields`
  int expected_outputs = 100;     // initial capacity; doubled when exhausted
  int expected_steps = 1000;      // likewise, rows of the series

  int body_nodes = 0;  // bodies with a node in checkpoints, after the nodes of the lines

  int nodes_total() const;  // nodes of the lines
};

// A row of the table of extremes.
struct SummaryRow {
  std::string quantity, line;
  double value = 0;
  std::string unit;
  double time = 0;        // s
  double arc_length = 0;  // m from end A
};

// All functions are collective on `comm` unless stated otherwise. File or disk errors are thrown as
// std::runtime_error on all ranks; accepted data stay readable.
class ResultsFile {
 public:
  // Creates a new file; an old one at `path` is renamed (back_up_results). `owned`: nodes of this rank,
  // ascending, in file order. Throws WriteError if the path cannot be written.
  static ResultsFile create(MPI_Comm comm, const std::string& path, ResultContents contents,
                            std::vector<int> owned);

  // Continues the file of an earlier run with the same contents: outputs and series rows later than `time`
  // [s] are discarded. `sequence`: of the checkpoint from which the run continues; 0: none. `reported`: the
  // clashes of the last kept output; those of a discarded one may have overwritten them in the file. Throws
  // InputError when lines, fields or series differ.
  static ResultsFile resume(MPI_Comm comm, const std::string& path, ResultContents contents,
                            std::vector<int> owned, double time, long long sequence,
                            const ReportedClashes& reported = {});

  ResultsFile(ResultsFile&&) noexcept;
  ResultsFile& operator=(ResultsFile&&) noexcept;
  ~ResultsFile();  // collective; discards data that were not accepted

  // Appends one row of every series at an accepted step. values[s]: the columns of series s on the one rank
  // that has them, else empty; for a series by line the columns of each line whose first node this rank owns.
  // Kept in memory until the next output; no communication.
  void append_series(double time, const std::vector<std::vector<double>>& values);

  // Node fields at `time` [s], owned nodes x components (those of bodies are excluded), in the order of
  // contents.fields (position first), with one pose a body (same on all ranks). ends: likewise,
  // contents.end_fields of the ends whose nodes this rank owns, ascending. contacts: points that this rank
  // counts. The output and the series rows so far are written to the file, where they are kept if the program
  // is killed, at once or with later ones, so that writing takes at most a twentieth of the time; those
  // before a checkpoint are written with it.
  void write_output(double time, const std::vector<std::vector<double>>& fields,
                    std::span<const BodyPose> poses, const ClashTables& clashes = {},
                    const std::vector<std::vector<double>>& ends = {}, const ContactRows& contacts = {});

  // When this returns, read_checkpoint() finds this checkpoint; until then the previous one.
  void write_checkpoint(Checkpoint checkpoint);

  // Writes the current statistics of a field of contents.statistics: owned nodes x components x kStatistics.
  void write_statistics(size_t field, const std::vector<double>& values);

  // Ends the file, whether the run succeeded or failed: writes series rows in memory, the summary table and
  // the run's notes and warnings (of rank 0), and trims the file to its used size. Only the destructor may
  // follow.
  void finish(const std::vector<SummaryRow>& summary, const ClashTables& clashes = {},
              const std::vector<std::string>& messages = {});

  long long outputs() const;  // so far
  long long written() const;  // number of outputs in the file
  const ResultContents& contents() const;
  const std::string& path() const;  // of the HDF5 file
  std::string xdmf_path() const;    // same name, ending .xdmf

 private:
  struct Impl;
  explicit ResultsFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hawser::io
