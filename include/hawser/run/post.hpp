// Commands for evaluation and display of results, implemented in Python (scripts/hawser_post).
#pragma once

#include <string_view>

namespace hawser::run {

struct PostCommand {
  const char* name;
  const char* help;
};
inline constexpr PostCommand kPostCommands[] = {
    {"report", "Make one HTML file of a run: pictures, tables, range graphs, histories, energy."},
    {"plot", "Make one figure: range graph, history, spectrum, phase, plan, elevation, in space."},
    {"export", "Write the tables, histories and range graphs of a run as CSV files."},
    {"rao", "Make a table and a figure of a body's responses to the waves of a run."},
    {"extremes", "Compute the extremes of a history in a duration, by distributions fitted to its maxima."},
    {"fatigue", "Compute the damage along a line, by rainflow cycles and a published curve."},
    {"pipe", "Compute strain, stress and the code checks of a pipe on its supports and in its sagbend."},
    {"lay", "Compute the smallest tension with which a pipe is laid in each of a list of depths."},
    {"compare",
     "Make one HTML file of two runs: both models, tables of differences, graphs over each other."},
    {"view", "Show the model in three dimensions in a browser: results, a run in progress, a start shape."},
    {"new", "Write a case file with one line by a short dialogue, and show it."}};

bool is_post_command(std::string_view word);

// Replaces this process by Python running the package hawser_post with these arguments, the first of which is
// the command. Returns only if Python or the package is missing: prints a sentence and returns the exit code.
int post(char** arguments);

}  // namespace hawser::run
