// `target` of a line: what is to be met, and by the length of which section.
#include <fmt/format.h>

#include "hawser/io/case_reader_parts.hpp"

namespace hawser::io {

using model::Value;

model::LengthTarget read_target(const Value& v, const std::string& key, const Value& sections,
                                const CaseSource& source) {
  using Kind = model::LengthTarget::Kind;
  model::LengthTarget t;
  for (const auto& [name, kind] : {std::pair{"tension", Kind::tension},
                                   {"declination_deg", Kind::declination},
                                   {"touchdown", Kind::touchdown},
                                   {"laid_length", Kind::laid_length}})
    if (const Value* x = v.find(name)) t.kind = kind, t.value = x->number;
  t.at_a = v["at"].is("end_a");
  if (t.kind == Kind::laid_length && v["at"].given)
    source.bad(v["at"], key + ".at",
               "has no meaning for 'laid_length', which is that of the whole line; remove it");
  const auto length = [&](int i) { return sections.items[static_cast<std::size_t>(i)]["length"].number; };
  const int count = static_cast<int>(sections.items.size());
  for (int i = 1; i < count; ++i)
    if (length(i) > length(t.section)) t.section = i;
  if (const Value* s = v.find("section")) {
    if (s->number > count)
      source.bad(*s, key + ".section",
                 fmt::format("there is no section {:g}; the line has {}", s->number, count));
    t.section = static_cast<int>(s->number) - 1;
  }
  const double given = length(t.section);
  t.least = 0.5 * given, t.most = 1.5 * given;
  const Value* between = v.find("between");
  if (!between) return t;
  t.least = between->items[0].number, t.most = between->items[1].number;
  if (!(t.least < given && given < t.most))
    source.bad(
        *between, key + ".between",
        fmt::format("the search begins with the length of section {}, {:g} m, which is not between {:g} "
                    "and {:g} m",
                    t.section + 1, given, t.least, t.most));
  return t;
}

}  // namespace hawser::io
