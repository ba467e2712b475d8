// An observer must take every step its algorithm reports. This one takes all; with FORGET defined it leaves
// one out, and must not compile (tests/architecture/compile_fail_test.py).
//
// expected: constraints not satisfied
// expected: Observer
#include "scan_conversion/bresenham_line/bresenham_line.hpp"

namespace line = gradus::bresenham_line;

struct Watcher {
  void operator()(const line::Started&) {}
  void operator()(const line::Compared&) {}
#ifndef FORGET
  void operator()(const line::Stepped&) {}
#endif
  void operator()(const line::Finished&) {}
};

void watch() {
  Watcher watcher;
  line::decision_parameter({0, 0}, {7, 3}, [](gradus::ivec2) {}, watcher);
}
