// Airy waves: dispersion relation, stretching, and random components of a JONSWAP or tabulated spectrum with
// directional spreading.
#include "hawser/kernels/waves.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hawser/kernels/stokes_wave.hpp"
#include "hawser/math/random.hpp"

namespace hawser {

double wave_number(double omega, double depth, double gravity) {
  const double deep = omega * omega / gravity;
  if (!(depth > 0) || !(omega > 0)) return deep;
  // x tanh x = y by Newton, from Eckart's guess, which is within 5 %.
  const double y = deep * depth;
  double x = y / std::sqrt(std::tanh(y));
  for (int i = 0; i < 20; ++i) {
    const double t = std::tanh(x);
    const double step = (x * t - y) / (t + x * (1 - t * t));
    x -= step;
    if (std::abs(step) <= 1e-15 * x) break;
  }
  return x / depth;
}

WaveField::WaveField(std::vector<WaveComponent> components, double depth, double gravity,
                     Stretching stretching)
    : components_(std::move(components)), depth_(depth), stretching_(stretching) {
  for (WaveComponent& c : components_) c.number = wave_number(c.omega, depth, gravity);
  sums_ = WaveSums(components_, depth);
}

WaveField::WaveField(std::shared_ptr<const StokesWave> wave)
    : components_{wave->component()}, depth_(wave->depth()), stokes_(std::move(wave)) {}

// Number of components, longest waves first, that are summed at the height z. Near the bed the significant
// ones suffice: the motion depends on the elevation eta only through Wheeler's stretching, which moves the
// point by h (h + z)/(h + eta)² d eta, and the motion exp(kz) of a component changes by at most 1/(e |z|)
// times that. This bound must not exceed WaveSums::kNegligible for the excluded components. Elsewhere all
// components are summed, because a tall body below needs the elevation above it.
std::size_t WaveField::components_summed(double z) const {
  const double height = sums_.height_beyond(0);
  const double h = depth_;
  if (stretching_ != Stretching::wheeler || !(h > height) || !(z < -height)) return sums_.size();
  const double highest = h * (z + height) / (h - height);  // below the deepest trough
  const double moves = h * std::abs(h + z) / ((h - height) * (h - height));
  const std::size_t n = sums_.significant_components(highest);
  const double change = moves * sums_.height_beyond(n) / (M_E * -highest);
  return change <= WaveSums::kNegligible ? n : sums_.size();
}

WaveMotion WaveField::at(const Vec3& x, double t, double factor, double rate) const {
  if (stokes_) return stokes_->at(x, t, factor, rate);
  thread_local WaveSums::Phases phases;  // reused memory
  sums_.phases(x.x(), x.y(), t, components_summed(x.z()), phases);
  WaveMotion m;
  m.surface = factor * phases.surface;
  double z = x.z();
  if (z > m.surface) z = m.surface;  // points above the surface belong to partly wet elements
  if (stretching_ == Stretching::none && z > 0) return m;
  Vec3 u = Vec3::Zero(), a = Vec3::Zero();
  sums_.add_motion(phases, stretched(z, m.surface), u, a);
  m.velocity = factor * u;
  m.acceleration = factor * a + rate * u;
  return m;
}

// Height at which linear theory is evaluated for the height z. Wheeler, with the elevation eta and depth d:
//   z' = d (z - eta)/(d + eta),   z - eta in infinite depth.
double WaveField::stretched(double z, double surface) const {
  if (stretching_ != Stretching::wheeler) return std::min(z, 0.0);
  return depth_ > 0 ? depth_ * (z - surface) / (depth_ + surface) : z - surface;
}

double WaveField::head(const Vec3& x, double t, double factor) const {
  if (stokes_) return stokes_->head_at(x, t, factor);
  thread_local WaveSums::Phases phases;  // reused memory
  sums_.phases(x.x(), x.y(), t, components_summed(x.z()), phases);
  const double surface = factor * phases.surface;
  return factor * sums_.head(phases, stretched(std::min(x.z(), surface), surface));
}

namespace {

// JONSWAP spectrum (Hasselmann et al. 1973) without its constant, with r = peak/omega:
//   r^5/peak exp(-5/4 r^4) gamma^exp(-(omega - peak)²/(2 sigma² peak²))
double shape(double omega, double peak, double gamma) {
  const double r = peak / omega;
  const double sigma = omega <= peak ? 0.07 : 0.09;
  const double off = (omega - peak) / (sigma * peak);
  return std::pow(r, 5) / peak * std::exp(-1.25 * std::pow(r, 4)) *
         std::pow(gamma, std::exp(-0.5 * off * off));
}

// Integral of the shape up to omega_i, by Simpson's rule on a fine grid of log omega.
struct Grid {
  std::vector<double> omega, sum;
  Grid(double peak, double gamma, double from, double to, int cells) {
    const double step = std::log(to / from) / cells;
    omega.resize(cells + 1);
    sum.assign(cells + 1, 0);
    for (int i = 0; i <= cells; ++i) omega[i] = peak * from * std::exp(i * step);
    const auto f = [&](double w) { return w * shape(w, peak, gamma); };
    for (size_t i = 1; i < omega.size(); ++i) {
      const double a = omega[i - 1];
      const double b = omega[i];
      const double m = std::sqrt(a * b);
      sum[i] = sum[i - 1] + step / 6 * (f(a) + 4 * f(m) + f(b));
    }
  }
};

// Angle from the mean direction to the right of which a given fraction of the waves lies, for cos^2s of half
// the angle.
class Spreading {
 public:
  explicit Spreading(double s) : below_(kCells + 1, 0) {
    const double widest = std::min(M_PI, 9 / std::sqrt(s));  // beyond it there is less than 1e-9
    first_ = -widest;
    step_ = 2 * widest / kCells;
    const auto density = [&](int i) { return std::pow(std::cos((first_ + i * step_) / 2), 2 * s); };
    for (int i = 0; i < kCells; ++i) below_[i + 1] = below_[i] + density(i) + density(i + 1);
  }
  double angle(double fraction) const {
    const double sum = std::min(fraction, 1 - 1e-12) * below_.back();  // a fraction of 1 has no unique angle
    const auto above = std::upper_bound(below_.begin() + 1, below_.end() - 1, sum);
    const auto i = above - below_.begin() - 1;
    return first_ + step_ * (static_cast<double>(i) + (sum - below_[i]) / (below_[i + 1] - below_[i]));
  }

