// Files of Capytaine (NetCDF 4 and classic) and BEMIO (HDF5), written here from a WAMIT set by their
// documented conventions: the coefficients equal those of the WAMIT reader.
#include "hawser/io/hydrodynamic_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/io/hdf5.hpp"
#include "support/wamit_set.hpp"

namespace hawser::hydrodynamic_files_test {
namespace {

template <class Map>
auto entry(const Map& of, const typename Map::key_type& at) {
  const auto found = of.find(at);
  return found == of.end() ? typename Map::mapped_type{} : found->second;
}

struct Variable {
  std::string name;
  std::vector<std::string> dimensions;
  std::vector<double> values;
  std::vector<std::string> texts = {};
};
using Dimensions = std::vector<std::pair<std::string, size_t>>;

size_t length_of(const Dimensions& all, const std::string& name) {
  for (const auto& [n, length] : all)
    if (n == name) return length;
  throw std::logic_error(name);
}

// Each dimension is a dataset; DIMENSION_LIST of a variable refers to them.
void write_netcdf4(const std::string& path, const Dimensions& dimensions,
                   const std::vector<Variable>& variables) {
  const io::h5::Id file = io::h5::create(path);
  const auto write = [&](const Variable& v, const io::h5::Shape& shape) {
    const io::h5::Id text = io::h5::own(H5Tcopy(H5T_C_S1), H5Tclose, "type");
    H5Tset_size(text, H5T_VARIABLE);
    const hid_t type = v.texts.empty() ? H5T_IEEE_F64LE : static_cast<hid_t>(text);
    const io::h5::Id space =
        io::h5::own(shape.empty() ? H5Screate(H5S_SCALAR)
                                  : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                    H5Sclose, "space");
    const io::h5::Id set =
        io::h5::own(H5Dcreate2(file, v.name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                    H5Dclose, v.name);
    std::vector<const char*> pointers;
    for (const std::string& t : v.texts) pointers.push_back(t.c_str());
    const void* data = v.texts.empty() ? static_cast<const void*>(v.values.data()) : pointers.data();
    io::h5::check(
        H5Dwrite(set, v.texts.empty() ? H5T_NATIVE_DOUBLE : type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data),
        v.name);
  };
  for (const auto& [name, length] : dimensions)
    if (std::none_of(variables.begin(), variables.end(),
                     [&n = name](const Variable& v) { return v.name == n; }))
      write({name, {}, std::vector<double>(length, 0)}, {length});
  for (const Variable& v : variables) {
    io::h5::Shape shape;
    for (const std::string& d : v.dimensions) shape.push_back(length_of(dimensions, d));
    write(v, shape);
  }
  for (const Variable& v : variables) {
    if (v.dimensions.empty() || v.dimensions.front() == v.name) continue;
    const io::h5::Id set = io::h5::open_dataset(file, v.name);
    const io::h5::Id type = io::h5::own(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose, "type");
    const hsize_t rank = v.dimensions.size();
    const io::h5::Id space = io::h5::own(H5Screate_simple(1, &rank, nullptr), H5Sclose, "space");
    const io::h5::Id list = io::h5::own(
        H5Acreate2(set, "DIMENSION_LIST", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "attribute");
    std::vector<hobj_ref_t> references(rank);
    std::vector<hvl_t> entries(rank);
    for (size_t d = 0; d < rank; ++d) {
      H5Rcreate(&references[d], file, v.dimensions[d].c_str(), H5R_OBJECT, -1);
      entries[d] = {1, &references[d]};
    }
    io::h5::check(H5Awrite(list, type, entries.data()), "attribute");
  }
}

// NetCDF classic of version 1, 2 or 5, with an attribute of the file and of each variable.
void write_classic(const std::string& path, const Dimensions& dimensions, std::vector<Variable> variables,
                   int version) {
  Dimensions all = dimensions;
  size_t longest = 0;
  for (const Variable& v : variables)
    for (const std::string& t : v.texts) longest = std::max(longest, t.size());
  all.emplace_back("letters", longest);
  std::string body;
  const auto bits = [](std::string& to, std::uint64_t x, int bytes) {
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) to += static_cast<char>(x >> shift & 0xff);
  };
  const int count = version == 5 ? 8 : 4;
  const int place = version == 1 ? 4 : 8;
  const auto name = [&](std::string& to, const std::string& text) {
    bits(to, text.size(), count);
    to += text + std::string((4 - text.size() % 4) % 4, '\0');
  };
  const auto attributes = [&](std::string& to) {
    bits(to, 0x0c, 4);
    bits(to, 1, count);
    name(to, "long_name");
    bits(to, 2, 4);
    name(to, "words");
  };
  const auto header = [&](std::uint64_t start) {
    std::string to = "CDF" + std::string(1, static_cast<char>(version));
    bits(to, 0, count);
    bits(to, 0x0a, 4);
    bits(to, all.size(), count);
    for (const auto& [n, length] : all) {
      name(to, n);
      bits(to, length, count);
    }
    attributes(to);
    bits(to, 0x0b, 4);
    bits(to, variables.size(), count);
    body.clear();
    for (const Variable& v : variables) {
      name(to, v.name);
      std::vector<std::string> along = v.dimensions;
      if (!v.texts.empty()) along.push_back("letters");
      bits(to, along.size(), count);
      for (const std::string& d : along) {
        const auto at = std::find_if(all.begin(), all.end(), [&](const auto& x) { return x.first == d; });
        bits(to, static_cast<std::uint64_t>(at - all.begin()), count);
      }
      attributes(to);
      bits(to, v.texts.empty() ? 6 : 2, 4);
      std::string data;
      for (const std::string& t : v.texts) data += t + std::string(longest - t.size(), '\0');
      for (const double x : v.values) bits(data, std::bit_cast<std::uint64_t>(x), 8);
      data += std::string((4 - data.size() % 4) % 4, '\0');
      bits(to, data.size(), count);
      bits(to, start + body.size(), place);
      body += data;
    }
    return to;
  };
  const std::string head = header(header(0).size());
  std::ofstream(path, std::ios::binary) << head << body;
}

// A Capytaine dataset of that set, with a fluid of 1000 kg/m³, decreasing frequencies, and an order of
// freedoms different from WAMIT's.
std::pair<Dimensions, std::vector<Variable>> capytaine_set(const Set& s) {
  const double rho = 1000;
  const std::vector<std::string> names = {"Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"};
  const std::vector<int> order = {2, 0, 1, 5, 4, 3};
  std::vector<std::string> freedoms;
  for (const int i : order) freedoms.push_back(names[static_cast<size_t>(i)]);
  const int n = static_cast<int>(s.omega.size());
  std::vector<double> omega = {HUGE_VAL}, directions;
  for (int k = n - 1; k >= 0; --k) omega.push_back(s.omega[static_cast<size_t>(k)]);
  for (const double d : s.directions) directions.push_back(d * M_PI / 180);
  std::vector<double> added, damping, stiffness, inertia;
  std::array<std::vector<double>, 2> diffraction, froude_krylov;
  for (int k = n; k >= 0; --k)
    for (const int j : order)
      for (const int i : order) {
        const bool infinite = k == n;
        added.push_back(rho * (infinite ? entry(s.limit, {i, j}) : entry(s.added, {k, i, j})));
        damping.push_back(infinite ? 0 : rho * s.omega[static_cast<size_t>(k)] * entry(s.damping, {k, i, j}));
      }
  for (int k = n; k >= 0; --k)
    for (int d = 0; d < static_cast<int>(directions.size()); ++d)
      for (const int i : order) {
        const Complex force = k == n ? 0 : rho * kGravity * std::conj(entry(s.force, {k, d, i}));
        for (int part = 0; part < 2; ++part) {
          const double x = part == 0 ? force.real() : force.imag();
          diffraction[static_cast<size_t>(part)].push_back(0.25 * x);
          froude_krylov[static_cast<size_t>(part)].push_back(0.75 * x);
        }
      }
  // The stiffness includes the weight of a mass of 5000 t with its centre at (1, -2, -3).
  const double mass = 5e6;
  const Vec3 centre(1, -2, -3);
  for (const int j : order)
    for (const int i : order) {
      double C = rho * kGravity * entry(s.stiffness, {i, j});
      if (i == j && (i == 3 || i == 4)) C -= mass * kGravity * centre.z();
      if (i == 3 && j == 5) C += mass * kGravity * centre.x();
      if (i == 4 && j == 5) C += mass * kGravity * centre.y();
      stiffness.push_back(C);
    }
  Mat6 M = Mat6::Zero();
  M.diagonal() << mass, mass, mass, 1e9, 1e9, 1e9;
  M(0, 4) = mass * centre.z();
  M(1, 3) = -mass * centre.z();
  M(0, 5) = -mass * centre.y();
  M(1, 5) = mass * centre.x();
  M(2, 3) = mass * centre.y();
  M(2, 4) = -mass * centre.x();
  for (const int j : order)
    for (const int i : order) inertia.push_back(i <= j ? M(i, j) : M(j, i));
  const auto both = [](std::array<std::vector<double>, 2> parts) {
    parts[0].insert(parts[0].end(), parts[1].begin(), parts[1].end());
    return parts[0];
  };
  return {
      {{"omega", omega.size()},
       {"wave_direction", directions.size()},
       {"radiating_dof", 6},
       {"influenced_dof", 6},
       {"complex", 2},
       {"space_coordinate", 3}},
      {{"omega", {"omega"}, omega},
       {"wave_direction", {"wave_direction"}, directions},
       {"radiating_dof", {"radiating_dof"}, {}, freedoms},
       {"influenced_dof", {"influenced_dof"}, {}, freedoms},
       {"complex", {"complex"}, {}, {"re", "im"}},
       {"added_mass", {"omega", "radiating_dof", "influenced_dof"}, added},
       {"radiation_damping", {"omega", "radiating_dof", "influenced_dof"}, damping},
       {"diffraction_force", {"complex", "omega", "wave_direction", "influenced_dof"}, both(diffraction)},
       {"Froude_Krylov_force", {"complex", "omega", "wave_direction", "influenced_dof"}, both(froude_krylov)},
       {"hydrostatic_stiffness", {"radiating_dof", "influenced_dof"}, stiffness},
       {"inertia_matrix", {"radiating_dof", "influenced_dof"}, inertia},
       {"rotation_center", {"space_coordinate"}, {0.5, 0, -1}},
       {"rho", {}, {rho}},
       {"g", {}, {kGravity}},
       {"forward_speed", {}, {0}}}};
}

// Writes the set as BEMIO does: divided by rho, rho omega and rho g, or in SI units if `scaled`.
void write_bemio(const std::string& path, const Set& s, bool scaled) {
  const io::h5::Id file = io::h5::create(path);
  for (const char* group : {"/simulation_parameters", "/body1", "/body1/properties", "/body1/hydro_coeffs",
                            "/body1/hydro_coeffs/added_mass", "/body1/hydro_coeffs/radiation_damping",
                            "/body1/hydro_coeffs/excitation", "/body1/hydro_coeffs/mean_drift",
                            "/body1/hydro_coeffs/mean_drift/control_surface"})
    io::h5::group(file, group);
  const auto write = [&](const std::string& name, const io::h5::Shape& shape,
                         const std::vector<double>& values) {
    const io::h5::Id set = io::h5::reserve(file, name, H5T_IEEE_F64LE, shape);
    io::h5::check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  };
  const double rho = 1000;
  const double mass = scaled ? rho : 1;
  const double force = scaled ? rho * kGravity : 1;
  const size_t n = s.omega.size();
  const size_t headings = s.directions.size();
  std::vector<double> added, damping, infinite, re, im, drift, stiffness;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      infinite.push_back(mass * entry(s.limit, {i, j}));
      stiffness.push_back(force * entry(s.stiffness, {i, j}));
      for (int k = 0; k < static_cast<int>(n); ++k) {
        added.push_back(mass * entry(s.added, {k, i, j}));
        damping.push_back((scaled ? rho * s.omega[static_cast<size_t>(k)] : 1) * entry(s.damping, {k, i, j}));
      }
    }
    for (int d = 0; d < static_cast<int>(headings); ++d)
      for (int k = 0; k < static_cast<int>(n); ++k) {
        re.push_back(force * entry(s.force, {k, d, i}).real());
        im.push_back(force * entry(s.force, {k, d, i}).imag());
        drift.push_back(force * (i + 0.5));
      }
  }
  write("/simulation_parameters/scaled", {1, 1}, {scaled ? 1.0 : 0.0});
  write("/simulation_parameters/rho", {1, 1}, {rho});
  write("/simulation_parameters/g", {1, 1}, {kGravity});
  write("/simulation_parameters/w", {n, 1}, s.omega);
  write("/simulation_parameters/wave_dir", {headings, 1}, s.directions);
  write("/body1/properties/cg", {3, 1}, {0.5, 0, -1});
  const std::string coefficients = "/body1/hydro_coeffs/";
  write(coefficients + "added_mass/all", {6, 6, n}, added);
  write(coefficients + "added_mass/inf_freq", {6, 6}, infinite);
  write(coefficients + "radiation_damping/all", {6, 6, n}, damping);
  write(coefficients + "linear_restoring_stiffness", {6, 6}, stiffness);
  write(coefficients + "excitation/re", {6, headings, n}, re);
  write(coefficients + "excitation/im", {6, headings, n}, im);
  write(coefficients + "mean_drift/control_surface/val", {6, headings, n}, drift);
}

class HydrodynamicFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / "hawser_hydrodynamic_files" / test->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  std::string path(const char* name) const { return (folder_ / name).string(); }
  model::HydrodynamicData wamit() {
    return io::read_wamit(kSpar, {1, kDensity, kGravity, false}, SecondOrder::none, files, notes);
  }
  model::HydrodynamicData capytaine(SecondOrder order = SecondOrder::none) {
    return io::read_capytaine(path("float.nc"), {1, kDensity, kGravity, false}, order, files, notes);
  }
  model::HydrodynamicData bemio(SecondOrder order = SecondOrder::none) {
    return io::read_bemio(path("float.h5"), {1, kDensity, kGravity, false}, order, files, notes);
  }
  static std::string refusal(const std::function<void()>& what) {
    try {
      what();
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "";
  }
  static void expect_same(const model::HydrodynamicData& a, const model::HydrodynamicData& b) {
    ASSERT_EQ(a.bodies, b.bodies);
    ASSERT_EQ(a.omega.size(), b.omega.size());
    const auto near = [](const auto& x, const auto& y) { return (x - y).norm() <= 1e-12 * y.norm(); };
    for (size_t k = 0; k < a.omega.size(); ++k) {
      EXPECT_NEAR(a.omega[k], b.omega[k], 1e-14);
      EXPECT_TRUE(near(a.added_mass[k], b.added_mass[k])) << k;
      EXPECT_TRUE(near(a.damping[k], b.damping[k])) << k;
    }
    EXPECT_TRUE(near(a.infinite, b.infinite));
    EXPECT_FALSE(a.infinite_estimated);
    ASSERT_EQ(a.excitation.size(), 1u);
    for (const double w : {0.07, 0.3, 0.9, 2.1})
      for (const double direction : {0.0, 0.7, 3.0, 5.5})
        EXPECT_TRUE(near(a.excitation[0].at(w, direction), b.excitation[0].at(w, direction))) << w;
  }
  std::vector<std::string> files, notes;

 private:
  std::filesystem::path folder_;
};

TEST_F(HydrodynamicFiles, CapytaineHasTheCoefficientsOfWamit) {
  const model::HydrodynamicData reference = wamit();
  const auto [dimensions, variables] = capytaine_set(wamit_set());
  for (const int version : {4, 1, 2, 5}) {
    if (version == 4)
      write_netcdf4(path("float.nc"), dimensions, variables);
    else
      write_classic(path("float.nc"), dimensions, variables, version);
    const model::HydrodynamicData data = capytaine();
    expect_same(data, reference);
    ASSERT_TRUE(data.origin[0] && data.weight[0]);
    EXPECT_LT((*data.origin[0] - Vec3(0.5, 0, -1)).norm(), 1e-14);
    const double density = kDensity / 1000;
    const double weight = density * 5e6 * kGravity;
    EXPECT_LT((*data.weight[0] - weight * Vec3(1, -2, -3)).norm(), 1e-12 * weight);
    Eigen::MatrixXd pressure = data.hydrostatic;
    pressure(3, 3) += data.weight[0]->z();
    pressure(4, 4) += data.weight[0]->z();
    pressure(3, 5) -= data.weight[0]->x();
    pressure(4, 5) -= data.weight[0]->y();
    EXPECT_LT((pressure - reference.hydrostatic).norm(), 1e-12 * reference.hydrostatic.norm()) << version;
  }
}

// A frequency with NaN, at which the panel method failed, is ignored.
TEST_F(HydrodynamicFiles, ExcludesWhatIsNoNumber) {
  auto [dimensions, variables] = capytaine_set(wamit_set());
  variables[5].values[5 * 36 + 4] = NAN;
  variables[7].values.back() = NAN;
  write_netcdf4(path("float.nc"), dimensions, variables);
  const model::HydrodynamicData data = capytaine();
  const model::HydrodynamicData all = wamit();
  EXPECT_EQ(data.omega.size(), all.omega.size() - 1);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_NE(notes[0].find("the added mass and damping of 1 frequency"), std::string::npos) << notes[0];
  EXPECT_NE(notes[1].find("the wave forces of 1 frequency"), std::string::npos) << notes[1];
  EXPECT_TRUE(data.excitation[0].at(0.5, 1).allFinite());
}

TEST_F(HydrodynamicFiles, BemioHasTheCoefficientsOfWamit) {
  const model::HydrodynamicData reference = wamit();
  for (const bool scaled : {false, true}) {
    write_bemio(path("float.h5"), wamit_set(), scaled);
    const model::HydrodynamicData data = bemio(SecondOrder::mean);
    expect_same(data, reference);
    EXPECT_LT((data.hydrostatic - reference.hydrostatic).norm(), 1e-12 * reference.hydrostatic.norm());
    EXPECT_LT((*data.origin[0] - Vec3(0.5, 0, -1)).norm(), 1e-14);
    EXPECT_NEAR(data.drift[0].at(0.5, 1)[4].real(), 4.5 * kDensity * kGravity, 1e-6);
  }
}

// The depth is a number or the word 'infinite'.
TEST_F(HydrodynamicFiles, BemioHasTheDepthOfItsWater) {
  const auto reported = [&](double depth, const char* word = nullptr) {
    write_bemio(path("float.h5"), wamit_set(), false);
    {
      const io::h5::Id file(H5Fopen(path("float.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
      const std::string name = "/simulation_parameters/water_depth";
      if (word) {
        io::h5::write_text(file, name, word);
      } else {
        const io::h5::Id set = io::h5::reserve(file, name, H5T_IEEE_F64LE, {1, 1});
        io::h5::check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &depth), name);
      }
    }
    notes.clear();
    io::read_bemio(path("float.h5"), {1, kDensity, kGravity, false, 20}, SecondOrder::none, files, notes);
    return std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("is made for water") != std::string::npos;
    });
  };
  EXPECT_FALSE(reported(20));
  EXPECT_TRUE(reported(5));
  EXPECT_TRUE(reported(0, "infinite"));
}

