// The class XdmfWriter: XML grids of lines and volumes at each output, which refer to rows of the HDF5 file,
// and the names that both files share. run/volumes.cpp (volume_meshes) selects the mesh of each volume.
#include "hawser/io/xdmf.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

#include "hawser/io/results.hpp"
#include "hawser/io/results_build.hpp"
#include "hawser/io/write_error.hpp"
#include "hawser/io/xml_text.hpp"

namespace hawser::io {

namespace {

// Above this number of lines one grid holds all, to keep the text of an output short.
constexpr size_t kSeparateLines = 16;

std::string joined(const std::vector<long long>& numbers) {
  std::string out;
  for (const long long n : numbers) {
    if (!out.empty()) out += ' ';
    out += std::to_string(n);
  }
  return out;
}

struct Slab {
  std::string dataset;  // in the HDF5 file
  std::string type;     // NumberType and Precision
  std::vector<long long> start, count, shape;
  bool by_output = false;  // one row per output; start and count apply within the row
};

// Placeholders for the parts that differ between outputs: row number, next row number, and time. Names cannot
// contain them: xml_text() replaces control characters.
constexpr char kRow = 1, kNext = 2, kTime = 3;

const std::string kDouble = "NumberType=\"Float\" Precision=\"8\"";
const std::string kFloat = "NumberType=\"Float\" Precision=\"4\"";
const std::string kInt = "NumberType=\"Int\" Precision=\"4\"";
const std::string kChar = "NumberType=\"Char\" Precision=\"1\"";

// A whole dataset, or a box in the notation of XDMF 3, file:/dataset|start:stride:count:shape (ParaView 5.11
// does not read ItemType="HyperSlab" for node fields). It refers to no other rows, so the text stays valid
// when the HDF5 file is rebuilt with more capacity.
std::string item(const std::string& h5, const Slab& s) {
  std::string text = h5 + ":/" + s.dataset;
  if (s.by_output || s.count != s.shape) {
    const std::vector<long long> stride(s.start.size(), 1);
    const auto part = [&](char row, const std::vector<long long>& sizes) {
      return (s.by_output ? std::string{row, ' '} : "") + joined(sizes);
    };
    text += '|';
    text +=
        part(kRow, s.start) + ":" + part('1', stride) + ":" + part('1', s.count) + ":" + part(kNext, s.shape);
  }
  return "<DataItem Dimensions=\"" + joined(s.count) + "\" " + s.type + " Format=\"HDF\">" + text +
         "</DataItem>";
}

std::string attribute(const std::string& name, const std::string& kind, const std::string& center,
                      const std::string& data) {
  return "<Attribute Name=\"" + xml_text(name) + "\" AttributeType=\"" + kind + "\" Center=\"" + center +
         "\">" + data + "</Attribute>\n";
}

}  // namespace

std::string safe_name(const std::string& name) {
  std::string out = name.empty() ? "_" : name;
  for (char& c : out)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '@' && c != '.') c = '_';
  return out == "." || out == ".." ? std::string(out.size(), '_') : out;
}

std::vector<std::string> safe_names(const std::vector<std::string>& names) {
  std::set<std::string> used;
  std::vector<std::string> out;
  for (const auto& name : names) {
    std::string safe = safe_name(name);
    for (int k = 2; !used.insert(safe).second; ++k) safe = safe_name(name) + "_" + std::to_string(k);
    out.push_back(safe);
  }
  return out;
}

XdmfWriter::XdmfWriter(const ResultContents& contents, const std::string& h5_name)
    : contents_(&contents), h5_name_(xml_text(h5_name)) {
  std::string text =
      "<Grid Name=\"output\" GridType=\"Collection\" CollectionType=\"Spatial\">\n<Time Value=\"";
  text += kTime;
  text += "\"/>\n";
  add_lines(text);
  add_volumes(text);
  text += "</Grid>\n";
  for (size_t from = 0; from < text.size();) {
    const size_t to = std::min(text.find_first_of({kRow, kNext, kTime}, from), text.size());
    pieces_.push_back({text.substr(from, to - from), to < text.size() ? text[to] : '\0'});
    from = to + 1;
  }
}

void XdmfWriter::add_output(size_t row, std::string& text) const {
  char time[32];
  std::snprintf(time, sizeof time, "%.17g", times_[row]);
  const std::string this_row = std::to_string(row);
  const std::string next = std::to_string(row + 1);
  for (const TextPart& p : pieces_) {
    text += p.text;
    if (p.then) text += p.then == kTime ? time : p.then == kRow ? this_row : next;
  }
}

