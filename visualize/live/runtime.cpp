// What lies below the module where there is no system: the functions of WASI that Debian's C library calls,
// and what Debian's C++ library for WebAssembly is compiled against and that C library lacks. With them the
// module needs nothing of its host but what module.cpp imports.

#include <cstddef>
#include <cstdint>

// NOLINTBEGIN: the libraries' names
extern "C" {

/// The stack protector's: functions of the C++ library compare it before they return.
std::uintptr_t __stack_chk_guard = 0x5bd1e995;
[[noreturn]] void __stack_chk_fail() { __builtin_trap(); }

/// The one thread ends with the module: what it has to itself needs no end of its own.
int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }

using Address = std::int32_t;
constexpr std::int32_t success = 0, bad_descriptor = 8;

/// There is no environment.
std::int32_t __imported_wasi_snapshot_preview1_environ_get(Address, Address) { return success; }
std::int32_t __imported_wasi_snapshot_preview1_environ_sizes_get(Address count, Address size) {
  *reinterpret_cast<std::size_t*>(count) = 0;
  *reinterpret_cast<std::size_t*>(size) = 0;
  return success;
}

/// There are no files; what is written to standard output is seen by nobody.
std::int32_t __imported_wasi_snapshot_preview1_fd_close(std::int32_t) { return bad_descriptor; }
std::int32_t __imported_wasi_snapshot_preview1_fd_seek(std::int32_t, std::int64_t, std::int32_t, Address) {
  return bad_descriptor;
}
std::int32_t __imported_wasi_snapshot_preview1_fd_write(std::int32_t, Address, std::int32_t, Address) {
  return bad_descriptor;
}

/// A module has no end.
[[noreturn]] void __imported_wasi_snapshot_preview1_proc_exit(std::int32_t) { __builtin_trap(); }
}
// NOLINTEND
