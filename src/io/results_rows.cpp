// The class SharedFile: parallel writing of rows to open datasets by all ranks or one, flushing, and
// agreement of the ranks on the first error.
#include "hawser/io/results_rows.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/write_error.hpp"

namespace hawser::io {

std::vector<RowRun> runs_of(const std::vector<int>& ascending) {
  std::vector<RowRun> runs;
  for (const int n : ascending) {
    if (runs.empty() || runs.back().first + runs.back().count != n) runs.push_back({n, 0});
    ++runs.back().count;
  }
  return runs;
}

SharedFile::SharedFile(MPI_Comm comm, std::string path) : comm_(comm), path_(std::move(path)) {
  MPI_Comm_rank(comm_, &rank_);
  // Open MPI's OMPIO makes names of less than 256 characters from the path and aborts on overflow. ROMIO has
  // no such limit, but is slower. The choice is fixed at the first file.
  if (path_.size() > 200) setenv("OMPI_MCA_io", "^ompio", 0);
}

void SharedFile::open(const std::vector<std::string>& datasets) {
  attempt([&] {
    h5::quiet();
    const h5::Id access = h5::serial_access();
    transfer_ = h5::own(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "HDF5 property list");
    const int size = ranks_of(comm_);
    if (size > 1) {
      h5::check(H5Pset_fapl_mpio(access, comm_, MPI_INFO_NULL), "HDF5 with MPI");
      h5::check(H5Pset_dxpl_mpio(transfer_, H5FD_MPIO_INDEPENDENT), "HDF5 with MPI");
    } else {
      // Without a sieve buffer data are with the system at once, as with MPI, and survive a kill.
      h5::check(H5Pset_sieve_buf_size(access, 0), "HDF5 property list");
    }
    file_ = h5::own(H5Fopen(path_.c_str(), H5F_ACC_RDWR, access), H5Fclose, "cannot open " + path_);
    for (const auto& name : datasets) open_[name] = h5::open_dataset(file_, name);
  });
  agree();
}

void SharedFile::close() {
  open_.clear();
  file_.reset();
}

void SharedFile::note(const std::exception& e) {
  internal_ = dynamic_cast<const std::logic_error*>(&e) || dynamic_cast<const InputError*>(&e);
  const bool reported = internal_ || dynamic_cast<const WriteError*>(&e);
  error_ = reported ? e.what() : cannot_write(path_, e.what());
}

void SharedFile::agree() {
  const int size = ranks_of(comm_);
  int failed_rank = error_.empty() ? size : rank_;
  all_reduce(comm_, MPI_MIN, failed_rank);
  if (failed_rank == size) return;
  auto length = static_cast<int>(error_.size());
  MPI_Bcast(&length, 1, MPI_INT, failed_rank, comm_);
  error_.resize(length);
  MPI_Bcast(error_.data(), length, MPI_CHAR, failed_rank, comm_);
  MPI_Bcast(&internal_, 1, MPI_C_BOOL, failed_rank, comm_);
  const std::string text = std::exchange(error_, "");
  if (internal_) throw std::runtime_error(text);
  throw WriteError(text);
}

namespace {
// Rows without bodies or lines are empty and have no place in the file.
bool empty(const h5::Shape& shape) {
  return std::find(shape.begin(), shape.end(), hsize_t{0}) != shape.end();
}
}  // namespace

void SharedFile::write_runs(const std::string& name, hid_t type, long long row,
                            const std::vector<RowRun>& runs, const void* data, long long rows) {
  attempt([&] {
    const hid_t set = open_.at(name);
    const h5::Shape shape = h5::shape_of(set);
    if (empty(shape)) return;
    const size_t axis = row >= 0 ? 1 : 0;
    h5::Shape start(shape.size(), 0);
    h5::Shape block(shape);
    hsize_t total = 0;
    hsize_t inner = row >= 0 ? static_cast<hsize_t>(rows) : 1;
    for (size_t i = axis + 1; i < shape.size(); ++i) inner *= shape[i];
    if (row >= 0) {
      start[0] = static_cast<hsize_t>(row);
      block[0] = static_cast<hsize_t>(rows);
    }
    const h5::Id space = h5::own(H5Dget_space(set), H5Sclose, name);
    h5::check(H5Sselect_none(space), name);
    for (const auto& run : runs) {
      start[axis] = static_cast<hsize_t>(run.first);
      block[axis] = static_cast<hsize_t>(run.count);
      const H5S_seloper_t how = total == 0 ? H5S_SELECT_SET : H5S_SELECT_OR;
      h5::check(H5Sselect_hyperslab(space, how, start.data(), nullptr, block.data(), nullptr), name);
      total += block[axis] * inner;
    }
    transfer(set, type, space, total, data);
  });
}

void SharedFile::write_rows(const std::string& name, hid_t type, long long first, long long rows,
                            bool contributes, const void* data) {
  attempt([&] {
    const hid_t set = open_.at(name);
    h5::Shape count = h5::shape_of(set);
    h5::Shape start(count.size(), 0);
    if (empty(count)) return;
    start[0] = static_cast<hsize_t>(first);
    count[0] = static_cast<hsize_t>(rows);
    hsize_t total = contributes ? 1 : 0;
    for (const hsize_t n : count) total *= n;
    const h5::Id space = h5::own(H5Dget_space(set), H5Sclose, name);
    h5::check(total ? H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr)
                    : H5Sselect_none(space),
              name);
    transfer(set, type, space, total, data);
  });
}

void SharedFile::transfer(hid_t set, hid_t type, hid_t space, hsize_t n, const void* data) {
  const hsize_t length = std::max<hsize_t>(n, 1);
  const h5::Id memory = h5::own(H5Screate_simple(1, &length, nullptr), H5Sclose, "rows");
  if (n == 0) h5::check(H5Sselect_none(memory), "rows");
  const double nothing = 0;
  h5::check(H5Dwrite(set, type, memory, space, transfer_, n ? data : &nothing), "cannot write " + path_);
}

void SharedFile::write_alone(const std::string& name, hid_t type, const void* data) {
  attempt([&] {
    h5::check(H5Dwrite(open_.at(name), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "cannot write " + path_);
  });
}

void SharedFile::flush() {
  attempt([&] { h5::check(H5Fflush(file_, H5F_SCOPE_LOCAL), "cannot write " + path_); });
}

}  // namespace hawser::io