void XdmfWriter::add_lines(std::string& text) const {
  const auto& c = *contents_;
  const long long total = c.nodes_total();
  const long long lines = static_cast<long long>(c.lines.size());
  const auto grid = [&](const std::string& name, long long first, long long nodes,
                        const std::string& topology) {
    text += "<Grid Name=\"" + xml_text(name) + "\" GridType=\"Uniform\">\n" + topology;
    for (const auto& f : c.fields) {
      Slab s{"fields/" + safe_name(f.name),
             c.single_precision ? kFloat : kDouble,
             {first},
             {nodes},
             {total},
             true};
      if (f.components > 1) {
        s.start.push_back(0);
        s.count.push_back(f.components);
        s.shape.push_back(f.components);
      }
      const char* kind = f.components == 1 ? "Scalar" : f.components == 3 ? "Vector" : "Matrix";
      if (f.name == "position")
        text += "<Geometry GeometryType=\"XYZ\">" + item(h5_name_, s) + "</Geometry>\n";
      else
        text += attribute(f.name, kind, "Node", item(h5_name_, s));
    }
    text += attribute("arc_length", "Scalar", "Node",
                      item(h5_name_, {"nodes/arc_length", kDouble, {first}, {nodes}, {total}}));
    for (const std::string field : {"line", "rank"})
      text += attribute(field, "Scalar", "Node",
                        item(h5_name_, {"nodes/" + field, kInt, {first}, {nodes}, {total}}));
    text += "</Grid>\n";
  };
  if (c.lines.size() > kSeparateLines) {
    const long long cells = total + 2 * lines;
    grid("lines", 0, total,
         "<Topology TopologyType=\"Mixed\" NumberOfElements=\"" + std::to_string(lines) + "\">" +
             item(h5_name_, {"lines/cells", kInt, {0}, {cells}, {cells}}) + "</Topology>\n");
    return;
  }
  for (size_t l = 0; l < c.lines.size(); ++l) {
    const ResultLine& line = c.lines[l];
    grid(c.line_labels[l].name, line.first_node, line.nodes,
         "<Topology TopologyType=\"Polyline\" NumberOfElements=\"1\" NodesPerElement=\"" +
             std::to_string(line.nodes) + "\">" +
             item(h5_name_, {"nodes/number", kInt, {0}, {line.nodes}, {total}}) + "</Topology>\n");
  }
}

void XdmfWriter::add_volumes(std::string& text) const {
  const auto places = volume_places(*contents_);
  for (size_t i = 0; i < places.size(); ++i) {
    const auto& v = contents_->volumes[i];
    const long long nv = std::ssize(v.displayed_vertices());
    const long long nt = std::ssize(v.displayed_triangles());
    const std::string mesh = places[i] + (v.coarsened() ? "/drawn_" : "/");
    const Slab triangles{mesh + "triangles", kInt, {0, 0}, {nt, 3}, {nt, 3}};
    const Slab points = v.moves() ? Slab{places[i] + "/moved", kFloat, {0, 0}, {nv, 3}, {nv, 3}, true}
                                  : Slab{places[i] + "/vertices", kDouble, {0, 0}, {nv, 3}, {nv, 3}};
    text += "<Grid Name=\"" + xml_text(v.name) + "\" GridType=\"Uniform\">\n" +
            "<Topology TopologyType=\"Triangle\" NumberOfElements=\"" + std::to_string(nt) + "\">" +
            item(h5_name_, triangles) + "</Topology>\n<Geometry GeometryType=\"XYZ\">" +
            item(h5_name_, points) + "</Geometry>\n";
    if (!v.active.empty())
      text +=
          attribute("active", "Scalar", "Cell", item(h5_name_, {mesh + "active", kChar, {0}, {nt}, {nt}}));
    text += "</Grid>\n";
  }
}

void XdmfWriter::save(const std::string& path) const {
  const std::string new_path = path + ".new";
  {
    std::ofstream out(new_path, std::ios::binary);
    out << kXdmfBegin << xml_text(contents_->run.case_path.empty() ? "hawser" : contents_->run.case_path)
        << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    std::string outputs;
    for (size_t row = 0; row < times_.size(); ++row) {
      outputs.clear();
      add_output(row, outputs);
      out << outputs;
    }
    out << "</Grid>\n</Domain>\n</Xdmf>\n";
    out.flush();
    if (!out) {
      const std::string text = cannot_write(path, std::strerror(errno));
      out.close();
      std::remove(new_path.c_str());
      throw WriteError(text);
    }
  }
  if (std::rename(new_path.c_str(), path.c_str()))
    throw WriteError("cannot write " + path + ": " + std::strerror(errno));
}

}  // namespace hawser::io
