// `gradus demo`: a film from a car on a circular road, its frames, or a strip of five of them.

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "cairo/image_file.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/files.hpp"
#include "cli/files/shipped.hpp"
#include "cli/film/film.hpp"
#include "cli/film/frames_ahead.hpp"
#include "cli/film/road_film.hpp"
#include "cli/terminal/progress.hpp"
#include "core/shown.hpp"
#include "request/fingerprint.hpp"
#include "request/names.hpp"
#include "scene/models/textures.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view data_name = "pyramid_demo.json", texture_name = "pyramid_demo.png";

/// A file that was read.
struct Given {
  std::string path, bytes;
};

/// What a flag names, or what comes with the program.
Given given(const Request& request, const std::string& flag, std::string_view own) {
  const auto named = request.flags.find(flag);
  const std::string what = "--" + flag;
  if (named != request.flags.end()) {
    const FoundFile file = as_named(named->second, what);
    return {file.path, read_input(file.path, what)};
  }
  const std::string path = shipped(fmt::format("examples/demos/{}", own));
  if (path.empty())
    throw UsageError(fmt::format("{}: expected {}, which comes with gradus, found none", what, own));
  return {path, read_input(path, what)};
}

/// What is to be made, and of what.
struct Order {
  std::size_t which = 0;
  std::optional<std::string> output, folder;  ///< of film or strip, of the frames
  bool is_strip = false;
  Given data, texture;
  std::string said;  ///< the flags that name files, without folders: " --data road.json"
  std::size_t threads = 1;
  Replace replace = Replace::own;
  bool quiet = false;
};

bool ends_in(const std::string& path, std::string_view ending) {
  return folded(fs::path(path).extension().string()) == ending;
}

std::optional<std::string> flag(const Request& request, const std::string& name) {
  const auto found = request.flags.find(name);
  return found == request.flags.end() ? std::nullopt : std::optional(found->second);
}

void check_outputs(const Order& order) {
  if (!order.output && !order.folder)
    throw UsageError("-o: expected a film like forward.mp4, or --frames with a folder, found neither");
  if (!order.output) return;
  if (*order.output == dash && is_terminal(Stream::out))
    throw UsageError("-o: expected a file or a pipe for mp4, found a terminal");
  if (*order.output != dash && !order.is_strip && !ends_in(*order.output, ".mp4")) {
    throw UsageError(fmt::format(
        "-o: expected a name that ends in .mp4, the film, or .png, a strip of five frames, found {}",
        shown(*order.output)));
  }
  check_output(*order.output, std::vector{order.data.path, order.texture.path}, order.replace);
}

Order order_of(const Request& request) {
  Order order;
  std::vector<std::string> names;
  for (const DemoName& demo : demo_names) names.emplace_back(demo.name);
  order.which = choose_name("DEMO", request.operands.at(0), names);
  order.output = flag(request, "output");
  order.folder = flag(request, "frames");
  order.is_strip = order.output && ends_in(*order.output, ".png");
  order.threads = read_jobs(request);
  order.replace = replaces(request.has("force"));
  order.quiet = request.quiet();
  order.data = given(request, "data", data_name);
  order.texture = given(request, "texture", texture_name);
  for (const char* const name : {"data", "texture"}) {
    if (const auto path = flag(request, name))
      order.said += fmt::format(" --{} {}", name, shell_quoted(fs::path(*path).filename().string()));
  }
  check_outputs(order);
  return order;
}

std::string frame_path(const std::string& folder, std::size_t i) {
  return (fs::path(folder) / fmt::format("{:03}.png", i)).string();
}

Colophon colophon_of(const Order& order, const RoadFilm& film) {
  const DemoName& demo = demo_names[order.which];
  const pipeline::RoadDemo& data = film.demo();
  return {fmt::format("The view from a car on a circular road: {}", demo.name),
          fmt::format("{}: {} frames, {} a second; {} triangles.", demo.what, film.frames(), data.fps,
                      data.triangles.size()),
          fmt::format("gradus demo {}{}", demo.name, order.said),
          fingerprint(order.data.bytes) + " " + fingerprint(order.texture.bytes)};
}

