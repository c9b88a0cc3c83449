#include "sim/hull_tool/transfer_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "msgs/cli/run_tool.hpp"
#include "msgs/files/printable.hpp"
#include "sim/hull_tool/csv_file.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr ListRange kAmplitudes{0.0, 1000.0};

struct Columns {
  std::size_t speed = CsvFile::kNone;
  std::size_t mu = CsvFile::kNone;
  std::size_t omega = CsvFile::kNone;
  std::size_t dof = CsvFile::kNone;
  std::size_t amplitude = CsvFile::kNone;
  std::array<std::size_t, 6> motion{};
};

Columns find_columns(const CsvFile& file) {
  constexpr std::size_t kNone = CsvFile::kNone;
  Columns c;
  c.speed = file.column({"speed_kn"});
  c.mu = file.column({"mu_deg", "direction_deg"});
  c.omega = file.column({"omega", "omega_rad_s"});
  c.dof = file.column({"dof"});
  c.amplitude = file.column({"amplitude"});
  for (std::size_t i = 0; i < kMotionNames.size(); ++i) {
    c.motion[i] = file.column({fmt::format("{}_amp", kMotionNames[i])});
  }
  const bool is_long = c.dof != kNone && c.amplitude != kNone;
  const bool is_half_long = (c.dof != kNone) != (c.amplitude != kNone);
  const bool is_wide =
      std::any_of(c.motion.begin(), c.motion.end(), [](std::size_t column) { return column != kNone; });
  if (c.speed == kNone || c.mu == kNone || c.omega == kNone || is_long == is_wide || is_half_long) {
    file.refuse(
        "the header names its columns: speed_kn, mu_deg, omega, and either dof,amplitude or surge_amp "
        "... yaw_amp");
  }
  return c;
}

std::size_t motion_of(const CsvFile& file, std::string_view name) {
  const auto at = std::find(kMotionNames.begin(), kMotionNames.end(), name);
  if (at == kMotionNames.end()) {
    file.refuse(fmt::format("dof = {}: one of {} is wanted", printable(name), fmt::join(kMotionNames, ", ")));
  }
  return static_cast<std::size_t>(at - kMotionNames.begin());
}

void add_line(const CsvFile& file, const Columns& c, std::vector<TransferValue>& values) {
  TransferValue value;
  value.speed_kn = file.number(c.speed, "speed_kn", {0.0, 60.0});
  value.mu_deg = file.number(c.mu, "mu_deg", {-360.0, 360.0});
  value.omega = file.number(c.omega, "omega", {1e-3, 20.0});
  if (c.dof != CsvFile::kNone) {
    value.motion = motion_of(file, file.field(c.dof));
    value.amplitude = file.number(c.amplitude, "amplitude", kAmplitudes);
    values.push_back(value);
    return;
  }
  for (std::size_t i = 0; i < c.motion.size(); ++i) {
    if (c.motion[i] != CsvFile::kNone && !file.field(c.motion[i]).empty()) {
      value.motion = i;
      value.amplitude = file.number(c.motion[i], fmt::format("{}_amp", kMotionNames[i]), kAmplitudes);
      values.push_back(value);
    }
  }
}

}  // namespace

std::vector<TransferValue> read_transfer_file(const std::string& path) {
  CsvFile file(path);
  const Columns columns = find_columns(file);
  std::vector<TransferValue> values;
  while (file.next_line()) {
    add_line(file, columns, values);
  }
  if (values.empty()) {
    throw InputError{path + ": holds no transfer function"};
  }
  return values;
}

}  // namespace quickstrip::hull_tool
