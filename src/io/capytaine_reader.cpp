// Reader of Capytaine's NetCDF (user manual, "Export outputs", "Conventions", "Hydrostatics"): amplitudes
// with exp(-i omega t), so that forces are conjugates of WAMIT's; directions in rad; SI values for the
// density and gravity of the file; hydrostatic stiffness including the body's weight.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "hawser/advice/hydrodynamic_files.hpp"
#include "hawser/io/input_file.hpp"
#include "hydrodynamic_parts.hpp"
#include "netcdf.hpp"

namespace hawser::io {
namespace {

using model::HydrodynamicData;

constexpr std::array kModes = {"Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"};

class CapytaineFile {
 public:
  explicit CapytaineFile(const std::string& path)
      : path_(path),
        variables_(
            read_netcdf(path, {"omega", "wave_direction", "radiating_dof", "influenced_dof", "complex",
                               "added_mass", "radiation_damping", "diffraction_force", "Froude_Krylov_force",
                               "excitation_force", "hydrostatic_stiffness", "inertia_matrix",
                               "rotation_center", "rho", "g", "forward_speed", "water_depth"})) {}

  [[noreturn]] void refuse(const std::string& text) const { throw std::runtime_error(path_ + ": " + text); }
  bool has(const std::string& name) const { return variables_.count(name) > 0; }
  const NetcdfVariable& at(const std::string& name) const {
    const auto found = variables_.find(name);
    if (found == variables_.end())
      refuse(fmt::format("has no variable '{}', which Capytaine's datasets have", name));
    return found->second;
  }
  const std::vector<double>& numbers(const std::string& name) const {
    const NetcdfVariable& v = at(name);
    if (v.values.empty()) refuse(fmt::format("variable '{}' has no numbers", name));
    return v.values;
  }
  // Value of a constant, or of a variable along a dimension of length one.
  double number(const std::string& name) const {
    const std::vector<double>& values = numbers(name);
    if (std::any_of(values.begin(), values.end(), [&](double x) { return x != values.front(); }))
      refuse(fmt::format("has several values of '{}': export a dataset with one of them", name));
    return values.front();
  }
  // Dimension of frequencies: 'omega', or another variable by which the dataset was made.
  const std::string& frequencies() const {
    const NetcdfVariable& v = at("omega");
    if (v.dimensions.size() != 1) refuse("variable 'omega' is not along one dimension");
    return v.dimensions.front();
  }

  // Values of a variable by indices along named dimensions; other dimensions must have length one.
  class View {
   public:
    View(const CapytaineFile& file, const std::string& name, const std::vector<std::string>& dimensions)
        : file_(&file), name_(name), values_(&file.numbers(name)), strides_(dimensions.size(), 0) {
      const NetcdfVariable& v = file.at(name);
      size_t stride = 1;
      for (size_t d = v.shape.size(); d-- > 0;) {
        const auto which = std::find(dimensions.begin(), dimensions.end(), v.dimensions[d]);
        if (which != dimensions.end()) {
          strides_[static_cast<size_t>(which - dimensions.begin())] = stride;
        } else if (v.shape[d] != 1) {
          file.refuse(fmt::format("variable '{}' has {} places along '{}': export a dataset with one of them",
                                  name, v.shape[d], v.dimensions[d]));
        }
        stride *= v.shape[d];
      }
      if (std::find(strides_.begin(), strides_.end(), 0) != strides_.end())
        file.refuse(fmt::format("variable '{}' is not along {}", name, fmt::join(dimensions, ", ")));
    }
    double operator()(std::initializer_list<size_t> places) const {
      size_t at = 0, d = 0;
      for (const size_t place : places) at += strides_[d++] * place;
      if (at >= values_->size()) file_->refuse(fmt::format("variable '{}' is too short", name_));
      return (*values_)[at];
    }

   private:
    const CapytaineFile* file_;
    std::string name_;
    const std::vector<double>* values_;
    std::vector<size_t> strides_;
  };

