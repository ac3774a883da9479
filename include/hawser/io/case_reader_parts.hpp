// Parts of the case reader: what is more than copying values into the fields that the schema binds them to.
#pragma once

#include <map>
#include <memory>
#include <string>
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

// What several bodies of a case have from the same files, and the waves that they are in.
struct ReadFiles {
  std::map<std::string, std::shared_ptr<const model::HydrodynamicData>> coefficients;
  std::map<std::string, std::shared_ptr<const RaoTable>> responses;
  std::shared_ptr<const WaveField> waves;
  const WaveField& sea(const model::Environment& e);  // the same at each call
};

// Where a case comes from.
struct CaseSource {
  std::string file;                            // as the user named it, for messages
  std::string directory;                       // absolute, for relative paths
  MPI_Comm comm = MPI_COMM_SELF;               // of those who read it
  std::vector<std::string>* inputs = nullptr;  // gets the files that the case names and reads
  std::shared_ptr<ReadFiles> files = std::make_shared<ReadFiles>();

  std::string absolute(const std::string& path) const;
  // The same of a file that the case reads.
  std::string input(const std::string& path) const;
  [[noreturn]] void bad(const model::Value& v, const std::string& key, const std::string& text) const;
};

// The text of a case file; why: the end of a sentence on what is wrong with it, empty: nothing.
std::string case_text(const std::string& path, std::string& why);

Vec3 as_vec3(const model::Value& v);

// What may be as large as it is, m, by itself and in contact diameters of the thinnest line of the case.
struct SizeLimits {
  double most;
  double least_thin, most_thin;
};
// Asks whether something of this size [m] is in other units than metres; empty: it is within its limits.
std::string other_units(double size, const SizeLimits& limits, const model::Case& c);

// Numbers of a text file by row: blanks or commas between, `#` starts a comment. Refused without such a file.
// lines: which line of the file each row is, from 1.
std::vector<std::vector<double>> read_rows(const std::string& path, const model::Value& at,
                                           std::vector<int>* lines = nullptr);

// Rows of a map that has them written there (`rows`) or in a text file (`file`), and where that is.
struct InputRows {
  const model::Value& at;
  std::vector<std::vector<double>> rows;
};
InputRows read_input_rows(const model::Value& v, const CaseSource& source);
// Refuses row i when its first number, a time, is not above that of the row before.
void check_time(const InputRows& given, size_t i);

// `rao: {...}`: its table, read once. notes: columns in odd units.
std::shared_ptr<const RaoTable> read_responses(const model::Value& rao, double gravity,
                                               const CaseSource& source, std::vector<std::string>& notes);
// The motion by it of a body in the waves of the case as a dense table over `duration` [s].
model::TableMotion read_rao(const model::Value& rao, const model::Environment& sea, const model::Body& body,
                            double duration, const CaseSource& source, std::vector<std::string>& notes);

// `table: {file}` or `{rows}`: t [s], x, y, z [m] and maybe the rotation vector [deg, here to rad].
// notes: where the curve leaves what neighbouring rows span.
void read_motion_table(const model::Value& table, const CaseSource& source, model::TableMotion& m,
                       std::vector<std::string>& notes);

// `wind` or `current` of a floating body: its table and areas.
void read_flow_on_body(const model::Value& v, const CaseSource& source, model::FlowOnBody& f);

// `environment`. notes: what is unusual about it, a sentence each.
void finish_environment(const model::Value& v, const CaseSource& source, model::Environment& e,
                        std::vector<std::string>& notes);

// `pipe` and `weight` of a line type: mass, diameters and stiffnesses from the walls of a pipe
// (docs/user-guide/case-file/line-types.md), mass and displaced diameter from weights per length. Keys that
// say the same once more are refused.
void read_pipe(const model::Value& v, bool uneven_bed, model::LineType& t);
void read_weight(const model::Value& v, double gravity, model::LineType& t);
// What a line type is in water: contents and marine growth are added to its mass.
void finish_in_water(const model::Value& v, const model::Water& water, model::LineType& t);

// An entry of `line_types`, which may take from the library what it does not say itself.
model::LineType read_line_type(const std::string& name, const model::Value& v, const model::Environment& sea);

// What is more than copying of an entry of `bodies`, of `volumes`, and of `contact`. Of the case the
// environment is read already; its notes get what is unusual. meet_sea: what depends on where the body is in
// the waves, once it is where it shall be.
void meet_sea(const model::Value& v, const CaseSource& source, model::Body& b, model::Case& c);
void finish_body(const model::Value& v, const CaseSource& source, model::Body& b, model::Case& c);
void finish_volume(const model::Value& v, const CaseSource& source, model::Volume& o);
void finish_contact(const model::Value& v, model::Contact& to);

