// Messages about output files.
#include "hawser/advice/output_files.hpp"

#include <fmt/format.h>

namespace hawser::advice {
namespace {

std::string cannot_write_results(const std::string& path, const std::string& why) {
  return fmt::format("cannot write the results to {}: {}", path, why);
}

}  // namespace

std::string would_replace_input(const std::string& kind, const std::string& path, const std::string& read,
                                const std::string& written) {
  return fmt::format(
      "cannot write {} to {}: {} is a file that this run reads{}, and would be replaced; give another "
      "file with -o",
      kind, path, read, read == written ? "" : " (" + written + ")");
}

std::string link_to_itself(const std::string& path) {
  return cannot_write_results(path, "it is a symbolic link that refers to itself");
}

std::string name_must_end_in_h5(const std::string& path) {
  return cannot_write_results(path, "the name must end in .h5");
}

std::string no_folder(const std::string& path, const std::string& folder) {
  return cannot_write_results(path, "there is no folder " + folder);
}

std::string not_a_folder(const std::string& path, const std::string& folder) {
  return cannot_write_results(path, folder + " is not a folder");
}

std::string folder_not_writable(const std::string& path, const std::string& folder) {
  return cannot_write_results(path, "the folder " + folder + " cannot be written");
}

std::string name_too_long(const std::string& path, size_t characters, long allowed) {
  return cannot_write_results(
      path,
      fmt::format(
          "the name is too long: with .xdmf.new in place of .h5 it has {} characters, {} are allowed there",
          characters, allowed));
}

std::string name_is_a_folder(const std::string& path, const std::string& name) {
  return cannot_write_results(path, name + " is a folder");
}

std::string third_party_file(const std::string& path, const std::string& name) {
  return cannot_write_results(
      path, name + " was not written by hawser and is not replaced; move it, or give another file with -o");
}

std::string table_needs_csv(const std::string& path, const std::string& contents) {
  const bool motion = contents == "responses" && path.ends_with(".rao");
  return fmt::format("{}: a table of {} is a CSV file: give its name the ending .csv{}", path, contents,
                     motion ? "; 'hawser rao' makes a table for motion.rao of it" : "");
}

std::string not_such_a_table(const std::string& path, const std::string& contents) {
  return fmt::format(
      "cannot write the table to {}: the file there is not a table of {} and is not replaced; move it, or "
      "give another file",
      path, contents);
}

std::string no_file_locks(const std::string& path) {
  return fmt::format(
      "the file system of {} does not support file locks: make sure that no other run writes this file",
      path);
}

std::string name_not_utf8(const std::string& path) {
  return fmt::format("the name of {} is not UTF-8: the XDMF file cannot refer to it", path);
}

std::string results_kept_as(const std::string& path, const std::string& kept) {
  return fmt::format("the results that are at {} will be kept as {}", path, kept);
}

}  // namespace hawser::advice
