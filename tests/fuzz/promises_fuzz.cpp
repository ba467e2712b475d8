// The promises of one topic, on numbers made from bytes: a case of a promise's own generator with some
// numbers changed, or numbers as they come. Linked with the promises of topic T, this is the driver T.

#include "stress/attack.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::stress;

namespace {

Input numbers_from(test::FuzzInput& bytes, const Property& property) {
  Input numbers(property.numbers);
  if (bytes.coin()) {
    for (double& x : numbers) x = bytes.any_number();
    return numbers;
  }
  const Kind kind =
      property.kinds[static_cast<std::size_t>(bytes.below(static_cast<int>(property.kinds.size())))];
  Random random(bytes.word());
  numbers = property.generate(kind, random);
  for (int changes = bytes.below(4); changes > 0; --changes) {
    numbers[static_cast<std::size_t>(bytes.below(static_cast<int>(numbers.size())))] = bytes.any_number();
  }
  return numbers;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput bytes(data, size);
  const Domain& domain = domains().front();
  const Property& property =
      domain.properties[static_cast<std::size_t>(bytes.below(static_cast<int>(domain.properties.size())))];
  const Input numbers = numbers_from(bytes, property);
  if (property.error(numbers) <= property.bound) return 0;
  std::fprintf(stderr, "gradus stress %s --replay '%s:%s'\n", domain.topic.c_str(), property.name.c_str(),
               text_of(numbers).c_str());
  test::require(false, property.states.c_str());
  return 0;
}
