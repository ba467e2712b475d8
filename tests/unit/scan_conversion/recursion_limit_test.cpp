// Where the recursive fill overflows the machine's stack: the numbers of errata E001-07.

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/flood_fill_notes.hpp"
#include "support/sanitized.hpp"

namespace gradus::flood_fill {
namespace {

using Canvas = Raster<std::uint8_t>;
constexpr std::size_t stack_bytes = std::size_t{8} << 20;

/// The notes' listing, nearly to the letter: everything but the position is global.
Canvas* notes_canvas = nullptr;
void notes_fill(int x, int y, int target, int color) {
  if (x < 0 || x >= notes_canvas->width() || y < 0 || y >= notes_canvas->height()) return;
  if ((*notes_canvas)[{x, y}] != target) return;
  (*notes_canvas)[{x, y}] = static_cast<std::uint8_t>(color);
  notes_fill(x + 1, y, target, color);
  notes_fill(x - 1, y, target, color);
  notes_fill(x, y + 1, target, color);
  notes_fill(x, y - 1, target, color);
}

void* run_notes(void* canvas) {
  notes_canvas = static_cast<Canvas*>(canvas);
  notes_fill(0, 0, 0, 2);
  return nullptr;
}

void* run_recursive(void* canvas) {
  auto& c = *static_cast<Canvas*>(canvas);
  recursive({0, 0}, [&](ivec2 p) { return c.contains(p) && c[p] == 0; }, [&](ivec2 p) { c[p] = 2; });
  return nullptr;
}

void* run_span(void* canvas) {
  fill_raster(*static_cast<Canvas*>(canvas), {0, 0}, std::uint8_t{2}, Method::span);
  return nullptr;
}

void* run_depth_first(void* canvas) {
  fill_raster(*static_cast<Canvas*>(canvas), {0, 0}, std::uint8_t{2}, Method::depth_first);
  return nullptr;
}

/// Whether an empty canvas of n x n is filled from its corner on a stack of 8 MiB.
/// In a child process, since it may crash.
bool survives(void* (*run)(void*), int n) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    if (!std::freopen("/dev/null", "w", stderr)) _exit(3);  // what a sanitizer says of it
    Canvas canvas(n, n);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stack_bytes);
    pthread_t thread;
    if (pthread_create(&thread, &attributes, run, &canvas) != 0) _exit(3);
    pthread_join(thread, nullptr);
    _exit(std::count(canvas.cells().begin(), canvas.cells().end(), 2) == std::int64_t{n} * n ? 0 : 4);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// The smallest side that crashes.
int limit(void* (*run)(void*)) {
  int fine = 8, crashes = 2048;
  EXPECT_TRUE(survives(run, fine));
  EXPECT_FALSE(survives(run, crashes));
  while (crashes - fine > 1) {
    const int middle = (fine + crashes) / 2;
    (survives(run, middle) ? fine : crashes) = middle;
  }
  return crashes;
}

/// Every cell of a square keeps a call open: whatever a call needs, it must lie between these.
void expect_a_call_a_cell(const char* name, void* (*run)(void*)) {
  const int side = limit(run);
  const double bytes = static_cast<double>(stack_bytes) / (1.0 * side * side);
  std::printf("%s: crashes from %d x %d on, %.0f bytes per call\n", name, side, side, bytes);
  EXPECT_GT(bytes, 16);  // a return address and a frame pointer
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
  EXPECT_LT(bytes, 256);
#endif
}

TEST(FloodFillRecursion, TheNotesListingKeepsACallOpenForEachCell) {
  expect_a_call_a_cell("the notes' listing", run_notes);
}

TEST(FloodFillRecursion, SoDoesItsExhibit) { expect_a_call_a_cell("recursive", run_recursive); }

TEST(FloodFillRecursion, OthersDoNot) {
  const int side = test::sanitized ? 512 : 2048;  // there a call takes many times the stack
  EXPECT_TRUE(survives(run_depth_first, side));
  EXPECT_TRUE(survives(run_span, side));
}

}  // namespace
}  // namespace gradus::flood_fill
