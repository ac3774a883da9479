// Messages about runs that continue from a checkpoint.
#include "hawser/advice/restart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hawser::advice {

std::string cannot_continue(const std::string& file, const std::string& because) {
  return fmt::format("cannot continue from {}: {}", file, because);
}

std::string no_file() { return "there is no such file"; }

std::string not_readable() { return "it cannot be read"; }

std::string not_hdf5() { return "it is not an HDF5 file"; }

std::string not_results() { return "it is not a results file of hawser, or it is damaged"; }

std::string damaged_checkpoint(const std::string& quantity, double value) {
  return fmt::format("its checkpoint is damaged: {} is {:g}", quantity, value);
}

namespace {

std::string other_ways(const std::string& file) {
  return fmt::format("start from its last shape by 'start: {{from: {}}}', or repeat the run", file);
}

}  // namespace

std::string other_quantities(const std::string& file, const std::string& kept, const std::string& version,
                             const std::string& here) {
  const std::string versions = version.empty() ? "" : fmt::format(" ({}; this is {})", version, here);
  return fmt::format("another version of hawser{} wrote it, with other quantities of {}; {}", versions, kept,
                     other_ways(file));
}

std::string other_or_version(const std::string& difference, const std::string& file,
                             const std::string& version, const std::string& here) {
  return fmt::format(
      "{}; another version of hawser ({}; this is {}) wrote it: if the case is the same, continue with that "
      "version, {}",
      difference, version, here, other_ways(file));
}

std::string other_case(const std::string& difference) { return "it holds another case: " + difference; }

std::string other_number_of_lines(size_t in_checkpoint, size_t in_case) {
  return fmt::format("lines: {} in the file, {} in this case", in_checkpoint, in_case);
}

std::string other_line(size_t place, const std::string& in_checkpoint, const std::string& in_case) {
  return fmt::format("its line {} is {}, not {}", place, in_checkpoint, in_case);
}

std::string other_number_of_nodes(const std::string& line, double in_checkpoint, int in_case) {
  return fmt::format("line {} has {} nodes in the file, {} in this case", line, in_checkpoint, in_case);
}

std::string other_node(const std::string& line, double in_checkpoint, double in_case) {
  return fmt::format("a node of line {} is at {:.6g} m in the file, {:.6g} m in this case", line,
                     in_checkpoint, in_case);
}

std::string other_end(const std::string& line, LineEnd end, const Vec3& in_checkpoint, const Vec3& in_case) {
  const auto point = [](const Vec3& x) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}] m", x.x(), x.y(), x.z());
  };
  return fmt::format("end {} of line {} is at {} in the file, and this case holds it at {}", end_letter(end),
                     line, point(in_checkpoint), point(in_case));
}

std::string other_beams() { return "other nodes are of beams"; }

std::string other_volumes() { return "other volumes"; }

std::string other_key(const std::string& key, KeyDiffers how) {
  switch (how) {
    case KeyDiffers::missing_in_checkpoint:
      return key + " is not in it";
    case KeyDiffers::missing_in_case:
      return "it has " + key;
    case KeyDiffers::other_value:
      break;
  }
  return key + " differs from the checkpoint";
}

std::string other_number_of_feeds(size_t in_checkpoint, size_t in_case) {
  return fmt::format("{} of its lines' ends {} fed, and {} in this case", in_checkpoint,
                     in_checkpoint == 1 ? "is" : "are", in_case);
}

std::string not_fed_in_checkpoint(const std::string& end) { return end + " is not fed there"; }

std::string changed_by_set(const std::string& text, const std::vector<std::string>& changes) {
  return fmt::format(
      "{} (the case is changed by --set {}; a continued run may have another duration, other motions, "
      "waves, loads, friction, steps and outputs, but not other lines, lengths, elements, links or volumes, "
      "nor another mass, stiffness or position of anchors and floating bodies)",
      text, fmt::join(changes, " --set "));
}

std::string other_changes(const std::string& file, const std::string& in_checkpoint,
                          const std::string& in_case) {
  return fmt::format("the run of {} was made with{}, and continues with{}", file,
                     in_checkpoint.empty() ? "out --set" : in_checkpoint,
                     in_case.empty() ? "out --set" : in_case);
}

std::string event_before_restart(const model::Event& event, double time) {
  return fmt::format(
      "{} should have been {} at {:g} s, before the restart at t = {:g} s, and was not; give the event a "
      "later time",
      event.action.subject(), event.action.participle(), event.cause.time, time);
}

std::string event_of_statics_missing(const model::Event& event) {
  return fmt::format("{} is to be {} {}, and was not in the run that this one continues",
                     event.action.subject(), event.action.participle(), event.cause.text());
}

std::string event_unknown(const std::string& name, double time) {
  return fmt::format(
      "'{}' happened at t = {:g} s of the run that this one continues, and the case has no such event; put "
      "that event back",
      name, time);
}

std::string event_happened(const model::Event& event, double time) {
  return fmt::format("{} was {} at t = {:.6g} s", event.action.subject(), event.action.participle(), time);
}

}  // namespace hawser::advice
