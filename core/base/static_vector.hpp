// StaticVector<T, N>: up to N values in place; push_back says no when full. No heap.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/check.hpp"

namespace quickstrip {

template <typename T, std::size_t N>
class StaticVector {
 public:
  /// False, and nothing changed, when full.
  [[nodiscard]] bool push_back(const T& value) {
    if (size_ >= N) {
      return false;
    }
    items_[size_++] = value;
    return true;
  }
  void clear() { size_ = 0; }
  /// False, and nothing changed, above the capacity. New items are value-initialised.
  [[nodiscard]] bool resize(std::size_t size) {
    if (size > N) {
      return false;
    }
    for (std::size_t i = size_; i < size; ++i) {
      items_[i] = T{};
    }
    size_ = size;
    return true;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  static constexpr std::size_t capacity() { return N; }

  T& operator[](std::size_t i) {
    QS_CHECK(i < size_);
    return items_[i];
  }
  const T& operator[](std::size_t i) const {
    QS_CHECK(i < size_);
    return items_[i];
  }
  const T& front() const { return (*this)[0]; }
  const T& back() const { return (*this)[size_ - 1]; }
  T& back() { return (*this)[size_ - 1]; }

  T* begin() { return items_.data(); }
  T* end() { return items_.data() + size_; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + size_; }
  [[nodiscard]] std::span<const T> span() const { return {items_.data(), size_}; }

 private:
  std::array<T, N> items_{};
  std::size_t size_ = 0;
};

}  // namespace quickstrip
