// One HDF5 file a run, with an XDMF file beside it for ParaView. After the file is created its structure
// never changes: outputs fill rows that are there already, and a counter written last says how many are
// good. So it is a valid file at every moment, whenever the run is killed
// (docs/decisions/010-files-that-survive.md; what is in it: docs/user-guide/results.md).
#pragma once

#include <mpi.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

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
  std::string changes = {};    // by --set, KEY=VALUE in a line each; case_text is without them
  std::string case_read = {};  // case_json.hpp
  std::vector<std::string> messages =
      {};  // notes and warnings by the time the file is made, until finish() has all
};

// Nodes of a line follow each other in file order, end A to end B; lines follow each other as well.
struct ResultLine {
  std::string name;
  int first_node = 0, nodes = 0;
  std::vector<double> arc;  // m from end A, one a node; on rank 0, which writes them
};

using ResultField = Field;  // of columns name, unit and components alone

// Numbers that statistics of a field have, for each node and component: minimum and its time, maximum and its
// time, mean, standard deviation.
inline constexpr int kStatistics = 6;

// A named row of numbers at every step: a point of a line, or sums such as the energies; or a table with a
// row for each line.
struct ResultSeries {
  std::string name;
  std::vector<ResultField> columns;
  bool by_line = false;
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
  std::vector<char> active;          // one a triangle: takes part in contact
  std::shared_ptr<const void> keep;  // what vertices and triangles lie in, if it must be kept
  // What ParaView is shown instead, with the `active` of its triangles; empty: the mesh itself. XDMF cannot
  // say that a mesh is turned and shifted, so the vertices of one that moves are written at every output.
  CoarseMesh coarse{};
  std::vector<char> coarse_active{};

  bool moves() const { return body >= 0; }
  bool coarsened() const { return !coarse.vertices.empty(); }
  std::span<const Vec3> drawn_vertices() const { return coarsened() ? coarse.vertices : vertices; }
  std::span<const std::array<int, 3>> drawn_triangles() const {
    return coarsened() ? coarse.triangles : triangles;
  }
};

// The sea as the run has it, for pictures: rows of amplitude m, omega rad/s, number 1/m, x, y of the
// direction, phase rad; the surface is at `level` + sum a cos(number (x, y)·position - omega t + phase),
// times its ramp.
struct ResultWaves {
  std::vector<std::array<double, 6>> components;  // empty: still water, or none
  double level = 0, ramp = 0;                     // m; s
};

// What the file is to hold; the same on all ranks, but for what rank 0 alone writes.
struct ResultContents {
  RunInfo run;
  std::vector<ResultLine> lines;
  std::vector<int> ranks;  // of the nodes of lines, which owns each; on rank 0. Empty: rank 0 has all
  std::vector<ResultField> fields;  // node fields; `position` [m, 3 components] is always there, first
  // Of the ends of lines; end number 2 l is end A of line l, 2 l + 1 its end B.
  std::vector<ResultField> end_fields;
  std::vector<ResultField> statistics;  // node fields of which statistics over the run are kept
  std::vector<ResultSeries> series;
  std::vector<std::string> bodies;
  std::vector<VolumeMesh> volumes;
  ResultWaves waves;
  std::vector<std::string> stages;  // of statics: outputs at times -n + 1, ..., -1 and 0 are their rests
  bool clashes = false;             // there is a clash report; its volumes are `volumes`
  bool contact_points = false;      // likewise
  bool xdmf = true;
  bool single_precision = false;  // of `fields` and `end_fields`
  int expected_outputs = 100;     // room made at once; it doubles when it runs out
  int expected_steps = 1000;      // likewise, rows of the series

  int free_bodies = 0;  // bodies that have a node in checkpoints, after those of the lines

  int nodes_total() const;  // of the lines
};

// One line of the table of extremes.
struct SummaryRow {
  std::string quantity, line;
  double value = 0;
  std::string unit;
  double time = 0;        // s
  double arc_length = 0;  // m from end A
};

// All functions are collective on `comm` unless they say otherwise. Errors of the file or disk come as
// std::runtime_error on all ranks; what was accepted before stays readable.
class ResultsFile {
 public:
  // New file; an old one at `path` is kept (back_up_results). `owned`: this rank's nodes, ascending, in file
  // order. Throws WriteError when the place cannot be written.
  static ResultsFile create(MPI_Comm comm, const std::string& path, ResultContents contents,
                            std::vector<int> owned);

  // Go on with the file of an earlier run of the same contents: outputs and series rows later than
  // `time` [s] are dropped. `sequence`: of the checkpoint that the run goes on from; 0: it has none.
  // `reported`: the clashes of the last output that stays; those of a dropped one may have taken their place
  // in the file. Throws InputError when lines, fields or series differ.
  static ResultsFile resume(MPI_Comm comm, const std::string& path, ResultContents contents,
                            std::vector<int> owned, double time, long long sequence,
                            const ReportedClashes& reported = {});

  ResultsFile(ResultsFile&&) noexcept;
  ResultsFile& operator=(ResultsFile&&) noexcept;
  ~ResultsFile();  // collective; flushes nothing that was not accepted

  // One row of every series at an accepted step. values[s]: the columns of series s if this rank has
  // them (one rank must), else empty; of a series by line the columns of each line whose first node this rank
  // owns. Kept in memory until the next output; no communication.
  void append_series(double time, const std::vector<std::vector<double>>& values);

  // Node fields at `time` [s], owned nodes x components (those of bodies are excluded), in the order of
  // contents.fields (position
  // first), with one pose a body (same on all ranks). ends: likewise, contents.end_fields of the ends whose
  // nodes this rank owns, ascending. contacts: points that this rank counts. The output and the series rows
  // so far go to the file, from where they survive the death of the program, at once or with later ones, so
  // that writing takes a twentieth of the time at most; those before a checkpoint with it.
  void write_output(double time, const std::vector<std::vector<double>>& fields,
                    std::span<const BodyPose> poses, const ClashTables& clashes = {},
                    const std::vector<std::vector<double>>& ends = {}, const ContactRows& contacts = {});

  // When it returns, read_checkpoint() gives this one; until then, the one before.
  void write_checkpoint(Checkpoint checkpoint);

  // Statistics so far of a field of contents.statistics: owned nodes x components x kStatistics.
  void write_statistics(size_t field, const std::vector<double>& values);

  // End of the run, be it a good one or not: writes series rows still in memory, the table and the notes and
  // warnings of the run (those of rank 0), and cuts the file to what is used. Only the destructor may follow.
  void finish(const std::vector<SummaryRow>& summary, const ClashTables& clashes = {},
              const std::vector<std::string>& messages = {});

  long long outputs() const;  // so far
  long long written() const;  // of these, those that are in the file
  const ResultContents& contents() const;
  const std::string& path() const;  // of the HDF5 file
  std::string xdmf_path() const;    // same name, ending .xdmf

 private:
  struct Impl;
  explicit ResultsFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hawser::io
