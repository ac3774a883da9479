// Notes on changes of the case by --set.
#include "hawser/advice/case_changes.hpp"

#include <fmt/format.h>

namespace hawser::advice {
namespace {

std::string former(const model::Value* before) {
  if (!before) return "not in the file";
  if (before->line < 0) return "set before";
  if (before->kind == model::Value::Kind::scalar) return "in the file " + before->text;
  return fmt::format("given in line {} of the file", before->line);
}

}  // namespace

std::string value_set(const std::string& key, const std::string& to, const model::Value* before) {
  return fmt::format("--set {}={} ({})", key, to, former(before));
}

}  // namespace hawser::advice
