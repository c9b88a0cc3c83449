#include "firmware/display/mailbox.hpp"

#include <chrono>

namespace quickstrip {

void Mailbox::count_malformed() {
  const std::lock_guard lock(mutex_);
  ++mail_->num_malformed;
  mail_->is_empty = false;
}

bool Mailbox::take(std::unique_ptr<Mail>& into, std::chrono::milliseconds patience) {
  into = std::make_unique<Mail>();  // outside the lock
  std::unique_lock lock(mutex_);
  has_come_.wait_for(lock, patience, [&] { return !mail_->is_empty; });
  into.swap(mail_);
  return !into->is_empty;
}

}  // namespace quickstrip
