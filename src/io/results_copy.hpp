// Takes over an earlier results file into a new one with more capacity, or with other rows after the kept
// ones.
#pragma once

#include <hdf5.h>

#include <string>

#include "hawser/io/results_build.hpp"

namespace hawser::io {

enum class CopiedCheckpoints { all, newest };

// Copies the `kept` rows and the checkpoints of the file at `path` into the new file `to`, whose datasets
// exist. Serial. Throws InputError if lines, histories or columns of the earlier file are not those of the
// contents.
void copy_earlier(const std::string& path, hid_t to, const ResultContents& contents, const ResultRoom& room,
                  const ValidRows& kept, CopiedCheckpoints checkpoints);

}  // namespace hawser::io