// An entry of `lines`. whole: `start` of the case, or null; lengths: of sections, in place of those given. Of
// the case line types and joints are read already; its notes get what is unusual.
class OtherRuns;
void finish_line(const model::Value& v, const model::Value* whole, const SectionLengths& lengths,
                 OtherRuns& others, model::Case& c, model::Line& l);

// The start shape of a line that another run left: by its own `start`, or that of the whole case (`whole`,
// may be null).
void finish_start(const model::Value& line, const model::Value* whole, OtherRuns& others, model::Case& c,
                  model::Line& l);

// An entry of `links`. Of the case bodies and lines are read already.
void finish_link(const model::Value& v, model::Link& l, const model::Case& c);

// An entry of `events`. Of the case the lines are read already.
void finish_event(const model::Value& v, model::Event& e, const model::Case& c);
// `output`. Of the case the lines are read already.
void finish_output(const model::Value& v, const CaseSource& source, model::Case& c);

// `supports`, after bodies, volumes and lines: boxes, and their rollers as volumes.
void read_supports(const model::Value& supports, model::Case& c);

// `grid` or `mesh` of the seabed; nothing without.
void read_bed_surface(const model::Value& seabed, const CaseSource& source, model::Seabed& bed,
                      std::vector<std::string>& notes);
// Refuses line ends and points of start shapes that are deep under the bed; notes of ends beyond its edge.
void check_bed(model::Case& c);

// Line types, bodies, volumes, lines, links and supports of a file, of the case that has its environment and
// what the schema copies. whole: `start` of the case, or null. sea: bodies meet it where the file has them.
void read_things(const model::Value& root, const model::Value* whole, const CaseSource& source,
                 const SectionLengths& lengths, bool sea, model::Case& c);

// `farm` of a document that is not checked yet: its platform files, changed by --set farm.of.KEY=VALUE, and
// places; null without. change_notes: gets a note for each change.
std::shared_ptr<const model::Farm> read_farm(const model::Value& root, const CaseSource& source,
                                             const CaseChanges& changes,
                                             std::vector<std::string>& change_notes);
// Whether a change of --set is that of a platform file.
bool changes_platform(const std::string& change);
// The names of its things, for references of the farm's own file.
model::MoreNames names_of(const model::Farm& farm);
// Its platforms into the case, which has its line types already.
void place_platforms(const model::Value& root, const CaseSource& source, const SectionLengths& lengths,
                     model::Case& c);

// Lines as other runs left them; each results file is read once.
class OtherRuns {
 public:
  explicit OtherRuns(const CaseSource& source) : source_(source) {}
  // start: a map with `from` and maybe `time`. Without such a line: refused if it must be there, else null.
  // A line that is cut there is whole for as long as its parts hang together, else its first part.
  std::shared_ptr<const model::PreviousShape> shape(const model::Value& start, const std::string& line,
                                                    bool must);
  // Whether the parts of the line that was last asked for have come apart.
  bool parted() const { return parted_; }

 private:
  struct Run {
    std::string path;
    double time = 0;  // s
    std::vector<std::string> lines;
    std::unordered_map<std::string, size_t> number;  // of a line, by name
    std::vector<double> first, count, arc, position;
    std::vector<std::vector<double>> axes;  // 1 and 2 of the section, where there are beams
  };
  const Run& run(const model::Value& from, const model::Value* time);
  static void add_shape(const Run& r, size_t line, model::PreviousShape& to);
  const CaseSource& source_;
  bool parted_ = false;
  std::map<std::pair<std::string, double>, Run> runs_;  // by path and time; -1: the last
};
// Whether it is long enough for the line.
void check_previous_shape(const model::Line& line, const model::Value& at, const std::string& key,
                          bool parted, std::vector<std::string>& notes);

// Heights that are far from all others of a grid, whose places are `spacing` m apart at least.
struct OddHeights {
  std::size_t count = 0, first = 0;  // how many, and where in the list; 0: none
  bool mark = false;                 // it is one of the numbers that stand for no data
  double gap = 0;                    // m to the nearest of the others
};
OddHeights odd_heights(const std::vector<double>& z, double spacing);

// Columns of a table of responses [period, direction, six amplitudes each with its phase] that look as if
// they were in other units, a sentence each; g [m/s²].
std::vector<std::string> odd_rao_units(const std::vector<std::vector<double>>& rows, double gravity);

}  // namespace hawser::io
