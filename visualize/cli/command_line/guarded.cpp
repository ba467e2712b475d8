#include "cli/command_line/guarded.hpp"

#include <fmt/format.h>

#include <new>

#include "cli/command_line/errors.hpp"
#include "cli/files/files.hpp"
#include "cli/terminal/terminal.hpp"
#include "core/contract.hpp"
#include "core/image.hpp"
#include "request/complaint.hpp"

namespace gradus::cli {

int guarded(const std::string& program, const std::function<int()>& work) {
  const auto complain = [&](const std::string& text, int code) {
    note(alarming(program + ":", use_color(Color::automatic, Stream::err)) + " " + on_one_line(text));
    return code;
  };
  try {
    return work();
  } catch (const UsageError& error) {
    return complain(error.what(), 2);
  } catch (const ArgumentError& error) {
    return complain(complaint_of(error), 2);
  } catch (const InputError& error) {
    return complain(error.what(), 2);
  } catch (const OutputClosed&) {
    return 1;
  } catch (const std::bad_alloc&) {
    return complain("out of memory", 1);
  } catch (const std::exception& error) {
    return complain(error.what(), 1);
  }
}

}  // namespace gradus::cli
