#include "sim/hull_tool/section_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/csv_file.hpp"
#include "sim/hull_tool/measured_file.hpp"

namespace quickstrip::hull_tool {
namespace {

using Complex = std::complex<double>;

constexpr std::array<std::string_view, 12> kQuantityNames = {"a22", "b22", "a33", "b33", "a24", "b24",
                                                             "a44", "b44", "x2",  "f2",  "f3",  "x4"};

/// Loads of a beam wave of unit amplitude on the fixed section, rho g = 1, about O: sway, heave [m], roll
/// [m2]. Wave e^{kz - iky + i omega t}, pressure the same; n points into the water.
struct BeamLoads {
  Complex sway;
  Complex heave;
  Complex roll;
};

/// Of the undisturbed wave: two Gauss points on each side of the polygon, both halves of the section.
BeamLoads undisturbed(const SectionContour& contour, double k) {
  BeamLoads out;
  const Complex i(0.0, 1.0);
  const double gauss = 0.5 / std::sqrt(3.0);
  for (std::size_t n = 1; n < contour.points.size(); ++n) {
    const Offset& from = contour.points[n - 1];
    const Offset& to = contour.points[n];
    const double ny = to.z - from.z;  // times the length
    const double nz = from.y - to.y;
    for (const double at : {0.5 - gauss, 0.5 + gauss}) {
      const double y = from.y + at * (to.y - from.y);
      const double z = from.z + at * (to.z - from.z);
      const double even = std::exp(k * z) * std::cos(k * y);  // twice half the weight
      const double odd = std::exp(k * z) * std::sin(k * y);
      out.heave -= even * nz;
      out.sway += i * odd * ny;
      out.roll += i * odd * (y * nz - z * ny);
    }
  }
  return out;
}

BeamLoads beam_loads(const SectionContour& contour, const SectionFlow& flow) {
  const double k = flow.wave_number;  // omega^2 / g: omega i a + b over rho g, per velocity, comes to this:
  const Complex i(0.0, 1.0);
  const auto impedance = [&](double a, double h_h) { return i * a + h_h; };  // (i omega a + b) / (rho omega)
  const double h2 = flow.h2;
  const DiffractionFactors factors = diffraction_factors(flow, k, 1.0);
  BeamLoads out = undisturbed(contour, k);
  // (i omega a + b) v, v2 = omega, v3 = i omega: rho omega^2 = rho g k.
  out.heave += k * impedance(flow.a33, flow.h3 * flow.h3) * factors.heave * i;
  out.sway += k * impedance(flow.a22, h2 * h2) * factors.sway;
  out.roll += k * (impedance(flow.a24, h2 * flow.h4) * factors.sway +
                   impedance(flow.a22, h2 * h2) * factors.roll_lever);
  return out;
}

}  // namespace

std::string_view name_of(SectionQuantity quantity) {
  return kQuantityNames[static_cast<std::size_t>(quantity)];
}

std::vector<SectionFigure> read_section_figures(const std::string& path, const std::string& section) {
  CsvFile file(path);
  const std::size_t quantity = file.column({"quantity"});
  const std::size_t abscissa = file.column({"abscissa"});
  const std::size_t measured = file.column({"measured"});
  for (const std::size_t column : {quantity, abscissa, measured}) {
    if (column == CsvFile::kNone) {
      file.refuse("the header names its columns: quantity, abscissa, measured, and perhaps section");
    }
  }
  return figures_of_model<SectionFigure>(file, path, "section", section, [&](const CsvFile& line) {
    const auto at = std::find(kQuantityNames.begin(), kQuantityNames.end(), line.field(quantity));
    if (at == kQuantityNames.end()) {
      line.refuse(fmt::format("quantity = {}: one of {} is wanted", line.field(quantity),
                              fmt::join(kQuantityNames, ", ")));
    }
    return SectionFigure{static_cast<SectionQuantity>(at - kQuantityNames.begin()),
                         line.number(abscissa, "abscissa", {0.01, 10.0}),
                         line.number(measured, "measured", {1e-6, 1000.0})};
  });
}

SectionContour read_contour_file(const std::string& path) {
  CsvFile file(path);
  const std::size_t y = file.column({"y_m"});
  const std::size_t z = file.column({"z_m"});
  if (y == CsvFile::kNone || z == CsvFile::kNone) {
    file.refuse("the header names its columns: y_m, z_m");
  }
  std::vector<Offset> points;
  while (file.next_line()) {
    points.push_back({file.number(y, "y_m", {0.0, 1000.0}), file.number(z, "z_m", {-1000.0, 0.0})});
  }
  try {
    return section_contour(points);
  } catch (const std::invalid_argument& error) {
    throw InputError{fmt::format("{}: {}", path, error.what())};
  }
}

double wave_number_of(const SectionContour& contour, const SectionFigure& figure) {
  return figure.abscissa * figure.abscissa / contour.half_breadth();
}

double computed_figure(const SectionContour& contour, const SectionFlow& flow, SectionQuantity quantity) {
  const double b = 2.0 * contour.half_breadth();
  const double k = flow.wave_number;
  const double area_of = area(contour);
  // b / (rho omega) = h h; times sqrt(B / 2g): omega sqrt(B / 2g).
  const double root = std::sqrt(0.5 * k * b);
  switch (quantity) {
    case SectionQuantity::kA22:
      return flow.a22 / area_of;
    case SectionQuantity::kB22:
      return flow.h2 * flow.h2 * root / area_of;
    case SectionQuantity::kA33:
      return flow.a33 / area_of;
    case SectionQuantity::kB33:
      return flow.h3 * flow.h3 * root / area_of;
    case SectionQuantity::kA24:
      return flow.a24 / (area_of * b);
    case SectionQuantity::kB24:
      return flow.h2 * flow.h4 * root / (area_of * b);
    case SectionQuantity::kA44:
      return flow.a44 / (area_of * b * b);
    case SectionQuantity::kB44:
      return flow.h4 * flow.h4 * root / (area_of * b * b);
    case SectionQuantity::kX2:
      return std::abs(beam_loads(contour, flow).sway) / (k * area_of);
    case SectionQuantity::kF2:
      return std::abs(beam_loads(contour, flow).sway) / b;
    case SectionQuantity::kF3:
      return std::abs(beam_loads(contour, flow).heave) / b;
    case SectionQuantity::kX4:
      return std::abs(beam_loads(contour, flow).roll) / (k * b * b * b / 12.0);
  }
  return 0.0;
}

}  // namespace quickstrip::hull_tool
