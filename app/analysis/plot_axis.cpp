#include "app/analysis/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

// 1, 2 or 5 times a power of ten, at least `raw`.
double roundStep(double raw) {
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= raw * (1 - 1e-9)) return step * power;
  return 10 * power;
}

double degreeStep(double raw) {
  for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0})
    if (step >= raw) return step;
  return raw < 1 ? roundStep(raw) : 90;
}

std::string plain(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  if (std::abs(value) < step * 1e-6) return "0";
  return withMinus(fmt::format("{:.{}f}", value, decimals));
}

// With raised powers where digits would not be read.
std::string readableTick(double value, double step, double largest) {
  const int power = value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
  if (value == 0 || (largest < 99999 && step > 9e-6)) return plain(value, step);
  return withMinus(fmt::format("{:g}\u00b710^{{{}}}", std::round(value / std::pow(10.0, power) * 1e6) / 1e6, power));
}

std::string powerOfTen(int exponent) {
  if (exponent >= -3 && exponent <= 4) return fmt::format("{:g}", std::pow(10.0, exponent));
  return withMinus(fmt::format("10^{{{}}}", exponent));
}

double forward(PlotScale scale, double value) {
  if (scale == PlotScale::Log) return value > 0 ? std::log10(value) : -300;
  if (scale == PlotScale::LogPlus) return std::log10(1 + std::max(value, 0.0));
  return value;
}
double backward(PlotScale scale, double x) {
  if (scale == PlotScale::Log) return std::pow(10.0, x);
  if (scale == PlotScale::LogPlus) return std::pow(10.0, x) - 1;
  return x;
}

std::vector<PlotTick> logTicks(const PlotAxis& axis, int count) {
  std::vector<PlotTick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(axis.low) + 1e-9)), last = static_cast<int>(std::ceil(std::log10(axis.high) - 1e-9));
  const int stride = std::max(1, (last - first + count - 1) / count);
  const bool few = last - first <= 2;    // then the values between the decades are named too
  for (int e = first; e <= last; ++e)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (value < axis.low * (1 - 1e-9) || value > axis.high * (1 + 1e-9)) continue;
      if (digit > 1 && stride > 1) break;
      std::string label;
      if (digit == 1 && (e - first) % stride == 0) label = powerOfTen(e);
      else if (few && (digit == 2 || digit == 5)) label = fmt::format("{:g}", value);
      if (stride == 1 || !label.empty()) ticks.push_back({value, label});
    }
  return ticks;
}

}  // namespace

double PlotAxis::unit(double value) const {
  const double a = forward(scale, low), b = forward(scale, high);
  return (forward(scale, value) - a) / (b - a);
}

double PlotAxis::value(double unit) const {
  const double a = forward(scale, low), b = forward(scale, high);
  return backward(scale, a + unit * (b - a));
}

std::vector<PlotTick> PlotAxis::ticks(int count) const {
  // A short span of a logarithm is as good as linear, and 1, 2, 5 would be too few marks on it.
  if (scale == PlotScale::Log && high / low > 4) return logTicks(*this, count);
  std::vector<PlotTick> ticks;
  if (scale == PlotScale::LogPlus && high > 20) {
    ticks.push_back({0, "0"});
    for (int e = 0; std::pow(10.0, e) <= high * (1 + 1e-9); ++e) {
      ticks.push_back({std::pow(10.0, e), powerOfTen(e)});
      if (e == 0 || 3 * std::pow(10.0, e) > high) continue;
      ticks.push_back({3 * std::pow(10.0, e), ""});
    }
    return ticks;
  }
  const bool degrees = scale == PlotScale::Degrees;
  const double step = degrees ? degreeStep((high - low) / count) : roundStep((high - low) / count);
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + step * 1e-9; ++i) {
    std::string label = readableTick(i * step, step, std::max(std::abs(low), std::abs(high)));
    ticks.push_back({i * step, degrees ? label + "\u00b0" : label});
  }
  return ticks;
}

PlotAxis PlotAxis::zoomed(double at, double factor) const {
  return {value(at - at / factor), value(at + (1 - at) / factor), scale};
}

PlotAxis PlotAxis::moved(double units) const { return {value(units), value(1 + units), scale}; }

PlotAxis roundAxis(double low, double high, PlotScale scale, int steps) {
  if (scale == PlotScale::Log) {
    if (!(high > 0)) return {0.1, 1, scale};
    const double top = std::pow(10.0, std::ceil(std::log10(high) - 1e-9));
    double bottom = low > 0 ? std::pow(10.0, std::floor(std::log10(low) + 1e-9)) : 0;
    bottom = std::clamp(bottom, top * std::pow(10.0, -kMostDecades), top / 10);
    return {bottom, top, scale};
  }
  if (high <= low) high = low + 1;
  const double step = roundStep((high - low) / steps);
  return {std::floor(low / step + 1e-6) * step, std::ceil(high / step - 1e-6) * step, scale};
}

std::string withMinus(std::string text) {
  for (size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 3) text.replace(at, 1, "\u2212");
  return text;
}

std::string readable(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : "infinite";
  return withMinus(fmt::format("{:.4g}", std::abs(value) < 1e-12 ? 0.0 : value));
}

}  // namespace glint