 private:
  std::string path_;
  std::map<std::string, NetcdfVariable> variables_;
};

// Mode, from 0, of each index along a dimension of degrees of freedom; -1 for non-rigid modes. With several
// bodies names are BODY__Heave, and bodies are numbered in order of appearance.
std::vector<int> modes_along(const CapytaineFile& file, const std::string& name,
                             std::vector<std::string>& bodies) {
  const std::vector<std::string>& texts = file.at(name).texts;
  if (texts.empty()) file.refuse(fmt::format("variable '{}' has no names of freedoms", name));
  std::vector<int> modes;
  for (const std::string& text : texts) {
    const size_t parts = text.rfind("__");
    const std::string body = parts == std::string::npos ? "" : text.substr(0, parts);
    const std::string mode = parts == std::string::npos ? text : text.substr(parts + 2);
    const auto which = std::find(kModes.begin(), kModes.end(), mode);
    if (which == kModes.end()) {
      modes.push_back(-1);
      continue;
    }
    auto known = std::find(bodies.begin(), bodies.end(), body);
    if (known == bodies.end()) known = bodies.insert(bodies.end(), body);
    modes.push_back(static_cast<int>(6 * (known - bodies.begin()) + (which - kModes.begin())));
  }
  return modes;
}

struct Freedoms {
  std::vector<int> radiating, influenced;
};

Freedoms freedoms(const CapytaineFile& file, HydrodynamicData& data, std::vector<std::string>& notes) {
  std::vector<std::string> bodies;
  Freedoms f;
  f.influenced = modes_along(file, "influenced_dof", bodies);
  f.radiating = modes_along(file, "radiating_dof", bodies);
  data.bodies = static_cast<int>(bodies.size());
  if (data.bodies == 0)
    file.refuse(fmt::format("has none of the freedoms {} of a rigid body", fmt::join(kModes, ", ")));
  for (int mode = 0; mode < 6 * data.bodies; ++mode)
    if (std::find(f.radiating.begin(), f.radiating.end(), mode) == f.radiating.end() ||
        std::find(f.influenced.begin(), f.influenced.end(), mode) == f.influenced.end())
      notes.push_back(advice::freedom_without_coefficients(
          data.radiation_file, kModes[static_cast<size_t>(mode % 6)], mode / 6 + 1));
  return f;
}

Eigen::MatrixXd matrix_of(const CapytaineFile::View& view, const Freedoms& f, int n, double scale,
                          std::initializer_list<size_t> before) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
  for (size_t j = 0; j < f.radiating.size(); ++j)
    for (size_t i = 0; i < f.influenced.size(); ++i) {
      if (f.radiating[j] < 0 || f.influenced[i] < 0) continue;
      m(f.influenced[i], f.radiating[j]) =
          scale * (before.size() ? view({*before.begin(), j, i}) : view({j, i}));
    }
  return m;
}

void read_radiation(const CapytaineFile& file, const Freedoms& f, double scale, HydrodynamicData& data,
                    bool& has_infinite, std::vector<std::string>& notes) {
  const std::string& along = file.frequencies();
  const CapytaineFile::View added(file, "added_mass", {along, "radiating_dof", "influenced_dof"});
  const CapytaineFile::View damping(file, "radiation_damping", {along, "radiating_dof", "influenced_dof"});
  const std::vector<double>& omega = file.numbers("omega");
  const int n = 6 * data.bodies;
  data.infinite = Eigen::MatrixXd::Zero(n, n);
  std::vector<size_t> order;
  for (size_t k = 0; k < omega.size(); ++k) {
    if (std::isinf(omega[k])) {
      data.infinite = matrix_of(added, f, n, scale, {k});
      has_infinite = data.infinite.allFinite();
    } else if (omega[k] > 0) {
      order.push_back(k);
    }
  }
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return omega[a] < omega[b]; });
  std::vector<double> excluded;  // entries are NaN where the panel method failed
  for (const size_t k : order) {
    if (!data.omega.empty() && omega[k] == data.omega.back())
      file.refuse(fmt::format("has omega = {:g} rad/s twice", omega[k]));
    Eigen::MatrixXd A = matrix_of(added, f, n, scale, {k});
    Eigen::MatrixXd B = matrix_of(damping, f, n, scale, {k});
    if (!A.allFinite() || !B.allFinite()) {
      excluded.push_back(omega[k]);
      continue;
    }
    data.omega.push_back(omega[k]);
    data.added_mass.push_back(std::move(A));
    data.damping.push_back(std::move(B));
  }
  if (!excluded.empty())
    notes.push_back(advice::frequencies_excluded(data.radiation_file, "added mass and damping", excluded));
  if (data.omega.size() < 2)
    file.refuse("has fewer than two finite frequencies above 0, and memory needs a range of them");
}

// The stiffness, and the moments m g (x, y, z) of the weight that it includes, from the inertia about the
// same point: M15 = m z, M26 = m x, M16 = -m y.
void read_hydrostatics(const CapytaineFile& file, const Freedoms& f, double scale, double gravity,
                       HydrodynamicData& data) {
  if (!file.has("hydrostatic_stiffness"))
    file.refuse(
        "has no variable 'hydrostatic_stiffness': make the dataset with the body's centre of mass and "
        "'hydrostatics=True'");
  const int n = 6 * data.bodies;
  const CapytaineFile::View stiffness(file, "hydrostatic_stiffness", {"radiating_dof", "influenced_dof"});
  data.hydrostatic = matrix_of(stiffness, f, n, scale, {});
  if (!data.hydrostatic.allFinite()) file.refuse("'hydrostatic_stiffness' has entries that are no numbers");
  data.weight.resize(static_cast<size_t>(data.bodies));
  data.origin.resize(static_cast<size_t>(data.bodies));
  if (data.bodies == 1 && file.has("rotation_center") && file.numbers("rotation_center").size() == 3)
    data.origin[0] = Eigen::Map<const Vec3>(file.numbers("rotation_center").data());
  if (!file.has("inertia_matrix")) return;
  const CapytaineFile::View inertia(file, "inertia_matrix", {"radiating_dof", "influenced_dof"});
  const Eigen::MatrixXd M = matrix_of(inertia, f, n, gravity * scale, {});
  for (int b = 0; b < data.bodies; ++b) {
    const Vec3 moment(M(6 * b + 1, 6 * b + 5), -M(6 * b, 6 * b + 5), M(6 * b, 6 * b + 4));
    if (moment.allFinite()) data.weight[static_cast<size_t>(b)] = moment;
  }
}

