// Whether the lines of a results file are those of the case, node by node, before a restart from it.
#include "hawser/run/restart_file_check.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "hawser/advice/restart.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/gather.hpp"
#include "hawser/io/hdf5.hpp"

namespace hawser::run {
namespace {

namespace fs = std::filesystem;

void compare_lines(const std::string& path, const Mesh& mesh) {
  const auto other = [&](const std::string& what) { return InputError(advice::other_case(what)); };
  const io::h5::Id file = io::h5::open_read(path);
  const auto names = io::h5::read_texts(file, "lines/name");
  const auto nodes = io::h5::read_array(file, "lines/nodes").values;
  const auto arc = io::h5::read_array(file, "nodes/arc_length").values;
  if (names.size() != mesh.lines.size())
    throw other(advice::other_number_of_lines(names.size(), mesh.lines.size()));
  for (size_t l = 0; l < names.size(); ++l) {
    const LineSpan& line = mesh.lines[l];
    if (names[l] != line.name) throw other(advice::other_line(l + 1, names[l], line.name));
    if (nodes[l] != line.nodes) throw other(advice::other_number_of_nodes(line.name, nodes[l], line.nodes));
    for (int n = line.first_node; n < line.first_node + line.nodes; ++n) {
      const double here = mesh.nodes[n].arc, there = arc.at(static_cast<size_t>(n));
      if (std::abs(here - there) > 1e-9 * line.length)
        throw other(advice::other_node(line.name, there, here));
    }
  }
}

}  // namespace

void check_restart_file(MPI_Comm comm, const std::string& path, const Mesh& mesh) {
  on_root(comm, [&] {
    std::error_code e;
    const auto refuse = [&](const std::string& why) { return InputError(advice::cannot_go_on(path, why)); };
    if (!fs::exists(path, e)) throw refuse(advice::no_file());
    if (access(path.c_str(), R_OK) != 0) throw refuse(advice::not_readable());
    io::h5::quiet();
    if (H5Fis_hdf5(path.c_str()) <= 0) throw refuse(advice::not_hdf5());
    try {
      compare_lines(path, mesh);
    } catch (const InputError& wrong) {
      throw refuse(wrong.what());
    } catch (const std::exception&) {
      throw refuse(advice::not_results());
    }
  });
}

}  // namespace hawser::run
