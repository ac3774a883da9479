// Platforms that a case reads from files of their own: the places of each file, and the file, line and name
// that a key of the whole case stands for. Bodies, lines and so on of a place are called "<place>/<name in
// its file>".
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/model/value.hpp"

namespace hawser::model {

struct FarmPlace {
  std::string name;
  double x = 0, y = 0;  // m, of the origin of the platform's file
  double heading = 0;   // rad, anticlockwise from +x, of the x axis of that file
};

// A platform file and where it is placed.
struct FarmPart {
  std::string file;                   // as messages name it
  std::string given;                  // as the farm's file names it
  std::string directory;              // absolute, for its relative paths
  std::shared_ptr<const Value> tree;  // its checked keys
  std::vector<FarmPlace> places;
};

struct Farm {
  std::vector<FarmPart> parts;
  // Part and place by the name of the place.
  std::unordered_map<std::string, std::pair<std::size_t, std::size_t>> at;
};

// Top-level keys of a platform file that hold what is placed; its line types are those of the whole case.
inline constexpr const char* kPlaced[] = {"bodies", "volumes", "supports", "joints", "lines", "links"};

std::string placed_name(const FarmPlace& place, std::string_view name);
// "lines.hose.end_a" as "lines.T1/hose.end_a".
std::string placed_key(const FarmPlace& place, const std::string& key);

// What a dotted key, "lines.T1/hose.end_a", or a name, "T1/hose", stands for; part null: for nothing that is
// placed.
struct Placed {
  const FarmPart* part = nullptr;
  const FarmPlace* place = nullptr;
  std::string key;  // in the file: "lines.hose.end_a", "hose"
};
Placed find_placed(const Case& c, std::string_view key);

// File and line of a dotted key of the case, its own or that of a placed thing.
struct KeyPlace {
  const std::string& file;
  int line = 0;
};
KeyPlace place_of(const Case& c, const std::string& key);
// The entry `name` of the top-level map `kind` (lines, line_types) in the file that has it; null: none has.
const Value* entry_of(const Case& c, std::string_view kind, const std::string& name);

// Whether this is a copy of what the first place of its platform has.
bool is_repeated(const Case& c, const std::string& name);
// Whether this is the body that carries what a platform file fixes in space: it has the name of its place.
bool is_place(const Case& c, const std::string& body);

// Texts that are the same but for the name of the place become one, the first, and `also` says where else:
// " (and so at 99 more places, T2 to T100)".
struct NoteOfPlaces {
  std::size_t first = 0;
  std::string also;
};
std::vector<NoteOfPlaces> join_places(const Case& c, const std::vector<std::string>& texts);
std::vector<std::string> notes_by_place(const Case& c, std::vector<std::string> notes);

// What `hawser check` prints of a farm, in lines; empty: the case has none.
std::string farm_text(const Case& c);

}  // namespace hawser::model
