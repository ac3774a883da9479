// XDMF file: XML index of the HDF5 rows that ParaView displays.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hawser::io {

struct ResultContents;

// First characters of every XDMF file of hawser.
inline constexpr std::string_view kXdmfBegin =
    "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n<Grid Name=\"";

// Names in the HDF5 file: characters with a meaning in paths or XDMF become '_'.
std::string safe_name(const std::string& name);
std::vector<std::string> safe_names(const std::vector<std::string>& names);  // and made distinct

// One temporal collection; each save() replaces the whole file atomically.
class XdmfWriter {
 public:
  // The contents must outlive the writer. `h5_name`: file name without folder; both files are in the same
  // folder.
  XdmfWriter(const ResultContents& contents, const std::string& h5_name);

  void add(double time) { times_.push_back(time); }  // of the next output, s

  // Throws std::runtime_error if the file cannot be written.
  void save(const std::string& path) const;

 private:
  void add_output(size_t row, std::string& text) const;
  void add_lines(std::string& text) const;
  void add_volumes(std::string& text) const;

  struct TextPart {
    std::string text;
    char then;  // variable part that comes next; 0: end
  };
  const ResultContents* contents_;
  std::string h5_name_;
  std::vector<double> times_;     // of the outputs, s
  std::vector<TextPart> pieces_;  // text of an output
};

}  // namespace hawser::io
