#pragma once
// Random orders and coins that are computed where they are asked for, not kept: patterns need no memory
// beside their samples.

#include <bit>
#include <cstdint>

#include "core/random.hpp"

namespace gradus::jittered {

/// Where `number` comes to lie when 0 … length - 1 are shuffled: a bijection for every key, without memory.
/// Source: A. Kensler, "Correlated multi-jittered sampling", Pixar Technical Memo 13-01, 2013, listing 3.
/// Domain: 0 <= number < length. Cost: some 30 operations, at most twice on average.
constexpr int permuted(int number, int length, std::uint32_t key) {
  const std::uint32_t count = static_cast<std::uint32_t>(length), mask = std::bit_ceil(count) - 1;
  std::uint32_t i = static_cast<std::uint32_t>(number);
  // A bijection of 0 … mask; again until the number is one of those that are shuffled
  do {
    i = (i ^ key) * 0xe170893d;
    i ^= key >> 16;
    i = (i ^ (i & mask) >> 4 ^ key >> 8) * 0x0929eb3f;
    i ^= key >> 23;
    i = (i ^ (i & mask) >> 1) * (1 | key >> 27) * 0x6935fa69;
    i = (i ^ (i & mask) >> 11) * 0x74dcb303;
    i = (i ^ (i & mask) >> 2) * 0x9e501cc3;
    i = ((i ^ (i & mask) >> 2) * 0xc860a3df) & mask;
    i ^= i >> 5;
  } while (i >= count);
  return static_cast<int>((std::uint64_t{i} + key) % count);
}

/// 0 … length - 1 in a random order, which is not stored: see permuted.
class Shuffle {
 public:
  constexpr Shuffle(int length, Random& random)
      : length_(length), key_(static_cast<std::uint32_t>(random())) {}
  constexpr int operator()(int number) const { return permuted(number, length_, key_); }

 private:
  int length_;
  std::uint32_t key_;
};

/// A coin for each node of a binary tree, the root is node 1: always the same for the same node.
/// Cost: one random number for 64 nodes that are asked for one after the other.
class Coins {
 public:
  constexpr explicit Coins(Random random) : random_(random), tosses_(random.at(0)) {}

  constexpr bool operator()(std::uint32_t node) {
    if (node / 64 != block_) tosses_ = random_.at(block_ = node / 64);
    return (tosses_ >> node % 64 & 1) != 0;
  }

 private:
  Random random_;
  std::uint64_t tosses_;
  std::uint32_t block_ = 0;
};

}  // namespace gradus::jittered
