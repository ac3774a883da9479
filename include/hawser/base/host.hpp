// The ranks of one host, and memory they share.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace hawser {

class Host {
 public:
  // Collective over comm.
  explicit Host(MPI_Comm comm) {
    MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &comm_);
    MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN);
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
  }
  ~Host() { MPI_Comm_free(&comm_); }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  MPI_Comm comm() const { return comm_; }
  int size() const { return size_; }
  bool leads() const { return rank_ == 0; }

  // A block of memory that exists once per host, begins on a cache line and contains what `fill` writes on
  // the leading rank, which also specifies its size in bytes. Null on all ranks if the host has none
  // available. Collective over the host, as is the release of the last reference: ranks release blocks in the
  // same order, at the latest before MPI_Finalize.
  std::shared_ptr<const std::byte> share(std::size_t size,
                                         const std::function<void(std::byte*)>& fill) const {
    constexpr std::size_t kLine = 64;
    std::uint64_t bytes = size;
    MPI_Bcast(&bytes, 1, MPI_UINT64_T, 0, comm_);
    struct Window {
      MPI_Win win = MPI_WIN_NULL;
      ~Window() {
        int finished = 0;
        MPI_Finalized(&finished);
        if (win != MPI_WIN_NULL && !finished) MPI_Win_free(&win);
      }
    };
    auto window = std::make_shared<Window>();
    void* at = nullptr;
    int allocated = MPI_Win_allocate_shared(leads() ? static_cast<MPI_Aint>(bytes + kLine) : 0, 1,
                                            MPI_INFO_NULL, comm_, &at, &window->win) == MPI_SUCCESS;
    MPI_Allreduce(MPI_IN_PLACE, &allocated, 1, MPI_INT, MPI_MIN, comm_);
    if (!allocated) return nullptr;
    MPI_Aint room = 0;
    int unit = 1;
    MPI_Win_shared_query(window->win, 0, &room, &unit, &at);
    // Pages begin at the same offset on all ranks, so this is the same byte.
    std::size_t space = room;
    auto* block = static_cast<std::byte*>(std::align(kLine, bytes, at, space));
    if (leads()) fill(block);
    MPI_Win_fence(0, window->win);
    MPI_Barrier(comm_);
    return {window, block};
  }

 private:
  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
};

}  // namespace hawser
