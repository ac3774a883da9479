// Transfer of a mesh surface made by one rank of a host to memory shared with the others, and errors thrown
// on all ranks.
#include "hawser/io/shared_on_host.hpp"

#include <stdexcept>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"

namespace hawser::io {

void rethrow_on_all_ranks(MPI_Comm comm, const std::function<void()>& work) {
  std::string input, program;
  try {
    work();
  } catch (const InputError& e) {
    input = e.what();
  } catch (const std::exception& e) {
    program = e.what();
  }
  program = first_text(comm, std::move(program));
  if (!program.empty()) throw std::runtime_error(program);
  input = first_text(comm, std::move(input));
  if (!input.empty()) throw InputError(input);
}

std::shared_ptr<const MeshSurface> shared_on_host(
    MPI_Comm comm, const Host& host, const std::function<std::shared_ptr<const MeshSurface>()>& make) {
  std::shared_ptr<const MeshSurface> surface;
  const auto make_on = [&](bool builds) {
    rethrow_on_all_ranks(comm, [&] {
      if (builds) surface = make();
    });
  };
  make_on(host.leads());
  bool lacks = false;
  if (host.size() > 1) {
    const auto block =
        host.share(surface ? surface->packed_size() : 0, [&](std::byte* to) { surface->write(to); });
    if (block) surface = std::make_shared<const MeshSurface>(block);
    lacks = !surface;
  }
  make_on(lacks);
  return surface;
}

}  // namespace hawser::io
