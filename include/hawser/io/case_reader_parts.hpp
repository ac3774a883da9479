// Parts of the case reader: shapes, and what looks at other files (motion tables, meshes).
#pragma once

#include <memory>
#include <string>

#include "hawser/model/case.hpp"
#include "hawser/model/value.hpp"

namespace hawser::io {

// Where a case comes from.
struct CaseSource {
  std::string file;       // as the user named it, for messages
  std::string directory;  // absolute, for relative paths

  std::string absolute(const std::string& path) const;
  [[noreturn]] void bad(const model::Value& v, const std::string& key, const std::string& text) const;
};

Vec3 as_vec3(const model::Value& v);

// The key's three numbers as a unit vector; zero is refused.
Vec3 read_direction(const model::Value& v, const char* key, const std::string& path,
                    const CaseSource& source);

// `shape: {cylinder: {...}}` and the like; `key` is its dotted key.
Primitive read_shape(const model::Value& shape, const std::string& key, const CaseSource& source);

// Numbers of a text file by row: blanks or commas between, `#` starts a comment. Refused without such a file.
std::vector<std::vector<double>> read_rows(const std::string& path, const model::Value& at,
                                           const std::string& key, const CaseSource& source);

// `rao: {...}`: the motion of a body in the waves of the case as a dense table over `duration` [s].
model::TableMotion read_rao(const model::Value& rao, const std::string& key, const model::Environment& sea,
                            const model::Body& body, double duration, const CaseSource& source);

// `table: {file}` or `{rows}`: t [s], x, y, z [m] and maybe the rotation vector [deg, here to rad].
model::TableMotion read_motion_table(const model::Value& table, const std::string& key,
                                     const CaseSource& source);

// `contact.between_lines`. Two different sets of settings for one pair are refused.
model::BetweenLines read_between_lines(const model::Value& v, const CaseSource& source);

// `environment`, and what a line type is in water (contents and marine growth are added to its mass).
model::Environment read_environment(const model::Value& v, const CaseSource& source);
void read_in_water(const model::Value& v, const std::string& key, const CaseSource& source,
                   model::LineType& t);

// An entry of `line_types`, which may take from the library what it does not say itself.
model::LineType read_line_type(const std::string& name, const model::Value& v, const CaseSource& source);

// An entry of `bend_stiffeners` of a line, its root at arc length `at` [m].
void read_bend_stiffener(const model::Value& v, const std::string& path, double at, double length,
                         const CaseSource& source, model::Line& line);

// `sign` of a volume, a word of the schema.
model::SignTest read_sign(const std::string& word);

// Read every mesh, refuse what is no closed volume or has the wrong scale; repairs go to Case::notes.
void check_meshes(const model::Value& root, const CaseSource& source, model::Case& c);

// Rows of force over penetration, and friction given as a map.
std::shared_ptr<const ForceTable> read_force_table(const model::Value& table, const std::string& key,
                                                   const CaseSource& source);
model::Friction read_friction(const model::Value& f, const std::string& key, const CaseSource& source);

}  // namespace hawser::io
