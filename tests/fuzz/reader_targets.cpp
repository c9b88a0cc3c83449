// Readers beside those of the ship's own files: the state file of the advisor, the five files of NDBC, a CSV
// of transfer functions, a LIST of the command line.
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "firmware/advisor/kept_inputs_file.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/digest.hpp"
#include "msgs/files/lcm_log.hpp"
#include "sim/hull_tool/transfer_file.hpp"
#include "sim/sea_files/ndbc_import.hpp"
#include "tests/fuzz/good_bytes.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/tiny_ship.hpp"

namespace quickstrip::fuzz {
namespace {

/// A folder of this process, taken away at its end.
const std::filesystem::path& folder() {
  static const struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("qs_fuzz" + std::to_string(getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code none;
      std::filesystem::remove_all(path, none);
    }
  } kFolder;
  return kFolder.path;
}

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

Bytes bytes_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

/// The same bytes with a seal that fits, so that they reach what is behind it.
void seal_again(const std::filesystem::path& path) {
  LcmLogReader log;
  if (!log.open(path)) {
    return;
  }
  Fnv1a digest;
  LogEvent event;
  LcmLogWriter out;
  require(out.open(path).ok(), "the folder can be written");
  while (log.next(event)) {
    if (event.channel != "QS_STATE_DIGEST" && out.append(event.utime, event.channel, event.data)) {
      digest.add(event.channel);
      digest.add(event.data);
    }
  }
  const auto seal = std::bit_cast<std::array<std::uint8_t, 8>>(digest.value());
  require(out.append(0, "QS_STATE_DIGEST", seal).ok() && out.finish().ok(), "the folder can be written");
}

void restore(const std::filesystem::path& path) {
  static const auto session = [] {
    auto made = std::make_unique<Session>();
    configure(*made);
    return made;
  }();
  static const auto limits = std::make_unique<limits_t>();
  int num_restored = 0;
  bool is_whole = false;
  constexpr std::int64_t kNow = 1'567'600'800'000'000;
  if (look_at_state(path, "QS_", is_whole)) {
    require(restore_inputs(path, "QS_", kNow, *session, num_restored).ok(), "what can be looked at is read");
    require(read_kept_limits(path, "QS_", *limits).ok(), "and its limits");
    require(is_whole || num_restored == 0, "nothing comes out of a damaged file");
  }
}

}  // namespace

void run_state(std::span<const std::uint8_t> bytes) {
  const auto path = folder() / "state.log";
  write_file(path, bytes);
  restore(path);
  seal_again(path);
  restore(path);
}

std::vector<Bytes> state_seeds() {
  const auto path = folder() / "seed.log";
  const auto kept = std::make_unique<KeptInputs>();
  const auto limits = std::make_unique<limits_t>();
  kept->has_sea_state = kept->has_own_ship = true;
  require(decode(good_bytes("SEA_STATE"), kept->sea_state) && decode(good_bytes("OWN_SHIP"), kept->own_ship),
          "good messages decode");
  require(write_kept_inputs(path, "QS_", *kept, *limits).ok(), "the folder can be written");
  return {bytes_of_file(path)};
}

/// Five files in one input, with a line of their own between them.
void run_ndbc(std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  constexpr std::string_view kLetters = "wdijk";
  std::size_t from = 0;
  for (const char letter : kLetters) {
    const std::size_t end = std::min(text.find("\n====\n", from), text.size());
    std::ofstream(folder() / ("b_41010" + std::string(1, letter) + "_1.txt"), std::ios::binary)
        << text.substr(std::min(from, text.size()), end - std::min(from, text.size()));
    from = std::min(end + 6, text.size());
  }
  BuoyRecord record;
  NdbcNotes notes;
  const std::string prefix = folder() / "b_41010";
  if (const FileStatus status = import_ndbc(prefix, record, notes); !status) {
    require(!status.line().empty(), "a refusal says something");
  }
}

std::vector<Bytes> ndbc_seeds() {
  const std::string header = "#YY  MM DD hh mm   .0500   .1000   .1500\n2019 09 04 12 40 ";
  std::string all;
  for (const char* const values :
       {"0.1 5.0 1.0", "90.0 91.0 92.0", "90.0 91.0 92.0", "80 85 70", "60 70 50"}) {
    all += header + values + "\n====\n";
  }
  return {bytes_of(all)};
}

void run_transfer(std::span<const std::uint8_t> bytes) {
  static MemoryFile file;
  file.fill(bytes);
  try {
    for (const hull_tool::TransferValue& value : hull_tool::read_transfer_file(file.path())) {
      require(std::isfinite(value.amplitude) && value.motion < 6, "what is accepted is a number");
    }
  } catch (const InputError& error) {
    require_one_line(error.line, file.path());
  }
}

std::vector<Bytes> transfer_seeds() {
  return {
      bytes_of("# tank\nspeed_kn,mu_deg,omega,dof,amplitude\n10,180,0.6,heave,0.9\n10,180,0.6,pitch,0.02\n"),
      bytes_of("speed_kn,direction_deg,omega_rad_s,surge_amp,sway_amp,heave_amp,roll_amp,pitch_amp,yaw_amp\n"
               "0,90,0.5,,0.1,0.9,0.05,,\n")};
}

void run_list(std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  constexpr ListRange kRange{-10.0, 1e4};
  try {
    const std::vector<double> values = parse_list("--omega", text, kRange);
    require(!values.empty() && values.size() <= 10'000, "a list holds one to ten thousand values");
    for (const double value : values) {
      require(value >= kRange.from && value <= kRange.to, "a value of a list is in its range");
    }
  } catch (const CLI::ValidationError& error) {
    require(std::string_view(error.what()).size() > 8, "wrong use is explained");
  }
}

std::vector<Bytes> list_seeds() {
  return {bytes_of("10"), bytes_of("0,5,10"), bytes_of("0,10:20:5"), bytes_of("1:2:0.3")};
}

}  // namespace quickstrip::fuzz
