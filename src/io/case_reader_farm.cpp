// `farm`: each platform file is read once into a case of its own, whose bodies, lines and other objects are
// copied to each place (model/place_platform.cpp). Motions in waves and start shapes from other runs depend
// on the place and are read for each copy. Environment, contact, statics, dynamics, events and output are
// those of the farm's file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "hawser/advice/farms.hpp"
#include "hawser/io/case_changes.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/place_platform.hpp"
#include "hawser/model/radians.hpp"

namespace hawser::io {

using model::Farm;
using model::FarmPart;
using model::FarmPlace;
using model::refuse;
using model::Value;
namespace fs = std::filesystem;

namespace {

constexpr size_t kMostPlaces = 100'000;
constexpr double kFarthestPlace = 1e6;  // m from the origin
constexpr double kSamePlace = 1e-3;     // m

// Splits a change "farm.of.KEY=VALUE" or "farm[1].of.KEY=VALUE" into the index of the platform and KEY=VALUE,
// which is empty for other changes.
std::pair<size_t, std::string> platform_change(const std::string& change) {
  constexpr std::string_view kFarm = "farm", kOf = ".of.";
  if (!change.starts_with(kFarm)) return {};
  size_t at = kFarm.size();
  size_t number = 0;
  if (at < change.size() && change[at] == '[') {
    const size_t end = change.find(']', at);
    const std::string digits = end == std::string::npos ? "" : change.substr(at + 1, end - at - 1);
    if (digits.empty() || digits.size() > 6 || digits.find_first_not_of("0123456789") != std::string::npos)
      return {};
    number = std::stoul(digits);
    at = end + 1;
  }
  if (change.compare(at, kOf.size(), kOf) != 0) return {};
  return {number, change.substr(at + kOf.size())};
}

// Checks the keys of `farm` alone, because references in other keys may use its names.
Value checked(const Value& root, const std::string& file) {
  static const model::Key only = [] {
    const auto& keys = model::case_schema().keys;
    model::Key k;
    k.keys = {
        *std::find_if(keys.begin(), keys.end(), [](const model::Key& key) { return key.name == "farm"; })};
    return k;
  }();
  Value farm;
  farm.kind = Value::Kind::map;
  farm.keys = {"farm"};
  farm.items = {*root.find("farm")};
  model::check_structure(farm, only, file);
  return std::move(farm.items.front());
}

// Finds places at one position.
class PlacesByPosition {
 public:
  // A place less than kSamePlace away that was added before; null: none, and this place is added.
  const FarmPlace* add(const FarmPlace& place) {
    const long long i = std::llround(place.x / kSamePlace);
    const long long k = std::llround(place.y / kSamePlace);
    for (long long a = i - 1; a <= i + 1; ++a)
      for (long long b = k - 1; b <= k + 1; ++b)
        if (const auto at = cells_.find({a, b});
            at != cells_.end() && std::hypot(place.x - at->second.x, place.y - at->second.y) < kSamePlace)
          return &at->second;
    cells_.emplace(std::pair(i, k), place);
    return nullptr;
  }

 private:
  std::map<std::pair<long long, long long>, FarmPlace> cells_;  // key: position in units of kSamePlace
};

class Places {
 public:
  Places(const Value& v, const CaseSource& source, Farm& farm, FarmPart& part)
      : v_(v), source_(source), farm_(farm), part_(part), heading_(v["heading_deg"].number) {}

  void read() {
    read_places();
    note_radians();
  }

 private:
  void read_places() {
    if (const Value* at = v_.find("at")) {
      for (size_t i = 0; i < at->items.size(); ++i) {
        std::vector<double> row;
        for (const Value& x : at->items[i].items) row.push_back(x.number);
        add(at->items[i], at->keys.empty() ? next_name() : at->keys[i], row);
      }
    } else if (const Value* rows = v_.find("rows")) {
      in_rows(*rows);
    } else {
      const Value& file = v_["file"];
      const auto [given, lines] = read_rows(source_.input(file.text), file);
      if (given.empty()) refuse(file, "{}: the file has no rows", file.text);
      for (size_t i = 0; i < given.size(); ++i) {
        if (given[i].size() != 2 && given[i].size() != 3)
          refuse(file,
                 "{}:{}: a row of places has 2 numbers, x and y, or 3, and the heading, but this one has {}",
                 file.text, lines[i], given[i].size());
        add(file, next_name(), given[i], fmt::format("{}:{}: ", file.text, lines[i]));
      }
    }
  }

