// Counts the MPI calls and bytes of each function on communicators of several ranks, for programs that load
// this library before MPI (LD_PRELOAD). Rank r writes them to $HAWSER_MPI_COUNTS.r when MPI ends, one line
// per function: name, calls, bytes. Bytes are those that this rank sends, or receives if it sends none. Reads
// of this rank from files by pread(), which HDF5 uses without MPI, are counted in the same way. The line
// `Memory` is the largest resident memory of this rank in bytes, the line `Allocated` the largest number of
// bytes allocated at a call on a communicator. Resident memory varies from run to run, because messages
// arrive and free blocks are reused in another order; allocations do not.
#include <dlfcn.h>
#include <malloc.h>
#include <mpi.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace {

struct Count {
  long calls = 0;
  double bytes = 0;
};
std::map<std::string, Count>& counts() {
  static std::map<std::string, Count> all;
  return all;
}

size_t& most_allocated() {
  static size_t most = 0;
  return most;
}

double size_of(int n, MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  return static_cast<double>(n) * size;
}

void add(const char* name, double bytes) {
  Count& c = counts()[name];
  ++c.calls;
  c.bytes += bytes;
}

void add(const char* name, MPI_Comm comm, double bytes) {
  int ranks = 1;
  PMPI_Comm_size(comm, &ranks);
  if (ranks <= 1) return;
  add(name, bytes);
  const struct mallinfo2 now = mallinfo2();
  most_allocated() = std::max(most_allocated(), now.uordblks + now.hblkhd);
}

}  // namespace

#define COUNTED(name, counted, parameters, arguments) \
  int MPI_##name parameters {                         \
    counted;                                          \
    return PMPI_##name arguments;                     \
  }
#define ON_COMM(name, bytes, parameters, arguments) COUNTED(name, add(#name, c, bytes), parameters, arguments)
#define ON_FILE(name, bytes, parameters, arguments) COUNTED(name, add(#name, bytes), parameters, arguments)

extern "C" {

ON_COMM(Allreduce, size_of(n, t), (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c),
        (a, b, n, t, o, c))
ON_COMM(Reduce, size_of(n, t),
        (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, int root, MPI_Comm c),
        (a, b, n, t, o, root, c))
ON_COMM(Bcast, size_of(n, t), (void* a, int n, MPI_Datatype t, int root, MPI_Comm c), (a, n, t, root, c))
ON_COMM(Barrier, 0, (MPI_Comm c), (c))
ON_COMM(Allgather, size_of(n, t),
        (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, MPI_Comm c),
        (a, n, t, b, m, u, c))
ON_COMM(Allgatherv, size_of(n, t),
        (const void* a, int n, MPI_Datatype t, void* b, const int* m, const int* d, MPI_Datatype u,
         MPI_Comm c),
        (a, n, t, b, m, d, u, c))
ON_COMM(Gather, size_of(n, t),
        (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, int root, MPI_Comm c),
        (a, n, t, b, m, u, root, c))
ON_COMM(Gatherv, size_of(n, t),
        (const void* a, int n, MPI_Datatype t, void* b, const int* m, const int* d, MPI_Datatype u, int root,
         MPI_Comm c),
        (a, n, t, b, m, d, u, root, c))
ON_COMM(Alltoall, size_of(n, t),
        (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, MPI_Comm c),
        (a, n, t, b, m, u, c))
ON_COMM(Scan, size_of(n, t), (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c),
        (a, b, n, t, o, c))
ON_COMM(Exscan, size_of(n, t), (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c),
        (a, b, n, t, o, c))
ON_COMM(Send, size_of(n, t), (const void* a, int n, MPI_Datatype t, int to, int tag, MPI_Comm c),
        (a, n, t, to, tag, c))
ON_COMM(Isend, size_of(n, t),
        (const void* a, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r),
        (a, n, t, to, tag, c, r))
ON_FILE(Startall, 0, (int n, MPI_Request* r), (n, r))

ON_FILE(File_open, 0, (MPI_Comm c, const char* name, int mode, MPI_Info i, MPI_File* f),
        (c, name, mode, i, f))
ON_FILE(File_close, 0, (MPI_File * f), (f))
ON_FILE(File_sync, 0, (MPI_File f), (f))
ON_FILE(File_set_view, 0,
        (MPI_File f, MPI_Offset at, MPI_Datatype e, MPI_Datatype t, const char* rep, MPI_Info i),
        (f, at, e, t, rep, i))
ON_FILE(File_write_at_all, size_of(n, t),
        (MPI_File f, MPI_Offset at, const void* a, int n, MPI_Datatype t, MPI_Status* s), (f, at, a, n, t, s))
ON_FILE(File_read_at_all, size_of(n, t),
        (MPI_File f, MPI_Offset at, void* a, int n, MPI_Datatype t, MPI_Status* s), (f, at, a, n, t, s))
ON_FILE(File_write_at, size_of(n, t),
        (MPI_File f, MPI_Offset at, const void* a, int n, MPI_Datatype t, MPI_Status* s), (f, at, a, n, t, s))
ON_FILE(File_read_at, size_of(n, t),
        (MPI_File f, MPI_Offset at, void* a, int n, MPI_Datatype t, MPI_Status* s), (f, at, a, n, t, s))

ssize_t pread(int file, void* to, size_t n, off_t at) {
  using Read = ssize_t (*)(int, void*, size_t, off_t);
  static const auto system = reinterpret_cast<Read>(dlsym(RTLD_NEXT, "pread"));
  const ssize_t got = system(file, to, n, at);
  if (got > 0) add("pread", static_cast<double>(got));
  return got;
}

int MPI_Finalize() {
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  add("Memory", 1024.0 * static_cast<double>(use.ru_maxrss));
  add("Allocated", static_cast<double>(most_allocated()));
  if (const char* path = std::getenv("HAWSER_MPI_COUNTS"))
    if (std::FILE* out = std::fopen((std::string(path) + "." + std::to_string(rank)).c_str(), "w")) {
      for (const auto& [name, count] : counts())
        std::fprintf(out, "%s %ld %.0f\n", name.c_str(), count.calls, count.bytes);
      std::fclose(out);
    }
  return PMPI_Finalize();
}

}  // extern "C"
