#include "core/contract.hpp"

#include <string>

namespace gradus {

void contract_violated(std::string_view text) { refuse({Refusal::Kind::contract, std::string(text)}); }

void contract_violated(fmt::string_view format, fmt::format_args values) {
  refuse({Refusal::Kind::contract, fmt::vformat(format, values)});
}

}  // namespace gradus
