// Reader of BEMIO's HDF5 (WEC-Sim user manual, "BEMIO"): one group per body; values over rho, rho omega and
// rho g if simulation_parameters/scaled is 0; matrices by degree of freedom, then frequency; phases are
// leads, as WAMIT's; moments are about the centre of gravity.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "hawser/io/hdf5.hpp"
#include "hawser/io/input_file.hpp"
#include "hydrodynamic_parts.hpp"

namespace hawser::io {
namespace {

using model::HydrodynamicData;

class BemioFile {
 public:
  explicit BemioFile(const std::string& path) : path_(path), file_(h5::open_read(path)) {
    while (h5::exists(file_, fmt::format("/body{}", bodies_ + 1))) ++bodies_;
    if (bodies_ == 0) refuse("has no group 'body1', which BEMIO's files have");
    omega_ = array("/simulation_parameters/w").values;
    order_.resize(omega_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](size_t a, size_t b) { return omega_[a] < omega_[b]; });
  }
  [[noreturn]] void refuse(const std::string& text) const { throw std::runtime_error(path_ + ": " + text); }
  int bodies() const { return bodies_; }
  const std::vector<double>& omega() const { return omega_; }
  const std::vector<size_t>& by_omega() const { return order_; }
  bool has(const std::string& name) const { return h5::exists(file_, name); }
  h5::Array array(const std::string& name) const {
    if (!has(name)) refuse(fmt::format("has no dataset '{}', which BEMIO's files have", name));
    return h5::read_array(file_, name);
  }
  double number(const std::string& name) const {
    const h5::Array a = array(name);
    if (a.values.empty()) refuse(fmt::format("dataset '{}' is empty", name));
    return a.values.front();
  }
  // m, or the word 'infinite', which is no number.
  double depth() const {
    try {
      return number("/simulation_parameters/water_depth");
    } catch (const std::runtime_error&) {
      return HUGE_VAL;
    }
  }
  std::vector<double> values(const std::string& name, const h5::Shape& shape) const {
    h5::Array a = array(name);
    h5::Shape without_ones;
    for (const hsize_t k : a.shape)
      if (k != 1) without_ones.push_back(k);
    h5::Shape required;
    for (const hsize_t k : shape)
      if (k != 1) required.push_back(k);
    if (without_ones != required)
      refuse(fmt::format("dataset '{}' is {}, and belongs to {} here", name, fmt::join(a.shape, " x "),
                         fmt::join(shape, " x ")));
    for (const double x : a.values)
      if (std::isinf(x)) refuse(fmt::format("dataset '{}' has entries that are not finite", name));
    return std::move(a.values);
  }

 private:
  std::string path_;
  h5::Id file_;
  int bodies_ = 0;
  std::vector<double> omega_;
  std::vector<size_t> order_;
};

// Factors rho, rho omega and rho g of values that the file has in scaled form.
struct Scales {
  double density = 1, damping_by_omega = 0, damping = 0, force = 1;
};

Scales scales(const BemioFile& file, const HydrodynamicForm& form) {
  const double density = file.number("/simulation_parameters/rho");
  const double gravity = file.number("/simulation_parameters/g");
  if (!(density > 0) || !(gravity > 0)) file.refuse("density and gravity are not above 0");
  if (file.has("/simulation_parameters/scaled") && file.number("/simulation_parameters/scaled") != 0) {
    const double factor = form.density / density;
    return {factor, 0, factor, factor};
  }
  return {form.density, form.density, 0, form.density * form.gravity};
}

void read_radiation(const BemioFile& file, const Scales& scale, HydrodynamicData& data, bool& has_infinite) {
  const int n = 6 * data.bodies;
  const std::vector<double>& omega = file.omega();
  const size_t count = omega.size();
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  data.infinite = none;
  for (const size_t k : file.by_omega()) {
    if (!(omega[k] > 0)) file.refuse(fmt::format("omega = {:g} rad/s is not above 0", omega[k]));
    data.omega.push_back(omega[k]);
  }
  if (count < 2) file.refuse("has fewer than two frequencies, and memory needs a range of them");
  data.added_mass.assign(count, none);
  data.damping.assign(count, none);
  has_infinite = true;
  for (int b = 0; b < data.bodies; ++b) {
    const std::string body = fmt::format("/body{}/hydro_coeffs/", b + 1);
    const auto columns = static_cast<hsize_t>(n);
    const std::vector<double> added = file.values(body + "added_mass/all", {6, columns, count});
    const std::vector<double> damping = file.values(body + "radiation_damping/all", {6, columns, count});
    std::vector<double> infinite;
    if (file.has(body + "added_mass/inf_freq"))
      infinite = file.values(body + "added_mass/inf_freq", {6, columns});
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < n; ++j) {
        const auto entry = static_cast<size_t>(i * n + j);
        for (size_t k = 0; k < count; ++k) {
          const size_t at = entry * count + file.by_omega()[k];
          data.added_mass[k](6 * b + i, j) = scale.density * added[at];
          data.damping[k](6 * b + i, j) =
              (scale.damping + scale.damping_by_omega * data.omega[k]) * damping[at];
        }
        if (!infinite.empty()) data.infinite(6 * b + i, j) = scale.density * infinite[entry];
      }
    has_infinite = has_infinite && !infinite.empty();
  }
  has_infinite = has_infinite && data.infinite.allFinite();
  for (size_t k = 0; k < count; ++k)
    if (!data.added_mass[k].allFinite() || !data.damping[k].allFinite())
      file.refuse(fmt::format("added mass or damping at omega = {:g} rad/s has entries that are no numbers",
                              data.omega[k]));
}