  std::string next_name() { return fmt::format("{}{}", v_["name"].text, ++count_); }

  void in_rows(const Value& v) {
    const auto rows = static_cast<size_t>(v["rows"].number);
    const auto columns = static_cast<size_t>(v["columns"].number);
    if (rows * columns > kMostPlaces)
      refuse(v, "{} rows of {} are {} places; the limit is {}", rows, columns, rows * columns, kMostPlaces);
    const double angle = v["direction_deg"].number;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Value& spacing = v["spacing"];
    const Value& from = v["from"];
    for (size_t i = 0; i < rows; ++i)
      for (size_t k = 0; k < columns; ++k) {
        const double along =
            static_cast<double>(k) * spacing.items[0].number + (i % 2 == 1 ? v["stagger"].number : 0);
        const double across = static_cast<double>(i) * spacing.items[1].number;
        add(v, next_name(),
            {from.items[0].number + along * c - across * s, from.items[1].number + along * s + across * c});
      }
  }

  // row: x, y [m] and optionally heading [deg]; where: its line in a file of places, for messages.
  void add(const Value& v, const std::string& name, const std::vector<double>& row,
           const std::string& where = "") {
    FarmPlace place{name, row[0], row[1], row.size() > 2 ? row[2] * kDegree : heading_};
    if (row.size() > 2 && row[2] != 0) given_headings_.push_back(row[2]);
    if (std::max(std::abs(place.x), std::abs(place.y)) > kFarthestPlace)
      refuse(v, "{}{} is {:.4g} m from the origin; places are up to {:g} m from it", where, name,
             std::hypot(place.x, place.y), kFarthestPlace);
    if (!farm_.at.emplace(name, std::pair(farm_.parts.size(), part_.places.size())).second)
      refuse(v, "{}there is another place called '{}'; give one of the platforms a 'name'", where, name);
    if (farm_.at.size() > kMostPlaces) refuse(v, "{}there are more than {} places", where, kMostPlaces);
    if (const FarmPlace* same = known_.add(place))
      refuse(v, "{}{} is at the place of {}, ({:g}, {:g})", where, name, same->name, place.x, place.y);
    part_.places.push_back(std::move(place));
  }

  // Notes headings that are all multiples of 15 deg if they are read as radians.
  void note_radians() {
    if (given_headings_.empty() ||
        !std::all_of(given_headings_.begin(), given_headings_.end(), model::is_in_radians))
      return;
    const Value& at = v_[v_.find("at") ? "at" : "file"];
    part_.notes.push_back(
        advice::headings_in_radians(source_.file, at.line, at.where, given_headings_.front()));
  }

