# CMake's toolchain file for WebAssembly: Debian's Clang 19 with its C++ and C libraries for wasm32-wasi (./bootstrap live
# installs them). No exceptions, no threads, no files: what the host of the module gives is all there is.
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions")
# A library that is called, not a program that ends. 1 MiB of stack, which traps at its end, and at most 1 GiB of memory
set(CMAKE_EXE_LINKER_FLAGS_INIT
    "-mexec-model=reactor -Wl,--strip-all -Wl,-z,stack-size=1048576 -Wl,--stack-first -Wl,--max-memory=1073741824")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
