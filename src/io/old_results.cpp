// Recognition of an earlier results file by its attribute and of an XDMF file by its first characters, and
// renaming of both.
#include "hawser/io/old_results.hpp"

#include <exception>
#include <filesystem>
#include <fstream>

#include "hawser/io/hdf5.hpp"
#include "hawser/io/write_error.hpp"
#include "hawser/io/xdmf.hpp"

namespace hawser::io {
namespace fs = std::filesystem;

std::string xdmf_beside(const std::string& path) {
  return fs::path(path).replace_extension(".xdmf").string();
}

bool is_results(const std::string& path) {
  std::error_code e;
  if (!fs::is_regular_file(path, e)) return false;  // opening a pipe would block
  try {
    const h5::Id file = h5::open_read(path);
    return H5Aexists(file, "hawser_results") > 0;
  } catch (const std::exception&) {
    return false;
  }
}

bool is_xdmf(const std::string& path) {
  std::error_code e;
  if (!fs::is_regular_file(path, e)) return false;
  std::string text(kXdmfBegin.size(), '\0');
  std::ifstream(path, std::ios::binary).read(text.data(), static_cast<std::streamsize>(text.size()));
  return text == kXdmfBegin;
}

void back_up_results(const std::string& path) {
  for (const std::string& name : {path, xdmf_beside(path)}) {
    if (!fs::exists(fs::symlink_status(name))) continue;
    std::error_code e;
    fs::rename(name, backup_name(name), e);
    if (e) throw WriteError(cannot_write(backup_name(name), e.message()));
  }
}

}  // namespace hawser::io