  const Value& v_;
  const CaseSource& source_;
  Farm& farm_;
  FarmPart& part_;
  const double heading_;  // rad
  int count_ = 0;
  PlacesByPosition known_;
  std::vector<double> given_headings_;  // in lists and files, other than 0
};

// Document of a platform, with its changes, checked.
std::shared_ptr<const Value> document(const Value& key, const FarmPart& part, const std::string& path,
                                      const CaseChanges& changes, const std::vector<std::string>& types,
                                      std::vector<std::string>& change_notes) {
  const auto [text, fault] = case_text(path);
  if (!fault.empty()) refuse(key, "{}: {}", part.file, fault);
  const auto tree = std::make_shared<Value>(parse_yaml(text, part.file));
  if (const Value* farm = tree->find("farm"))
    model::fail(part.file, farm->line, "farm",
                "a platform of a farm cannot contain a farm; name the files of its platforms");
  for (std::string& note : change_document(*tree, changes, part.file))
    change_notes.push_back(part.file + ": " + std::move(note));
  model::check_structure(*tree, model::case_schema(), part.file, {{"line_types", types}});
  return tree;
}

// Notes the first position that platforms of different entries have in common.
void note_shared_places(Farm& farm, const std::string& file) {
  PlacesByPosition known;
  for (FarmPart& part : farm.parts)
    for (const FarmPlace& place : part.places)
      if (const FarmPlace* same = known.add(place)) {
        part.notes.push_back(advice::platforms_at_one_place(file, place, same->name));
        return;
      }
}

}  // namespace

bool changes_platform(const std::string& change) { return !platform_change(change).second.empty(); }

std::shared_ptr<const Farm> read_farm(const Value& root, const CaseSource& source, const CaseChanges& changes,
                                      std::vector<std::string>& change_notes) try {
  const auto refuse_changes = [&](const std::string& why) {
    for (const std::string& change : changes)
      if (changes_platform(change)) model::fail(source.file, 0, "", fmt::format("--set {}: {}", change, why));
  };
  if (!root.find("farm")) {
    refuse_changes("the case has no 'farm'");
    return nullptr;
  }
  const auto farm = std::make_shared<Farm>();
  const Value v = checked(root, source.file);
  std::vector<std::string> types;
  if (const Value* case_types = root.find("line_types")) types = case_types->keys;
  const size_t count = v.kind == Value::Kind::list ? v.items.size() : 1;
  for (const std::string& change : changes)
    if (changes_platform(change) && platform_change(change).first >= count)
      model::fail(source.file, 0, "",
                  fmt::format("--set {}: {}", change,
                              count == 1 ? "there is one platform, farm[0]"
                                         : fmt::format("there are {} platforms, from farm[0] to farm[{}]",
                                                       count, count - 1)));
  for (size_t k = 0; k < count; ++k) {
    const Value& entry = v.kind == Value::Kind::list ? v.items[k] : v;
    const Value& file = entry["of"];
    FarmPart part;
    const std::string path = source.input(file.text);
    part.given = file.text;
    part.file = (fs::path(source.file).parent_path() / file.text).lexically_normal().string();
    part.directory = fs::path(path).parent_path().string();
    CaseChanges platform_changes;
    for (const std::string& change : changes)
      if (const auto [number, text] = platform_change(change); !text.empty() && number == k)
        platform_changes.push_back(text);
    part.tree = document(file, part, path, platform_changes, types, change_notes);
    Places(entry, source, *farm, part).read();
    farm->parts.push_back(std::move(part));
  }
  note_shared_places(*farm, source.file);
  return farm;
} catch (const model::Refusal& r) {
  model::fail(source.file, r.line, r.where, r.what());
}

model::MoreNames names_of(const Farm& farm) {
  model::MoreNames names;
  for (const FarmPart& part : farm.parts) {
    for (const char* kind : model::kPlaced)
      for (const FarmPlace& place : part.places)
        for (const std::string& name : (*part.tree)[kind].keys)
          names[kind].push_back(model::placed_name(place, name));
    for (const std::string& name : (*part.tree)["line_types"].keys) names["line_types"].push_back(name);
  }
  return names;
}

namespace {

// Refuses a platform file whose sea differs from the farm's: mass and buoyancy of floating bodies belong
// together.
void check_sea(const FarmPart& part, const model::Environment& platform, const model::Case& c) {
  if (!(*part.tree)["environment"].given) return;
  const auto differs = [&](const char* key, double a, double b, const char* unit) {
    if (a == b) return;
    model::fail(part.file, part.tree->line_of(key), key,
                "{:g}{} is {:g}{} in {}: a platform and its farm are in the same water", a, unit, b, unit,
                c.file);
  };
  const model::Environment& farm = c.environment;
  differs("environment.gravity", platform.gravity, farm.gravity, " m/s²");
  if (platform.water.present != farm.water.present)
    model::fail(part.file, part.tree->line_of("environment.water"), "environment.water",
                "is {} here, but {} in {}: a platform and its farm are in the same water",
                platform.water.present ? "given" : "missing", farm.water.present ? "given" : "missing",
                c.file);
  if (!platform.water.present) return;
  differs("environment.water.density", platform.water.density, farm.water.density, " kg/m³");
  differs("environment.water.surface", platform.water.surface, farm.water.surface, " m");
}

// Refuses a line type that has another definition elsewhere.
void check_line_types(const FarmPart& part, const model::Case& c) {
  const Value& types = (*part.tree)["line_types"];
  for (size_t i = 0; i < types.items.size(); ++i) {
    const std::string key = "line_types." + types.keys[i];
    const model::Entry other = model::entry_of(c, "line_types", types.keys[i]);
    if (!other || &*other == &types.items[i] ||
        model::value_text(*other) == model::value_text(types.items[i]))
      continue;
    const model::KeyPlace defined = model::place_of(c, key);
    model::fail(part.file, types.items[i].line, key,
                "is another line type than that of {}:{}; give one of them another name", defined.file,
                defined.line);
  }
}

// Notes settings of a platform file that the farm ignores because its own file differs.
void note_unused(const FarmPart& part, const Value& root, std::vector<std::string>& notes) {
  std::vector<std::string> keys;
  for (const char* key : {"contact", "start", "stages", "events"}) {
    const Value* v = part.tree->find(key);
    const Value* in_case = root.find(key);
    if (v && v->given && !(in_case && model::value_text(*in_case) == model::value_text(*v)))
      keys.push_back(key);
  }
  if (!keys.empty()) notes.push_back(advice::platform_keys_not_used(part.file, keys));
}

// A platform at the position of its file, in the sea of the farm. bed: receives the bed of the file.
model::Case read_platform(const FarmPart& part, const CaseSource& source, const SectionLengths& lengths,
                          const model::Case& c, model::Seabed& bed) try {
  model::Case p;
  p.file = part.file;
  p.directory = part.directory;
  p.tree = part.tree;
  model::take(*part.tree, p);
  std::vector<std::string> dropped;  // notes on a sea that is not used
  finish_environment((*part.tree)["environment"], source, p.environment, dropped);
  check_sea(part, p.environment, c);
  bed = p.environment.seabed;
  p.environment = c.environment;
  p.dynamics = c.dynamics;
  p.line_types = c.line_types;
  read_objects(*part.tree, nullptr, source, lengths, false, p);
  for (std::string& note : p.notes) note = part.file + ": " + note;
  return p;
} catch (const model::Refusal& r) {
  model::fail(part.file, r.line, r.where, r.what());
}

// Section lengths of one place by their keys in the platform file.
SectionLengths lengths_at(const FarmPlace& place, const SectionLengths& lengths) {
  SectionLengths lengths_of_platform;
  const std::string kind = "lines.";
  const std::string begin = kind + model::placed_name(place, "");
  for (auto at = lengths.lower_bound(begin); at != lengths.end() && at->first.starts_with(begin); ++at)
    lengths_of_platform.emplace(kind + at->first.substr(begin.size()), at->second);
  return lengths_of_platform;
}

}  // namespace

void place_platforms(const Value& root, const CaseSource& source, const SectionLengths& lengths,
                     model::Case& c) {
  if (!c.farm) return;
  for (const model::Body& b : c.bodies)
    if (c.farm->at.count(b.name))
      c.refuse("bodies." + b.name, "a place of the farm is called so; give one of them another name");
  OtherRuns others(source);
  const Value* start_of_case = root.find("start");
  for (const FarmPart& part : c.farm->parts) {
    const CaseSource platform_source{part.file, part.directory, source.comm, source.inputs, source.files};
    check_line_types(part, c);
    note_unused(part, root, c.notes);
    c.notes.insert(c.notes.end(), part.notes.begin(), part.notes.end());
    model::Seabed bed;
    const model::Case platform = read_platform(part, platform_source, {}, c, bed);
    c.line_types = platform.line_types;
    c.notes.insert(c.notes.end(), platform.notes.begin(), platform.notes.end());
    const Value& bodies = (*part.tree)["bodies"];
    const Value& lines = (*part.tree)["lines"];
    for (const FarmPlace& place : part.places) {
      const size_t body = c.bodies.size();
      const size_t line = c.lines.size();
      const SectionLengths changed = lengths_at(place, lengths);
      if (changed.empty())
        model::place_platform(platform, bed, place, c);
      else
        model::place_platform(read_platform(part, platform_source, changed, c, bed), bed, place, c);
      try {
        for (size_t i = 0; i < bodies.items.size(); ++i)
          finish_body_in_sea(*model::Entry(bodies, i), platform_source, c.bodies[body + i], c);
      } catch (const model::Refusal& r) {
        model::fail(part.file, r.line, model::placed_key(place, r.where), r.what());
      }
      if (start_of_case)
        for (size_t i = 0; i < lines.items.size(); ++i)
          if (const model::Entry v(lines, i); !(*v)["start"].given)
            finish_start(*v, start_of_case, others, c, c.lines[line + i]);
    }
  }
}

}  // namespace hawser::io
