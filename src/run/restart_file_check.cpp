// Comparison of the lines of a results file with those of the case, node by node, before a restart.
#include "hawser/run/restart_file_check.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "hawser/advice/restart.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/hdf5.hpp"

namespace hawser::run {
namespace {

namespace fs = std::filesystem;

// Compares the lines whose first node is one of `owned` (ascending); each rank reads only these.
void compare_lines(const std::string& path, const Mesh& mesh, std::span<const int> owned) {
  const auto other = [&](const std::string& difference) {
    return InputError(advice::other_case(difference));
  };
  const io::h5::Id file = io::h5::open_parts(path);
  const size_t lines = io::h5::shape_of(io::h5::open_dataset(file, "lines/name")).at(0);
  if (lines != mesh.lines.size()) throw other(advice::other_number_of_lines(lines, mesh.lines.size()));
  for (size_t l = 0, end = 0; l < lines; l = end) {
    const auto on_this_rank = [&](size_t line) {
      return line < lines && std::binary_search(owned.begin(), owned.end(), mesh.lines[line].first_node);
    };
    end = l + 1;
    if (!on_this_rank(l)) continue;
    while (on_this_rank(end)) ++end;
    const auto names = io::h5::read_texts_part(file, "lines/name", l, end - l);
    const auto nodes = io::h5::read_part(file, "lines/nodes", l, end - l);
    for (size_t k = l; k < end; ++k) {
      const LineSpan& line = mesh.lines[k];
      if (const std::string name = mesh.line_names[k]; names[k - l] != name)
        throw other(advice::other_line(k + 1, names[k - l], name));
      if (nodes[k - l] != line.nodes)
        throw other(advice::other_number_of_nodes(mesh.line_names[k], nodes[k - l], line.nodes));
    }
    const int first = mesh.lines[l].first_node;
    const int last = mesh.lines[end - 1].first_node + mesh.lines[end - 1].nodes;
    const auto arc = io::h5::read_part(file, "nodes/arc_length", static_cast<hsize_t>(first),
                                       static_cast<hsize_t>(last - first));
    for (int n = first; n < last; ++n) {
      const int line = mesh.node(n).line;
      const double in_case = mesh.node(n).arc;
      const double in_checkpoint = arc[static_cast<size_t>(n - first)];
      if (std::abs(in_case - in_checkpoint) > 1e-9 * mesh.lines[line].length)
        throw other(advice::other_node(mesh.line_names[line], in_checkpoint, in_case));
    }
  }
}

}  // namespace

void check_restart_file(MPI_Comm comm, const std::string& path, const Mesh& mesh,
                        std::span<const int> owned) {
  const auto check = [&] {
    std::error_code e;
    if (!fs::exists(path, e)) return advice::no_file();
    if (access(path.c_str(), R_OK) != 0) return advice::not_readable();
    io::h5::quiet();
    if (H5Fis_hdf5(path.c_str()) <= 0) return advice::not_hdf5();
    try {
      compare_lines(path, mesh, owned);
    } catch (const InputError& wrong) {
      return std::string(wrong.what());
    } catch (const std::exception&) {
      return advice::not_results();
    }
    return std::string();
  };
  const std::string why = first_text(comm, check());
  if (!why.empty()) throw InputError(advice::cannot_continue(path, why));
}

}  // namespace hawser::run
