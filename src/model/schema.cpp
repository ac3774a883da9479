// The keys of a case file. Order here is the order in the user guide.
#include "hawser/model/schema.hpp"

#include <stdexcept>
#include <utility>

#include "schema_build.hpp"

namespace hawser::model {

Key&& Key::is_required() && { return required = true, std::move(*this); }
Key&& Key::or_else(std::string literal) && { return fallback = std::move(literal), std::move(*this); }
Key&& Key::or_else_note(std::string text) && { return fallback_note = std::move(text), std::move(*this); }
Key&& Key::above(double x) && { return bounds.above = x, std::move(*this); }
Key&& Key::at_least(double x) && { return bounds.at_least = x, std::move(*this); }
Key&& Key::at_most(double x) && { return bounds.at_most = x, std::move(*this); }
Key&& Key::items(std::size_t least, std::size_t most) && {
  min_items = least, max_items = most;
  return std::move(*this);
}
Key&& Key::either(std::vector<Group> g, bool needed) && {
  groups = std::move(g), group_required = needed;
  return std::move(*this);
}

Vec3 schema_build::direction(const Value& v) {
  Vec3 x;
  put(x, v);
  const double n = x.stableNorm();
  if (!(n > 0)) throw std::invalid_argument("[0, 0, 0] is no direction");
  return x / n;
}

using namespace schema_build;

const Key& case_schema() {
  static const Key schema =
      map("case",
          {integer("hawser", "version of the case format; must be 1").at_least(1).at_most(1).is_required(),
           text({"title", &Case::title}, "title, for pictures and reports").or_else(""), environment(),
           line_types(), bodies(), volumes(), supports(), joints(), lines(), links(), contact(), statics(),
           map("start",
               {text("from", "results (.h5) of another run, beside the case").is_required(),
                number("time", time, "of its output").at_least(0).or_else_note("the last")},
               "Lines without a `start` of their own begin as another run left those of the same name; "
               "statics goes on from there, whatever has changed."),
           stages(), dynamics(), events(), output()},
          "");
  return schema;
}

}  // namespace hawser::model
