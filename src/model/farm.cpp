// Origin of names and keys of placed objects, notes joined over places, and the summary of a farm.
#include "hawser/model/farm.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "hawser/base/count_of.hpp"
#include "hawser/model/check.hpp"

namespace hawser::model {

std::string placed_name(const FarmPlace& place, std::string_view name) {
  return fmt::format("{}/{}", place.name, name);
}

std::string placed_key(const FarmPlace& place, const std::string& key) {
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos) return key;
  return key.substr(0, dot + 1) + placed_name(place, std::string_view(key).substr(dot + 1));
}

Placed find_placed(const Case& c, std::string_view key) {
  if (!c.farm) return {};
  const std::size_t slash = key.find('/');
  if (slash == std::string_view::npos) return {};
  const std::size_t dot = key.substr(0, slash).rfind('.');
  const std::size_t begin = dot == std::string_view::npos ? 0 : dot + 1;
  const auto at = c.farm->at.find(std::string(key.substr(begin, slash - begin)));
  if (at == c.farm->at.end()) return {};
  const FarmPart& part = c.farm->parts[at->second.first];
  return {&part, &part.places[at->second.second],
          std::string(key.substr(0, begin)) + std::string(key.substr(slash + 1))};
}

namespace {

Entry entry(const Value* tree, std::string_view kind, const std::string& name) {
  const Value* all = tree ? tree->find(kind) : nullptr;
  return all ? find_entry(*all, name) : Entry();
}

// The part whose file defines a line type; null: the case itself.
const FarmPart* part_of_type(const Case& c, const std::string& name) {
  if (!c.farm || entry(c.tree.get(), "line_types", name)) return nullptr;
  for (const FarmPart& part : c.farm->parts)
    if (entry(part.tree.get(), "line_types", name)) return &part;
  return nullptr;
}

}  // namespace

KeyPlace place_of(const Case& c, const std::string& key) {
  if (const Placed p = find_placed(c, key); p.part) return {p.part->file, p.part->tree->line_of(p.key)};
  constexpr std::string_view kTypes = "line_types.";
  if (key.starts_with(kTypes)) {
    const std::string remainder = key.substr(kTypes.size());
    if (const FarmPart* part = part_of_type(c, remainder.substr(0, remainder.find_first_of(".["))))
      return {part->file, part->tree->line_of(key)};
  }
  return {c.file, c.tree ? c.tree->line_of(key) : 0};
}

Entry entry_of(const Case& c, std::string_view kind, const std::string& name) {
  if (const Placed p = find_placed(c, name); p.part) return entry(p.part->tree.get(), kind, p.key);
  if (const FarmPart* part = kind == "line_types" ? part_of_type(c, name) : nullptr)
    return entry(part->tree.get(), kind, name);
  return entry(c.tree.get(), kind, name);
}

bool is_repeated(const Case& c, const std::string& name) {
  const Placed p = find_placed(c, name);
  return p.part && p.place != &p.part->places.front();
}

bool is_place(const Case& c, const std::string& body) { return c.farm && c.farm->at.count(body) > 0; }

namespace {

// The place whose objects a text names first; empty: none. The name of a place ends at a '/' and begins at
// the start of a word.
std::string place_in(const Farm& farm, const std::string& text) {
  constexpr std::size_t kLongest = 100;  // longest name
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '/' || (c & 0x80);
  };
  for (std::size_t slash = text.find('/'); slash != std::string::npos; slash = text.find('/', slash + 1)) {
    const std::size_t first = slash > kLongest ? slash - kLongest : 0;
    for (std::size_t begin = first; begin < slash; ++begin) {
      if (begin > 0 && in_word(text[begin - 1])) continue;
      std::string name = text.substr(begin, slash - begin);
      if (farm.at.count(name)) return name;
    }
  }
  return "";
}

std::string without(std::string text, const std::string& place) {
  const std::string named = place + "/";
  for (std::size_t at = text.find(named); at != std::string::npos; at = text.find(named, at + 1))
    text.replace(at, place.size(), "");
  return text;
}

}  // namespace

