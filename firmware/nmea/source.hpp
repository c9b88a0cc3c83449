// Where lines come from: a UDP port (unicast, broadcast or multicast, IEC 61162-450 too), a serial device, a
// file or standard input. Each is a file descriptor that is never waited for by a read: the poll of run.hpp
// waits for all of them together.
//
// Memory: buffers of fixed size; nothing is allocated after opening. A serial device that goes away (an
// adapter pulled out) is opened again every two seconds; a file or standard input ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "firmware/nmea/gateway.hpp"
#include "firmware/nmea/line_framer.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip::nmea {

enum class SourceKind : std::uint8_t { kUdp, kSerial, kFile };

struct SourceSpec {
  SourceKind kind = SourceKind::kUdp;
  std::string where;      // "PORT[@ADDRESS]", "DEVICE[@BAUD]", a path or "-"
  std::string interface;  // of multicast: the address of ours that joins; empty: the system's choice
  int baud = 4800;        // of a serial device that names none
};

class Source {
 public:
  explicit Source(SourceSpec spec) : spec_(std::move(spec)) {}
  Source(Source&& other) noexcept;
  Source& operator=(Source&&) = delete;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  ~Source();

  /// One line says what is wrong.
  FileStatus open();

  /// What is there, up to a bound, so that no source starves another; never waits. `arrival` is when the poll
  /// returned.
  void read(std::size_t index, std::int64_t arrival, Gateway& gateway);

  /// Opens again what has gone away, at most every two seconds.
  void mend(std::int64_t now);

  [[nodiscard]] int fd() const { return fd_; }
  [[nodiscard]] bool has_ended() const { return has_ended_; }
  [[nodiscard]] bool is_file() const { return spec_.kind == SourceKind::kFile; }
  [[nodiscard]] const std::string& name() const { return spec_.where; }

 private:
  FileStatus open_udp();
  FileStatus open_serial();
  FileStatus open_file();
  void read_datagrams(std::size_t index, std::int64_t arrival, Gateway& gateway);
  void read_stream(std::size_t index, std::int64_t arrival, Gateway& gateway);
  void close();

  SourceSpec spec_;
  int fd_ = -1;
  bool has_ended_ = false;
  std::int64_t lost_utime_ = 0;  // 0: not lost
  LineFramer framer_;
};

}  // namespace quickstrip::nmea
