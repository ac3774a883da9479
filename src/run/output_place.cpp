// The class OutputPlace: links, folder and name of the results file, and handling of earlier files there.
#include "hawser/run/output_place.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "hawser/advice/output_files.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/old_results.hpp"
#include "hawser/io/write_error.hpp"
#include "hawser/io/xml_text.hpp"

namespace hawser::run {
namespace {

namespace fs = std::filesystem;

// Target of a chain of links; circular links are returned unchanged.
std::string resolved_links(fs::path path) {
  std::error_code e;
  for (int i = 0; i < 40 && fs::is_symlink(path, e); ++i)
    path = path.parent_path() / fs::read_symlink(path, e);
  return path.string();
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code e;
  return fs::equivalent(a, b, e);
}

}  // namespace

void check_not_read(const std::string& kind, const std::string& path, const std::vector<std::string>& written,
                    const std::vector<std::string>& read) {
  for (const std::string& out : written)
    for (const std::string& in : read)
      if (same_file(out, in)) throw InputError(advice::would_replace_input(kind, path, in, out));
}

void check_folder(const std::string& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  std::error_code e;
  if (!fs::exists(folder, e)) throw InputError(advice::no_folder(path, folder.string()));
  if (!fs::is_directory(folder, e)) throw InputError(advice::not_a_folder(path, folder.string()));
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError(advice::folder_not_writable(path, folder.string()));
}

void check_table(const std::string& path, std::string_view head, const std::string& contents,
                 const std::vector<std::string>& inputs) {
  check_not_read("the table", path, {path}, inputs);
  check_folder(path);
  std::ifstream file(path, std::ios::binary);
  std::string start(head.size(), ' ');
  if (file && !(file.read(start.data(), static_cast<std::streamsize>(start.size())) && start == head))
    throw InputError(advice::not_such_a_table(path, contents));
}

std::string table_of_body(const std::string& path, const std::string& body) {
  fs::path out(path);
  std::string name = out.stem().string() + "-" + body + out.extension().string();
  std::replace(name.begin(), name.end(), '/', '-');
  return out.replace_filename(name).string();
}

std::string path_of_output(const std::string& case_path, const std::string& output,
                           const std::string& ending) {
  if (!output.empty()) return fs::absolute(output).string();
  const fs::path beside(case_path);
  return (beside.parent_path() / (beside.stem().string() + ending)).string();
}

void write_table(MPI_Comm comm, const std::string& path, const std::string& text) {
  std::string failure;
  if (rank_of(comm) == 0) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (file.fail()) failure = io::cannot_write(path, std::strerror(errno));
  }
  failure = first_text(comm, failure);
  if (!failure.empty()) throw io::WriteError(failure);
}

OutputPlace::OutputPlace(MPI_Comm comm, const std::string& path, const std::string& restart,
                         const std::vector<std::string>& inputs)
    : path_(resolved_links(path)), appends_(same_file(restart, path_)) {
  on_root(comm, [&] {
    check();
    std::vector<std::string> read = inputs;
    if (!appends_ && !restart.empty()) read.push_back(restart);
    // Every file that the run creates, renames or removes.
    const std::string xdmf = io::xdmf_beside(path_);
    check_not_read("the results", path_,
                   {path_, path_ + ".new", path_ + ".lock", io::backup_name(path_), xdmf, xdmf + ".new",
                    io::backup_name(xdmf)},
                   read);
    lock_ = std::make_unique<io::RunLock>(path_);
    if (!lock_->held()) notes_.push_back(advice::no_file_locks(path_));
    check_old();
    if (!io::xml_holds(fs::path(path_).filename().string())) notes_.push_back(advice::name_not_utf8(path_));
  });
}

// Checks names and folders.
void OutputPlace::check() const {
  if (fs::is_symlink(path_)) throw InputError(advice::link_to_itself(path_));
  const fs::path file(path_);
  const fs::path folder = fs::absolute(file).parent_path();
  if (file.extension() != ".h5") throw InputError(advice::name_must_end_in_h5(path_));
  check_folder(path_);
  const std::string longest = fs::path(io::xdmf_beside(path_) + ".new").filename().string();
  const long limit = pathconf(folder.c_str(), _PC_NAME_MAX);
  if (limit > 0 && longest.size() > static_cast<size_t>(limit))
    throw InputError(advice::name_too_long(path_, longest.size(), limit));
}

// Checks existing files that the run will replace.
void OutputPlace::check_old() {
  const auto exists_name = [](const std::string& name) { return fs::exists(fs::symlink_status(name)); };
  const auto check_one = [&](const std::string& name, bool is_results) {
    if (!exists_name(name) || is_results) return;
    throw InputError(fs::is_directory(name) ? advice::name_is_a_folder(path_, name)
                                            : advice::third_party_file(path_, name));
  };
  const std::string xdmf = io::xdmf_beside(path_);
  check_one(path_, io::is_results(path_));
  check_one(xdmf, io::is_xdmf(xdmf));
  for (const std::string& name : {path_ + ".new", xdmf + ".new"}) check_one(name, !fs::is_directory(name));
  if (appends_) return;
  const std::string kept = io::backup_name(path_);
  const std::string kept_xdmf = io::backup_name(xdmf);
  check_one(kept, io::is_results(kept));
  check_one(kept_xdmf, io::is_xdmf(kept_xdmf));
  if (exists_name(path_)) notes_.push_back(advice::results_kept_as(path_, kept));
}

}  // namespace hawser::run