// The reference point and the weight in the stiffness come from the file; the centre of mass of the case is
// compared with it.
TEST_F(HydrodynamicFiles, GiveOriginAndWeightToTheBody) {
  const auto [dimensions, variables] = capytaine_set(wamit_set());
  write_netcdf4(path("float.nc"), dimensions, variables);
  write_bemio(path("float.h5"), wamit_set(), false);
  const auto body = [&](const std::string& centre, const std::string& keys) {
    const std::string text =
        "hawser: 1\nenvironment: {gravity: 9.80665, water: {density: 1025}}\n"
        "bodies:\n  float: {position: [0, 0, -1], floating: {mass: 5.125e6, inertia: [1e9, 1e9, 1e9], "
        "turning_stiffness: [2e10, 2e10, 0], centre_of_mass: " +
        centre + ", hydrodynamics: {excitation: false, " + keys +
        "}}}\nstatics: false\ndynamics: {duration: 20}\n";
    model::Case c = io::read_case_text(text, "float.yaml", {}, MPI_COMM_SELF);
    notes = c.notes;
    return *c.bodies[0].mass->hydrodynamics;
  };
  const std::string netcdf = "capytaine: " + path("float.nc");
  model::BodyHydrodynamics h = body("[1, -2, -3]", netcdf);
  EXPECT_TRUE(h.gravity_in_stiffness);
  EXPECT_LT((h.in_file - Vec3(0.5, 0, -1)).norm(), 1e-14);
  EXPECT_EQ(notes.size(), 0u) << testing::PrintToString(notes);
  h = body("[0, 0, 0]", netcdf + ", origin_in_file: [0, 0, 0]");
  EXPECT_LT(h.in_file.norm(), 1e-14);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("has the weight at (1, -2, -3) m"), std::string::npos) << notes[0];
  EXPECT_FALSE(body("[0, 0, 0]", netcdf + ", gravity_in_stiffness: false").gravity_in_stiffness);
  h = body("[0, 0, 0]", "bemio: " + path("float.h5"));
  EXPECT_FALSE(h.gravity_in_stiffness);
  EXPECT_LT((h.in_file - Vec3(0.5, 0, -1)).norm(), 1e-14);
}

