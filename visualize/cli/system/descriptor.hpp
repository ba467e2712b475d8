#pragma once
// What the operating system calls an open file.

#include <utility>

namespace gradus::cli {

/// An open file, or none (a negative number), that is closed with this object.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }
  int number() const { return number_; }
  /// Nothing when it is closed already. False: a network folder may report a full disk only now.
  bool close();

 private:
  int number_;
};

}  // namespace gradus::cli
