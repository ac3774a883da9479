// Messages about runs that continue from a checkpoint.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hawser/model/event.hpp"

namespace hawser::advice {

// Reason why a run cannot continue from the file; because: one of the clauses below.
std::string cannot_go_on(const std::string& file, const std::string& because);
std::string no_file();
std::string not_readable();
std::string not_hdf5();
std::string not_results();
std::string damaged_checkpoint(const std::string& quantity, double value);
// kept: quantities that that version stored differently.
std::string other_version(const std::string& file, const std::string& kept);

// For a different case; difference: one of the clauses below.
std::string other_case(const std::string& difference);
std::string other_number_of_lines(size_t there, size_t here);
std::string other_line(size_t place, const std::string& there, const std::string& here);
std::string other_number_of_nodes(const std::string& line, double there, int here);
std::string other_node(const std::string& line, double there, double here);  // m, of arc length
std::string other_beams();
std::string other_plasticity();
std::string other_volumes();
enum class KeyDiffers { missing_there, missing_here, other_value };
std::string other_key(const std::string& key, KeyDiffers how);
std::string other_number_of_feeds(size_t there, size_t here);
std::string not_fed_there(const std::string& end);

// The refusal `text`, for a case changed by --set.
std::string changed_by_set(const std::string& text, const std::vector<std::string>& changes);
// there, here: " --set KEY=VALUE" for each change, or empty.
std::string other_changes(const std::string& file, const std::string& there, const std::string& here);

// Events of the earlier run; time [s] from which this one continues.
std::string event_before_restart(const model::Event& event, double time);
std::string event_of_statics_missing(const model::Event& event);
std::string event_unknown(const std::string& name, double time);  // s, when it happened
std::string event_happened(const model::Event& event, double time);

}  // namespace hawser::advice