TEST_F(HydrodynamicFiles, RefusesWithFileAndVariable) {
  const auto [dimensions, variables] = capytaine_set(wamit_set());
  const auto with = [&](const std::string& name, const std::function<void(Variable&)>& change) {
    std::vector<Variable> changed = variables;
    for (Variable& v : changed)
      if (v.name == name) change(v);
    write_netcdf4(path("float.nc"), dimensions, changed);
    return refusal([&] { capytaine(); });
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_NE(text.find("float."), std::string::npos) << text;
  };
  has(with("forward_speed", [](Variable& v) { v.values = {2}; }), "was computed with a forward speed");
  has(with("added_mass", [](Variable& v) { v.name = "other"; }), "has no variable 'added_mass'");
  has(with("omega", [](Variable& v) { v.values[3] = v.values[2]; }), "twice");
  has(with("complex", [](Variable& v) { v.texts = {"a", "b"}; }), "variable 'complex' has no 're'");
  has(with("hydrostatic_stiffness", [](Variable& v) { v.name = "other"; }), "centre of mass");
  has(with("added_mass", [](Variable& v) { v.dimensions[1] = "influenced_dof"; }), "is not along");
  write_netcdf4(path("float.nc"), dimensions, variables);
  has(refusal([&] { capytaine(SecondOrder::newman); }), "has no second-order forces");
  std::ofstream(path("float.nc")) << "text";
  has(refusal([&] { capytaine(); }), "is no NetCDF file");
  write_classic(path("float.nc"), dimensions, variables, 2);
  std::filesystem::resize_file(path("float.nc"), 5000);
  has(refusal([&] { capytaine(); }), "is cut short");
  std::filesystem::remove(path("float.nc"));
  has(refusal([&] { capytaine(); }), "there is no such dataset file");
  std::ofstream(path("float.h5")) << "text";
  has(refusal([&] { bemio(); }), "is no HDF5 file");
  write_bemio(path("float.h5"), wamit_set(), false);
  has(refusal([&] { bemio(SecondOrder::full); }), "'second_order: full'");
  write_netcdf4(path("float.h5"), dimensions, variables);
  has(refusal([&] { bemio(); }), "has no group 'body1'");
}

}  // namespace
}  // namespace hawser::hydrodynamic_files_test
