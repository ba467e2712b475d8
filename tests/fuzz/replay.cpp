// Runs a fuzz driver over files: those of its corpus, or a single input that a fuzzer has found. Without any,
// over bytes that mean nothing, the same at each run: what a driver has that has no corpus yet.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr int random_inputs = 60;

void run_random_inputs() {
  std::mt19937 random;  // the same numbers everywhere
  for (int i = 0; i < random_inputs; ++i) {
    std::vector<std::uint8_t> bytes(12 + 4 * static_cast<std::size_t>(i % 16));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    std::printf("random input %d\n", i);
    std::fflush(stdout);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) {
    run_random_inputs();
    return 0;
  }
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (int i = 1; i < argc; ++i) {
    if (!fs::is_directory(argv[i])) {
      files.emplace_back(argv[i]);
      continue;
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(argv[i])) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
      std::fprintf(stderr, "%s: expected a readable file, found none\n", file.c_str());
      return 2;
    }
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    // Told before it is run: what crashes is the last one named
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%zu inputs\n", files.size());
  if (!files.empty()) return 0;
  std::fprintf(stderr, "expected a corpus or an input, found none\n");
  return 2;
}
