// The XDMF file: an XML table of contents that tells ParaView which rows of the HDF5 file make a picture.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hawser::io {

struct ResultContents;

// What every such file of hawser's begins with.
inline constexpr std::string_view kXdmfBegin =
    "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n<Grid Name=\"";

// Names in the HDF5 file: what a path or an XDMF reader could trip over becomes '_'.
std::string safe_name(const std::string& name);
std::vector<std::string> safe_names(const std::vector<std::string>& names);  // and all different

// One temporal collection; each save() puts a whole valid file in place at once.
class XdmfWriter {
 public:
  // The contents must outlive the writer. `h5_name`: file name without folder; both files lie side by side.
  XdmfWriter(const ResultContents& contents, const std::string& h5_name);

  void add(double time) { times_.push_back(time); }  // of the next output, s

  // Throws std::runtime_error when the file cannot be written.
  void save(const std::string& path) const;

 private:
  void add_output(size_t row, std::string& text) const;
  void add_lines(std::string& text) const;
  void add_volumes(std::string& text) const;

  struct Piece {
    std::string text;
    char then;  // what follows it and differs from output to output; 0: the end
  };
  const ResultContents* contents_;
  std::string h5_name_;
  std::vector<double> times_;  // of the outputs, s
  std::vector<Piece> pieces_;  // of the text of an output
};

}  // namespace hawser::io
