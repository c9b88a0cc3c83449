// What this machine can do at best, measured in the same run as what is compared with it: multiply-adds in
// double precision with the instructions that this build may use, and reading from the cache level that holds
// a given number of bytes.
#pragma once

#include <cstddef>

namespace quickstrip::bench {

/// Of the calling thread [s].
double processor_seconds();

/// Multiplications and additions a second on independent registers, one core.
double peak_flops();

/// Bytes a second read in sequence from a block of this size that has just been read, one core.
double peak_read_bytes(std::size_t block);

}  // namespace quickstrip::bench
