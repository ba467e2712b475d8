// Files that `gradus again` is given: the command in them is found and read, or there is none.

#include <cstdint>
#include <string_view>

#include "cairo/colophon_markup.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/figures/figure_file.hpp"
#include "core/image.hpp"
#include "request/names.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    if (!cli::format_by_content(bytes)) return 0;
    const auto colophon = colophon_in(bytes);
    if (!colophon) return 0;
    const auto words = shell_words(colophon->command);
    if (!words || words->empty()) return 0;
    static_cast<void>(cli::read_request({words->begin() + 1, words->end()}));
  } catch (const UsageError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  } catch (const InputError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  }
  return 0;
}
