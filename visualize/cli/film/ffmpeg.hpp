#pragma once
// The program ffmpeg as a child process: frames in through a pipe, one file out.

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/system/descriptor.hpp"

namespace gradus::cli {

/// A file without a name: it is gone with the last program that has it open, however that ends.
Descriptor nameless_file(std::string_view contents = {});

/// One run of ffmpeg. Its standard input are the frames; it writes to `output` and may read `palette`, both
/// files without a name. Destroyed before it is finished, it is killed. SIGPIPE must be ignored.
class Ffmpeg {
 public:
  static constexpr std::string_view input = "pipe:0", output = "/dev/fd/3", palette = "/dev/fd/4";

  /// `words` are its arguments, to which those that keep it quiet are added. Throws WorkError.
  explicit Ffmpeg(std::vector<std::string> words, const Descriptor& palette_file = Descriptor());
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;
  ~Ffmpeg();

  /// False when it reads no more: `finish` may say why.
  bool take(std::span<const std::uint8_t> bytes);

  /// What it has written. Throws WorkError with the first line of its complaints when it fails.
  std::string finish();

 private:
  void start(std::vector<std::string> words, const Descriptor& frames, const Descriptor& palette_file);
  int wait();
  std::string reason(int status) const;

  Descriptor output_, complaints_, frames_;
  pid_t process_ = 0;
};

}  // namespace gradus::cli
