// `output`: names of the results file and of its series.
#include <filesystem>

#include "hawser/io/case_values.hpp"
#include "hawser/io/old_results.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::io {

using model::refuse;
using model::refuse_key;
using model::Value;
namespace fs = std::filesystem;

void finish_output(const Value& v, const CaseSource& source, model::Case& c) {
  model::Output& o = c.output;
  o.file = v.has("file") ? source.absolute(o.file)
                         : (fs::path(c.directory) / fs::path(c.path).stem()).string() + ".h5";
  const std::string extension = fs::path(o.file).extension().string();
  if (extension != ".h5")  // protects case and mesh files from being overwritten
    refuse(v["file"], "must end in .h5, found " + model::quote(v["file"].text));
  // Existing results are renamed, replacing an older backup.
  for (const model::Line& l : c.lines)
    for (const std::string& replaced : {o.file, backup_name(o.file)})
      if (std::error_code same; l.previous_shape && fs::equivalent(l.previous_shape->file, replaced, same))
        refuse_key(
            v.has("file") ? v["file"] : v, "output.file",
            "{} is the file that line '{}' starts from, and this run would overwrite it; give another 'file'",
            replaced, l.name);
  for (std::size_t i = 0; i < o.histories.size(); ++i) {
    model::HistoryPoint& p = o.histories[i];
    if (!p.line.empty()) to_length(p.at, length_of(c, p.line));
    if (p.name.empty())
      p.name = p.line.empty() ? p.body + p.volume : p.line + "@" + v["histories"].items[i]["at"].text;
  }
  for (model::Clearance& k : o.clearances)
    if (k.name.empty()) k.name = k.line + " to " + k.other_line + k.volume;
}

}  // namespace hawser::io