 private:
  static constexpr int kCells = 4096;
  std::vector<double> below_;
  double first_ = 0, step_ = 0;
};

// Most of the energy of a sea is in a few dozen components, too few for random directions: their mean would
// be off by several degrees. Instead the components are arranged in random order, each with a width equal to
// its energy, and have the direction of their middle.
void spread(std::vector<WaveComponent>& components, double mean, double spreading, Random& random) {
  std::vector<size_t> order(components.size());
  std::iota(order.begin(), order.end(), 0);
  for (size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<size_t>(random.next() * static_cast<double>(i))]);
  double all = 0, so_far = 0;
  for (const WaveComponent& c : components) all += c.amplitude * c.amplitude;
  const Spreading shape(spreading);
  for (const size_t i : order) {
    WaveComponent& c = components[i];
    const double energy = c.amplitude * c.amplitude;
    const double theta = mean + shape.angle((so_far + 0.5 * energy) / all);
    c.x = std::cos(theta);
    c.y = std::sin(theta);
    so_far += energy;
  }
}

// Component for a bin of a spectrum: its exact energy [m²], and a random frequency [rad/s] in its middle
// half. In the full bin two neighbours could be so close that three hours are short for their beat.
WaveComponent component_of(double energy, double from, double to, double direction, Random& random) {
  WaveComponent c;
  c.amplitude = std::sqrt(2 * energy);
  c.omega = from + (0.25 + 0.5 * random.next()) * (to - from);
  c.phase = 2 * M_PI * random.next();
  c.x = std::cos(direction);
  c.y = std::sin(direction);
  return c;
}

}  // namespace

std::vector<WaveComponent> irregular(const Jonswap& spectrum, double direction, int count, std::uint64_t seed,
                                     double spreading) {
  // Bins that grow with the frequency: fine enough at the peak, and far enough apart that three hours average
  // over their beats. The sea does not repeat itself.
  constexpr double kFrom = 0.35, kTo = 10;  // of the peak
  constexpr int kFine = 64;
  const double peak = 2 * M_PI / spectrum.peak_period;
  const Grid g(peak, spectrum.gamma, kFrom, kTo, kFine * count);
  Random random = random_of(seed);
  std::vector<WaveComponent> out;
  for (int i = 0; i < count; ++i) {
    const size_t from = kFine * i;
    const size_t to = from + kFine;
    // The energy excluded by the range is distributed to all bins.
    const double energy = (g.sum[to] - g.sum[from]) / g.sum.back() * spectrum.height * spectrum.height / 16;
    out.push_back(component_of(energy, g.omega[from], g.omega[to], direction, random));
  }
  if (spreading > 0) spread(out, direction, spreading, random);
  return out;
}

std::vector<WaveComponent> irregular(const std::vector<SpectrumRow>& rows, double direction, int count,
                                     std::uint64_t seed, double spreading) {
  // Energy below a frequency, exact for linear interpolation.
  const auto below = [&rows](double omega) {
    double sum = 0;
    for (size_t i = 1; i < rows.size() && rows[i - 1].omega < omega; ++i) {
      const SpectrumRow& a = rows[i - 1];
      const SpectrumRow& b = rows[i];
      const double to = std::min(omega, b.omega);
      const double z = (to - a.omega) / (b.omega - a.omega);
      sum += (to - a.omega) * (a.density + 0.5 * z * (b.density - a.density));
    }
    return sum;
  };
  const double last = rows.back().omega;
  const double first = std::max(rows.front().omega, last / 50);
  Random random = random_of(seed);
  std::vector<WaveComponent> out;
  // The energy below the first bin is added to it.
  double from = first;
  double so_far = 0;
  for (int i = 1; i <= count; ++i) {
    const double to = i < count ? first * std::pow(last / first, static_cast<double>(i) / count) : last;
    const double sum = below(to);
    const WaveComponent c = component_of(sum - so_far, from, to, direction, random);
    if (sum > so_far) out.push_back(c);
    from = to;
    so_far = sum;
  }
  if (spreading > 0) spread(out, direction, spreading, random);
  return out;
}

}  // namespace hawser
