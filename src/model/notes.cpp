// Splitting of notes into volume and text, and joining of equal texts.
#include "hawser/model/notes.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

#include "hawser/model/nearest.hpp"

namespace hawser::model {
namespace {

constexpr std::size_t kNamed = 4;  // longest list with all names

struct Split {
  std::string_view name, text;  // name empty: the note has another subject
};
Split split(std::string_view note) {
  for (const std::string_view kind : {"volume ", "volumes."}) {
    const std::size_t end = note.find(": ");
    if (note.starts_with(kind) && end != std::string_view::npos && end > kind.size())
      return {note.substr(kind.size(), end - kind.size()), note.substr(end + 2)};
  }
  return {"", note};
}

}  // namespace

std::string names_text(const std::vector<std::string>& names) {
  if (names.size() <= kNamed) return enumerate(names, "and");
  return fmt::format("{} ... {} ({} in all)", names.front(), names.back(), names.size());
}

std::vector<std::string> grouped_notes(const std::vector<std::string>& notes) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;  // a note, the names it applies to
  std::map<std::string_view, std::size_t> known;                         // group by text
  for (const std::string& note : notes) {
    const Split s = split(note);
    if (!s.name.empty())
      if (const auto [at, is_new] = known.emplace(s.text, groups.size()); !is_new) {
        groups[at->second].second.emplace_back(s.name);
        continue;
      }
    groups.push_back({note, {std::string(s.name)}});
  }
  std::vector<std::string> out;
  for (const auto& [note, names] : groups)
    out.push_back(names.size() < 2
                      ? note
                      : fmt::format("volumes {}: {}", names_text(names), std::string(split(note).text)));
  return out;
}

}  // namespace hawser::model
