// Check that an input file exists, is regular and not too large.
#include "hawser/io/input_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace hawser::io {

namespace fs = std::filesystem;

std::string unreadable(const std::string& path, const std::string& kind, double max_megabytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return fmt::format("there is no such {} file", kind);
  if (fs::is_directory(status)) return fmt::format("is a directory, not a {} file", kind);
  if (!fs::is_regular_file(status)) return fmt::format("is a device or a pipe, not a {} file", kind);
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (error) return "cannot be read: " + error.message();
  const double mb = 1e-6 * static_cast<double>(bytes);
  if (mb > max_megabytes)
    return fmt::format("has {:.4g} MB, and a {} file has {:g} MB at most", mb, kind, max_megabytes);
  return "";
}

}  // namespace hawser::io
