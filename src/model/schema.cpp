// Top-level keys of a case file, in the order of the user guide.
#include "hawser/model/schema.hpp"

#include <stdexcept>

#include "schema_build.hpp"

namespace hawser::model {

Vec3 schema_build::direction(const Value& v) {
  Vec3 x;
  put(x, v);
  const double n = x.stableNorm();
  if (!(n > 0)) throw std::invalid_argument("[0, 0, 0] is no direction");
  return x / n;
}

using namespace schema_build;

const Key& case_schema() {
  static const Key schema = map(
      "case", {integer("hawser", "version of the case format; must be 1", in_range(1, 1), required),
               text({"title", &Case::title}, "title, for pictures and reports", or_else("")), environment(),
               line_types(), farm(), bodies(), volumes(), supports(), joints(), lines(), links(), contact(),
               statics(),
               map("start",
                   {text("from", "results (.h5) of another run, beside the case", required),
                    number("time", time, "time of its output", at_least(0), or_else_note("the last output"))},
                   "Results of another run from which lines without `start` take the shape of the line of "
                   "the same name; statics continues from there, also if the case has changed."),
               stages(), dynamics(), events(), output()});
  return schema;
}

}  // namespace hawser::model
