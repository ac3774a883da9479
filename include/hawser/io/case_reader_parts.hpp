// Parts of the case reader for keys that need more than a copy into their field.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/schema.hpp"
#include "hawser/model/value.hpp"

namespace hawser {
class RaoTable;
class WaveField;
}  // namespace hawser

namespace hawser::io {

// Files shared by several bodies of a case, and the waves of the case.
struct ReadFiles {
  std::map<std::string, std::shared_ptr<const model::HydrodynamicData>> coefficients;
  std::map<std::string, std::shared_ptr<const RaoTable>> responses;
  std::shared_ptr<const WaveField> waves;
  const WaveField& sea(const model::Environment& e);  // computed once
};

// Origin of a case.
struct CaseSource {
  std::string file;                            // as given by the user, for messages
  std::string directory;                       // absolute, for relative paths
  MPI_Comm comm = MPI_COMM_SELF;               // of the ranks that read the case
  std::vector<std::string>* inputs = nullptr;  // receives the files that the case reads
  std::shared_ptr<ReadFiles> files = std::make_shared<ReadFiles>();

  std::string absolute(const std::string& path) const;
  // The same for a file that the case reads, which is recorded in `inputs`.
  std::string input(const std::string& path) const;
  [[noreturn]] void refuse(const model::Value& v, const std::string& key, const std::string& text) const;
};

// Text of a case file, and the end of a sentence on an error; empty: none.
struct CaseText {
  std::string text, fault;
};
CaseText case_text(const std::string& path);

Vec3 as_vec3(const model::Value& v);

// Limits of a plausible size, m: an absolute upper limit, and limits in contact diameters of the thinnest
// line of the case.
struct SizeLimits {
  double max;
  double min_ratio, max_ratio;
};
// Asks whether a size [m] is in units other than metres; empty: it is within its limits.
std::string other_units(double size, const SizeLimits& limits, const model::Case& c);

// Rows of numbers of a text file, separated by blanks or commas; `#` starts a comment. Refuses an unreadable
// file.
struct FileRows {
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;  // line of each row in the file, from 1
};
FileRows read_rows(const std::string& path, const model::Value& at);

// Rows given in a map (`rows`) or in a text file (`file`), and the value that gives them.
struct InputRows {
  const model::Value& at;
  std::vector<std::vector<double>> rows;
};
InputRows read_input_rows(const model::Value& v, const CaseSource& source);
// Refuses rows; the sentence begins with the name of their file, if they have one.
[[noreturn]] void refuse_rows(const InputRows& given, const std::string& text);
template <class First, class... More>
[[noreturn]] void refuse_rows(const InputRows& given, fmt::format_string<First, More...> text, First&& first,
                              More&&... more) {
  refuse_rows(given, fmt::format(text, std::forward<First>(first), std::forward<More>(more)...));
}
// Refuses row i if its first number is not more than `tolerance` above that of the row before
// (model::increase_fault).
void check_increase(const InputRows& given, size_t i, std::string_view quantities, std::string_view unit,
                    double tolerance = 0);

// Table of `rao: {...}`, read once per file. notes: columns with implausible units.
std::shared_ptr<const RaoTable> read_responses(const model::Value& rao, double gravity,
                                               const CaseSource& source, std::vector<std::string>& notes);
// Motion of a body by these responses in the waves of the case, as a dense table over `duration` [s].
model::TableMotion read_rao(const model::Value& rao, const model::Environment& sea, const model::Body& body,
                            double duration, const CaseSource& source, std::vector<std::string>& notes);

// `table: {file}` or `{rows}`: t [s], x, y, z [m] and optionally the rotation vector [deg, converted to rad].
// notes: overshoot of the curve beyond neighbouring rows.
void read_motion_table(const model::Value& table, const CaseSource& source, model::TableMotion& m,
                       std::vector<std::string>& notes);

// `wind` or `current` of a floating body: table, areas and lengths.
void read_flow_on_body(const model::Value& v, const CaseSource& source, model::FlowOnBody& f);

// `environment`. notes: unusual settings, one sentence each.
void finish_environment(const model::Value& v, const CaseSource& source, model::Environment& e,
                        std::vector<std::string>& notes);

// `pipe` and `weight` of a line type: mass, diameters and stiffnesses from the walls of a pipe
// (docs/user-guide/case-file/line-types.md), mass and displaced diameter from weights per length. Redundant
// keys are refused.
void read_pipe(const model::Value& v, bool uneven_bed, model::LineType& t);
void read_weight(const model::Value& v, double gravity, model::LineType& t);
// Properties of a line type in water; contents and marine growth are added to its mass.
void finish_in_water(const model::Value& v, const model::Water& water, model::LineType& t);

// An entry of `line_types`, with missing keys taken from the library if it names a library type.
model::LineType read_line_type(const std::string& name, const model::Value& v, const model::Environment& sea);

// Complete entries of `bodies` and `volumes`, and `contact`. The environment of the case must be read; its
// notes receive warnings. finish_body_in_sea(): the parts that depend on the body's position in the waves,
// after placement.
void finish_body_in_sea(const model::Value& v, const CaseSource& source, model::Body& b, model::Case& c);
void finish_body(const model::Value& v, const CaseSource& source, model::Body& b, model::Case& c);
void finish_volume(const model::Value& v, const CaseSource& source, model::Volume& o);
void finish_contact(const model::Value& v, model::Contact& to);

// An entry of `lines`. start_of_case: `start` of the case, or null; lengths: section lengths that replace
// those given. Line types and joints of the case must be read; its notes receive warnings.
class OtherRuns;
void finish_line(const model::Value& v, const model::Value* start_of_case, const SectionLengths& lengths,
                 OtherRuns& others, model::Case& c, model::Line& l);

// Start shape of a line from another run: by the line's own `start` or that of the case (`start_of_case`, may
// be null).
void finish_start(const model::Value& line, const model::Value* start_of_case, OtherRuns& others,
                  model::Case& c, model::Line& l);

// An entry of `links`. Bodies and lines of the case must be read.
void finish_link(const model::Value& v, model::Link& l, const model::Case& c);

// An entry of `events`. Lines of the case must be read.
void finish_event(const model::Value& v, model::Event& e, const model::Case& c);
// `output`. Lines of the case must be read.
void finish_output(const model::Value& v, const CaseSource& source, model::Case& c);

// `supports`, after bodies, volumes and lines: boxes, and their rollers as volumes.
void read_supports(const model::Value& supports, model::Case& c);

// `grid` or `mesh` of the seabed, if given.
void read_bed_surface(const model::Value& seabed, const CaseSource& source, model::Seabed& bed,
                      std::vector<std::string>& notes);
// Refuses line ends and points of start shapes that are deep below the bed; notes ends beyond its edge.
void check_bed(model::Case& c);

// Line types, bodies, volumes, lines, links and supports of a file, after the environment and the keys that
// the schema copies. start_of_case: `start` of the case, or null. sea: bodies are at their final position, so
// finish_body_in_sea() is called.
void read_objects(const model::Value& root, const model::Value* start_of_case, const CaseSource& source,
                  const SectionLengths& lengths, bool sea, model::Case& c);

// `farm` of an unchecked document: its platform files, changed by --set farm.of.KEY=VALUE, and its places;
// null without the key. change_notes: receives a note for each change.
std::shared_ptr<const model::Farm> read_farm(const model::Value& root, const CaseSource& source,
                                             const CaseChanges& changes,
                                             std::vector<std::string>& change_notes);
// True if a change of --set applies to a platform file.
bool changes_platform(const std::string& change);
// Names of the placed objects, for references in the farm's own file.
model::MoreNames names_of(const model::Farm& farm);
// Adds the platforms to the case, whose line types must be read.
void place_platforms(const model::Value& root, const CaseSource& source, const SectionLengths& lengths,
                     model::Case& c);

// Line shapes from other runs; each results file is read once.
class OtherRuns {
 public:
  explicit OtherRuns(const CaseSource& source) : source_(source) {}
  // start: a map with `from` and optionally `time`. If that run has no such line: refused if `must`, else
  // null. A line that events cut is whole while its parts are connected, afterwards it is its first part.
  std::shared_ptr<const model::PreviousShape> shape(const model::Value& start, const std::string& line,
                                                    bool must);
  // True if the parts of the line last requested are separated.
  bool parted() const { return parted_; }

 private:
  struct Run {
    std::string path;
    double time = 0;  // s
    std::vector<std::string> lines;
    std::unordered_map<std::string, size_t> number;  // line number by name
    std::vector<double> first, count, arc, position;
    std::vector<std::vector<double>> axes;  // directors 1 and 2 of the section, if there are beams
  };
  const Run& run(const model::Value& from, const model::Value* time);
  static void add_shape(const Run& r, size_t line, model::PreviousShape& to);
  const CaseSource& source_;
  bool parted_ = false;
  std::map<std::pair<std::string, double>, Run> runs_;  // by path and time; -1: the last output
};
// Checks that the shape is long enough for the line.
void check_previous_shape(const model::Line& line, const model::Value& at, const std::string& key,
                          bool parted, std::vector<std::string>& notes);

// Outliers among the heights of a grid whose points are at least `spacing` [m] apart.
struct OddHeights {
  std::size_t count = 0, first = 0;  // number, and index of the first in the list; count 0: none
  bool mark = false;                 // a number commonly used for missing data
  double gap = 0;                    // m, distance to the nearest other height
};
OddHeights odd_heights(const std::vector<double>& z, double spacing);

}  // namespace hawser::io