void read_hydrostatics(const BemioFile& file, const Scales& scale, HydrodynamicData& data) {
  const int n = 6 * data.bodies;
  data.hydrostatic = Eigen::MatrixXd::Zero(n, n);
  for (int b = 0; b < data.bodies; ++b) {
    const std::string body = fmt::format("/body{}/", b + 1);
    const std::vector<double> C = file.values(body + "hydro_coeffs/linear_restoring_stiffness", {6, 6});
    data.hydrostatic.block<6, 6>(6 * b, 6 * b) =
        scale.force * Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(C.data());
    const std::vector<double> cg = file.values(body + "properties/cg", {3});
    data.origin.emplace_back(Eigen::Map<const Vec3>(cg.data()));
  }
  if (!data.hydrostatic.allFinite())
    file.refuse("'linear_restoring_stiffness' has entries that are no numbers");
}

// Forces by direction from the datasets `re` and `im` of each body; im may be empty.
std::vector<WaveForceTable> force_tables(const BemioFile& file, const HydrodynamicForm& form, double scale,
                                         const std::string& re, const std::string& im, int bodies,
                                         const std::string& path) {
  const std::vector<double> directions = file.array("/simulation_parameters/wave_dir").values;
  const size_t count = file.omega().size();
  WaveForceRows rows(bodies, form.mirrored);
  for (int b = 0; b < bodies; ++b) {
    const std::string body = fmt::format("/body{}/hydro_coeffs/", b + 1);
    const h5::Shape shape = {6, directions.size(), count};
    const std::vector<double> real = file.values(body + re, shape);
    const std::vector<double> imaginary =
        im.empty() ? std::vector<double>(real.size(), 0) : file.values(body + im, shape);
    for (size_t i = 0; i < 6; ++i)
      for (size_t d = 0; d < directions.size(); ++d)
        for (size_t k = 0; k < count; ++k) {
          const size_t at = (i * directions.size() + d) * count + k;
          if (std::isnan(real[at]) || std::isnan(imaginary[at]))
            file.refuse(fmt::format("'{}' has entries that are no numbers", body + re));
          rows.add(file.omega()[k], directions[d], 6 * b + static_cast<int>(i),
                   scale * Complex(real[at], imaginary[at]));
        }
  }
  return rows.none() ? std::vector<WaveForceTable>{} : rows.tables(path);
}

}  // namespace

HydrodynamicData read_bemio(const std::string& path, const HydrodynamicForm& form, SecondOrder order,
                            std::vector<std::string>& read, std::vector<std::string>& notes) {
  if (const std::string why = unreadable(path, "BEMIO", kMostTable); !why.empty())
    throw std::runtime_error(path + ": " + why);
  std::optional<BemioFile> opened;
  try {
    opened.emplace(path);
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(std::string(e.what()).find(path) == 0
                                 ? e.what()
                                 : fmt::format("{}: is no HDF5 file, or is damaged ({})", path, e.what()));
  }
  const BemioFile& file = *opened;
  read.push_back(path);
  HydrodynamicData data;
  data.radiation_file = data.excitation_file = path;
  data.bodies = file.bodies();
  const Scales scale = scales(file, form);
  bool has_infinite = false;
  read_radiation(file, scale, data, has_infinite);
  if (file.has("/simulation_parameters/water_depth")) note_depth(form, file.depth(), data, notes);
  read_hydrostatics(file, scale, data);
  check_mirrored(form, data);
  if (file.has("/body1/hydro_coeffs/excitation/re"))
    data.excitation =
        force_tables(file, form, scale.force, "excitation/re", "excitation/im", data.bodies, path);
  if (order != SecondOrder::none) {
    std::string part;
    for (const char* name : {"momentum_conservation", "control_surface", "pressure_integration"})
      if (part.empty() && file.has(fmt::format("/body1/hydro_coeffs/mean_drift/{}/val", name)))
        part = fmt::format("mean_drift/{}/val", name);
    if (part.empty() || order == SecondOrder::full)
      file.refuse(order == SecondOrder::full
                      ? "difference-frequency forces of each pair of frequencies ('second_order: full') are "
                        "read from WAMIT's file .12d"
                      : "'second_order' needs 'mean_drift' of each body, and there is none");
    data.drift = force_tables(file, form, scale.force, part, "", data.bodies, path);
  }
  finish_coefficients(data, has_infinite, {}, notes);
  return data;
}

}  // namespace hawser::io