Colophon of_frame(Colophon colophon, std::size_t i) {
  colophon.title += fmt::format(", frame {}", i);
  return colophon;
}

/// A frame, and its file where frames are kept.
struct Frame {
  Image image;
  std::string png;
};

/// Draws every frame once, puts its file beside its place and hands it on.
class Frames {
 public:
  Frames(const Order& order, const RoadFilm& film, const Colophon& colophon, Progress& progress,
         NewFiles& files)
      : order_(order), files_(files), ahead_(film.frames(), order.threads, [&](std::size_t i) {
          Frame frame{film.frame(i), ""};
          if (order.folder) frame.png = png_of(frame.image, of_frame(colophon, i));
          progress.finished(i, "");
          return frame;
        }) {}

  const Image& at(std::size_t i) {
    const Frame& frame = ahead_.at(i);
    if (order_.folder && i == kept_) {
      files_.add(frame_path(*order_.folder, i), frame.png, order_.replace);
      ++kept_;
    }
    return frame.image;
  }

 private:
  const Order& order_;
  NewFiles& files_;
  FramesAhead<Frame> ahead_;
  std::size_t kept_ = 0;
};

std::string film_of(Frames& frames, const RoadFilm& film, const Colophon& colophon) {
  FilmOptions options;
  options.fps = film.demo().fps;
  options.seconds_per_step = options.hold_last = 1.0 / options.fps;
  options.transition = 0;
  return film_bytes(
      FilmFormat::mp4, film.frames(), [&](std::size_t i) { return frames.at(i); }, options, colophon);
}

/// A strip alone needs five frames.
std::string strip(const Order& order, const RoadFilm& film, const Colophon& colophon) {
  const std::vector<std::size_t> shown = frames_in_strip(film.frames());
  std::vector<Image> pictures(shown.size());
  in_parallel(shown.size(), order.threads, [&](std::size_t k) { pictures[k] = film.frame(shown[k]); });
  return png_of(strip_of(pictures, film.is_double()), colophon);
}

void check_frames(const Order& order, const RoadFilm& film) {
  if (!order.folder) return;
  make_folder(*order.folder, "--frames");
  const std::vector<std::string> inputs{order.data.path, order.texture.path};
  for (std::size_t i = 0; i < film.frames(); ++i) {
    const std::string path = frame_path(*order.folder, i);
    if (order.replace == Replace::own) check_replaced(path, "--frames");
    check_output(path, inputs, Replace::anything);
  }
}

/// The bytes of the film or the strip, if there is to be one; frames go into `files`.
std::string drawn(const Order& order, const RoadFilm& film, NewFiles& files) {
  const Colophon colophon = colophon_of(order, film);
  std::string bytes = order.is_strip ? strip(order, film, colophon) : "";
  if (order.is_strip && !order.folder) return bytes;
  Progress progress(film.frames(), order.quiet);
  Frames frames(order, film, colophon, progress, files);
  if (order.output && !order.is_strip) return film_of(frames, film, colophon);
  for (std::size_t i = 0; i < film.frames(); ++i) frames.at(i);
  return bytes;
}

}  // namespace

int demo(const Request& request) {
  const Order order = order_of(request);
  const std::string& name = order.data.path;
  Image texture = decode_png(
      {reinterpret_cast<const std::uint8_t*>(order.texture.bytes.data()), order.texture.bytes.size()},
      order.texture.path, pipeline::most_texels);
  const RoadFilm film(pipeline::parse_road_demo(order.data.bytes, name), std::move(texture), order.which,
                      name);
  check_frames(order, film);
  NewFiles files;
  const std::string bytes = drawn(order, film, files);
  if (order.output && *order.output != dash) files.add(*order.output, bytes, order.replace);
  files.commit();
  if (order.output && *order.output == dash) write_output(*order.output, bytes);
  if (order.quiet) return 0;
  if (order.folder) note(fmt::format("{}: {} frames", shown_name(*order.folder), film.frames()));
  if (order.output && *order.output != dash) note(shown_name(*order.output));
  return 0;
}

}  // namespace gradus::cli
