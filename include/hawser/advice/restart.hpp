// Messages about runs that continue from a checkpoint.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hawser/math/types.hpp"
#include "hawser/model/event.hpp"
#include "hawser/model/line_end.hpp"

namespace hawser::advice {

// Reason why a run cannot continue from the file; because: one of the clauses below.
std::string cannot_continue(const std::string& file, const std::string& because);
std::string no_file();
std::string not_readable();
std::string not_hdf5();
std::string not_results();
std::string damaged_checkpoint(const std::string& quantity, double value);
// kept: quantities that the version of hawser that wrote the file stored differently; version: its name,
// empty: unknown; here: name of this one.
std::string other_quantities(const std::string& file, const std::string& kept, const std::string& version,
                             const std::string& here);
// difference: one of the clauses below, which another version may have caused.
std::string other_or_version(const std::string& difference, const std::string& file,
                             const std::string& version, const std::string& here);

// For a different case; difference: one of the clauses below.
std::string other_case(const std::string& difference);
std::string other_number_of_lines(size_t in_checkpoint, size_t in_case);
std::string other_line(size_t place, const std::string& in_checkpoint, const std::string& in_case);
std::string other_number_of_nodes(const std::string& line, double in_checkpoint, int in_case);
std::string other_node(const std::string& line, double in_checkpoint, double in_case);  // m, of arc length
// Positions [m] of an end that an anchor or a floating body holds, in space.
std::string other_end(const std::string& line, LineEnd end, const Vec3& in_checkpoint, const Vec3& in_case);
std::string other_beams();
std::string other_volumes();
enum class KeyDiffers { missing_in_checkpoint, missing_in_case, other_value };
std::string other_key(const std::string& key, KeyDiffers how);
std::string other_number_of_feeds(size_t in_checkpoint, size_t in_case);
std::string not_fed_in_checkpoint(const std::string& end);

// The refusal `text`, for a case changed by --set.
std::string changed_by_set(const std::string& text, const std::vector<std::string>& changes);
// there, here: " --set KEY=VALUE" for each change, or empty.
std::string other_changes(const std::string& file, const std::string& in_checkpoint,
                          const std::string& in_case);

// Events of the earlier run; time [s] from which this one continues.
std::string event_before_restart(const model::Event& event, double time);
std::string event_of_statics_missing(const model::Event& event);
std::string event_unknown(const std::string& name, double time);  // s, when it happened
std::string event_happened(const model::Event& event, double time);

}  // namespace hawser::advice
