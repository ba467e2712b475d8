// The module of a live page: what the worker that has loaded it can call. docs/live.md shows how.
//
// It imports three functions and exports six and its memory. Texts are UTF-8 in its memory, by address and
// size; a view of the memory is good until the next call, which may make the memory grow.

#include <cstddef>
#include <new>
#include <string>
#include <utility>

#include "core/refusal.hpp"
#include "live/files.hpp"
#include "live/protocol.hpp"
#include "request/complaint.hpp"

/// The host's: told of a refusal in the words of the gradus command, on one line, and of the parameter that
/// is to blame, "" for none. It should leave by an exception. The instance is at an end: for the next request
/// the host makes a new one and hands it the files anew.
extern "C" [[clang::import_module("gradus"), clang::import_name("refused")]] void gradus_refused(
    const char* line, std::size_t line_size, const char* parameter, std::size_t parameter_size);

/// The host's: calls the export `run` with these two and returns 1; where gradus_leave ends that call, 0.
extern "C" [[clang::import_module("gradus"), clang::import_name("attempt")]] int gradus_attempt(
    void (*work)(void*), void* data);
/// The host's: leaves the innermost gradus_attempt by an exception.
extern "C" [[clang::import_module("gradus"), clang::import_name("leave")]] void gradus_leave();

namespace gradus::live {
namespace {

/// How many attempts are under way. What one has in hand when it is left stays in memory; the frames of the
/// stack go with that of the function that has asked for the attempt.
int attempts = 0;

bool attempt(void (*work)(void*), void* data) {
  const int before = attempts++;
  const bool ended = gradus_attempt(work, data) != 0;
  attempts = before;
  return ended;
}

void hand_over(const Refusal& refusal) {
  if (attempts > 0 && refusal.kind == Refusal::Kind::contract) gradus_leave();
  const std::string line = complaint_of(refusal);
  gradus_refused(line.data(), line.size(), refusal.parameter.data(), refusal.parameter.size());
  __builtin_trap();
}

/// Without memory for a text of its own.
void out_of_memory() {
  constexpr std::string_view line = "out of memory";
  gradus_refused(line.data(), line.size(), line.data(), 0);
  __builtin_trap();
}

/// All that the module keeps from one call to the next.
struct Module {
  std::string room, answer;
  OpenedFiles files;

  Module() {
    set_refusal_handler(hand_over);
    set_attempt_handler(attempt);
    std::set_new_handler(out_of_memory);
  }
  /// The name that stands first in the room.
  std::string name(std::size_t size) const {
    if (size > room.size()) refuse_usage("expected a name in the room that was asked for");
    return room.substr(0, size);
  }
};

Module& state() {
  static Module only;
  return only;
}

}  // namespace
}  // namespace gradus::live

using gradus::live::state;

extern "C" {

/// Room for what the next call takes, and its address. What it held is gone.
[[clang::export_name("room")]] char* gradus_room(std::size_t size) {
  std::string& room = state().room;
  room.assign(size, '\0');
  return room.data();
}

/// Keeps a file that arguments may name. In the room: its name in so many bytes, then what it holds.
[[clang::export_name("keep_file")]] void gradus_keep_file(std::size_t name_size) {
  const std::string name = state().name(name_size);
  state().files.keep(name, state().room.substr(name_size));
}

/// Keeps what a kept file shows. In the room: its name in so many bytes, then red, green, blue and alpha of
/// each pixel, a byte each, row by row from the top.
[[clang::export_name("keep_picture")]] void gradus_keep_picture(std::size_t name_size, int width,
                                                                int height) {
  const std::string name = state().name(name_size);
  gradus::Image picture(width, height);
  const std::string& room = state().room;
  if (room.size() - name_size != 4 * picture.cells().size())
    gradus::refuse_usage("expected four bytes per pixel in the room that was asked for");
  std::size_t at = name_size;
  for (gradus::Rgba8& pixel : picture.cells()) {
    for (std::uint8_t* const part : {&pixel.r, &pixel.g, &pixel.b, &pixel.a})
      *part = static_cast<std::uint8_t>(room[at++]);
  }
  state().files.keep_picture(name, std::move(picture));
}

/// For gradus_attempt alone.
[[clang::export_name("run")]] void gradus_run(void (*work)(void*), void* data) { work(data); }

/// Answers the request in the room (live/protocol.hpp); the address of the text, good until the next call.
[[clang::export_name("answer")]] const char* gradus_answer() {
  std::string& answer = state().answer;
  answer = gradus::live::answer(state().room, state().files);
  return answer.data();
}

/// How many bytes the last answer has.
[[clang::export_name("answer_size")]] std::size_t gradus_answer_size() { return state().answer.size(); }
}