void read_excitation(const CapytaineFile& file, const Freedoms& f, double scale, const HydrodynamicForm& form,
                     HydrodynamicData& data, std::vector<std::string>& notes) {
  const bool parts = file.has("Froude_Krylov_force") && file.has("diffraction_force");
  if (!parts && !file.has("excitation_force")) return;
  const std::vector<std::string>& names = file.at("complex").texts;
  const auto part = [&](const char* name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) file.refuse(fmt::format("variable 'complex' has no '{}'", name));
    return static_cast<size_t>(found - names.begin());
  };
  const size_t re = part("re");
  const size_t im = part("im");
  const std::vector<double>& omega = file.numbers("omega");
  const std::vector<double>& directions = file.numbers("wave_direction");
  const std::vector<std::string> along = {"complex", file.frequencies(), "wave_direction", "influenced_dof"};
  std::vector<CapytaineFile::View> views;
  if (parts) {
    views.emplace_back(file, "Froude_Krylov_force", along);
    views.emplace_back(file, "diffraction_force", along);
  } else {
    views.emplace_back(file, "excitation_force", along);
  }
  WaveForceRows rows(data.bodies, form.mirrored);
  const auto force = [&](size_t k, size_t d, size_t i) {
    Complex value = 0;
    for (const CapytaineFile::View& v : views) value += Complex(v({re, k, d, i}), -v({im, k, d, i}));
    return scale * value;
  };
  std::vector<double> excluded;
  for (size_t k = 0; k < omega.size(); ++k) {
    if (!(omega[k] > 0) || std::isinf(omega[k])) continue;
    Complex sum = 0;
    for (size_t d = 0; d < directions.size(); ++d)
      for (size_t i = 0; i < f.influenced.size(); ++i) sum += force(k, d, i);
    if (!std::isfinite(sum.real()) || !std::isfinite(sum.imag())) {
      excluded.push_back(omega[k]);
      continue;
    }
    for (size_t d = 0; d < directions.size(); ++d)
      for (size_t i = 0; i < f.influenced.size(); ++i)
        if (f.influenced[i] >= 0)
          rows.add(omega[k], directions[d] * 180 / M_PI, f.influenced[i], force(k, d, i));
  }
  std::sort(excluded.begin(), excluded.end());
  if (!excluded.empty())
    notes.push_back(advice::frequencies_excluded(data.excitation_file, "wave forces", excluded));
  if (!rows.none()) data.excitation = rows.tables(data.excitation_file);
}

}  // namespace

HydrodynamicData read_capytaine(const std::string& path, const HydrodynamicForm& form, SecondOrder order,
                                std::vector<std::string>& read, std::vector<std::string>& notes) {
  if (const std::string why = unreadable(path, "dataset", kMostTable); !why.empty())
    throw std::runtime_error(path + ": " + why);
  const CapytaineFile file(path);
  read.push_back(path);
  HydrodynamicData data;
  data.radiation_file = data.excitation_file = path;
  if (file.has("forward_speed") && file.number("forward_speed") != 0)
    file.refuse("was computed with a forward speed; only coefficients at zero speed are supported");
  if (order != SecondOrder::none)
    file.refuse("has no second-order forces: remove 'second_order', or give WAMIT's or BEMIO's files");
  const double density = file.number("rho");
  const double gravity = file.number("g");
  if (!(density > 0) || !(gravity > 0)) file.refuse("density and gravity are not above 0");
  const double scale = form.density / density;
  if (std::abs(gravity / form.gravity - 1) > 0.01)
    notes.push_back(advice::other_gravity(path, gravity, form.gravity));
  const Freedoms f = freedoms(file, data, notes);
  bool has_infinite = false;
  read_radiation(file, f, scale, data, has_infinite, notes);
  if (file.has("water_depth")) note_depth(form, file.number("water_depth"), data, notes);
  read_hydrostatics(file, f, scale, gravity, data);
  check_mirrored(form, data);
  read_excitation(file, f, scale, form, data, notes);
  finish_coefficients(data, has_infinite, {}, notes);
  return data;
}

}  // namespace hawser::io