std::vector<NoteOfPlaces> join_places(const Case& c, const std::vector<std::string>& texts) {
  struct Same {
    std::size_t first = 0;
    std::vector<std::string> others;  // other places, without duplicates
  };
  std::vector<Same> groups;
  std::map<std::string, std::size_t> known;  // key: the text without its place, and the part of that place
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string place = c.farm ? place_in(*c.farm, texts[i]) : "";
    if (place.empty()) {
      groups.push_back({i, {}});
      continue;
    }
    const std::string same = fmt::format("{} {}", c.farm->at.at(place).first, without(texts[i], place));
    if (const auto [at, is_new] = known.emplace(same, groups.size()); !is_new)
      groups[at->second].others.push_back(place);
    else
      groups.push_back({i, {}});
  }
  std::vector<NoteOfPlaces> out;
  for (const Same& g : groups) {
    NoteOfPlaces& note = out.emplace_back(NoteOfPlaces{g.first, ""});
    if (g.others.size() == 1) note.also = fmt::format(" (and so at {})", g.others.front());
    if (g.others.size() > 1)
      note.also = fmt::format(" (and so at {} more places, {} to {})", g.others.size(), g.others.front(),
                              g.others.back());
  }
  return out;
}

std::vector<std::string> notes_by_place(const Case& c, std::vector<std::string> notes) {
  if (!c.farm) return notes;
  std::vector<std::string> out;
  for (const NoteOfPlaces& n : join_places(c, notes)) out.push_back(notes[n.first] + n.also);
  return out;
}

namespace {

struct Count {
  std::size_t lines = 0, bodies = 0, links = 0, volumes = 0;
  long long elements = 0;

  void add(const Line& l) {
    ++lines;
    for (const Section& s : l.sections) elements += s.elements;
  }
  std::string text() const {
    const auto several = [](std::size_t n, const char* one, const char* more = "") {
      return count_of(static_cast<long long>(n), one, more);
    };
    return fmt::format("{} ({}), {}, {}, {}", several(lines, "line"), count_of(elements, "element"),
                       several(bodies, "body", "bodies"), several(links, "link"), several(volumes, "volume"));
  }
};

template <class Objects, class Add>
void count(const Case& c, const Objects& objects, std::vector<Count>& parts, Count& common, Add add) {
  for (const auto& object : objects) {
    const Placed p = find_placed(c, object.name);
    if (!p.part)
      add(common, object);
    else if (p.place == &p.part->places.front())
      add(parts[static_cast<std::size_t>(p.part - c.farm->parts.data())], object);
  }
}

}  // namespace

std::string farm_text(const Case& c) {
  if (!c.farm) return "";
  constexpr std::size_t kListed = 12;  // largest number of places that are listed individually
  std::vector<Count> each(c.farm->parts.size());
  Count common;
  count(c, c.lines, each, common, [](Count& n, const Line& l) { n.add(l); });
  count(c, c.bodies, each, common, [&](Count& n, const Body& b) { n.bodies += !is_place(c, b.name); });
  count(c, c.links, each, common, [](Count& n, const Link&) { ++n.links; });
  count(c, c.volumes, each, common, [](Count& n, const Volume&) { ++n.volumes; });
  std::string s = fmt::format("farm: {}\n", count_of(std::ssize(c.farm->at), "place"));
  for (std::size_t k = 0; k < each.size(); ++k) {
    const FarmPart& part = c.farm->parts[k];
    s += fmt::format("  {} at {}, at each {}\n", part.file, count_of(std::ssize(part.places), "place"),
                     each[k].text());
    for (std::size_t i = 0; i < part.places.size(); ++i) {
      const FarmPlace& p = part.places[i];
      if (part.places.size() > kListed && i == kListed / 2) {
        s += "    ...\n";
        i = part.places.size() - kListed / 2 - 1;
        continue;
      }
      s +=
          fmt::format("    {}: ({:g}, {:g}) m, heading {:g} deg\n", p.name, p.x, p.y, p.heading * 180 / M_PI);
    }
  }
  return s + fmt::format("  beside them {}\n", common.text());
}

}  // namespace hawser::model
