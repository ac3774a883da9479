// Platforms read from separate files: their positions, and the file, line and name of each key of the
// combined case. Placed bodies, lines and other objects are named "<place>/<name in its file>".
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/value.hpp"

namespace hawser::model {

struct FarmPlace {
  std::string name;
  double x = 0, y = 0;  // m, origin of the platform's file
  double heading = 0;   // rad, x axis of that file, anticlockwise from +x
};

// A platform file and where it is placed.
struct FarmPart {
  std::string file;                   // as shown in messages
  std::string given;                  // as written in the farm's file
  std::string directory;              // absolute, base of relative paths
  std::shared_ptr<const Value> tree;  // checked keys
  std::vector<FarmPlace> places;
  std::vector<std::string> notes;  // on the places
};

struct Farm {
  std::vector<FarmPart> parts;
  // Indices of part and place by the name of the place.
  std::unordered_map<std::string, std::pair<std::size_t, std::size_t>> at;
};

// Top-level keys of a platform file whose objects are placed; line types belong to the whole case.
inline constexpr const char* kPlaced[] = {"bodies", "volumes", "supports", "joints", "lines", "links"};

std::string placed_name(const FarmPlace& place, std::string_view name);
// Turns "lines.hose.end_a" into "lines.T1/hose.end_a".
std::string placed_key(const FarmPlace& place, const std::string& key);

// Origin of a dotted key, "lines.T1/hose.end_a", or a name, "T1/hose"; part is null for objects of the case
// itself.
struct Placed {
  const FarmPart* part = nullptr;
  const FarmPlace* place = nullptr;
  std::string key;  // in the file: "lines.hose.end_a", "hose"
};
Placed find_placed(const Case& c, std::string_view key);

// File and line of a dotted key of the case, also of placed objects.
struct KeyPlace {
  const std::string& file;
  int line = 0;
};
KeyPlace place_of(const Case& c, const std::string& key);
// Entry `name` of the top-level map `kind` (lines, line_types) in the file that defines it; none: no file
// does.
Entry entry_of(const Case& c, std::string_view kind, const std::string& name);

// True if the object is a copy of the one at the first place of its platform.
bool is_repeated(const Case& c, const std::string& name);
// True if objects that a platform file fixes in space are fixed to the body; it has the name of its place.
bool is_place(const Case& c, const std::string& body);

// Joins texts that differ only in the name of the place; `also` lists the others: " (and so at 99 more
// places, T2 to T100)".
struct NoteOfPlaces {
  std::size_t first = 0;
  std::string also;
};
std::vector<NoteOfPlaces> join_places(const Case& c, const std::vector<std::string>& texts);
std::vector<std::string> notes_by_place(const Case& c, std::vector<std::string> notes);

// Lines about the farm that `hawser check` prints; empty: the case has none.
std::string farm_text(const Case& c);

}  // namespace hawser::model
