// Scenes as commands run them, `explain`, `render --why` and `render`: whatever a file says, it is drawn and
// told, or refused in one line. What the work itself throws is a mistake of ours.

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "cli/commands/explain.hpp"
#include "cli/commands/render.hpp"
#include "core/refusal.hpp"
#include "plan/planned.hpp"
#include "support/fuzz_input.hpp"
#include "why/why.hpp"
#include "why/why_text.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, std::string_view text) {
  std::ofstream(file, std::ios::binary) << text;
  require(fs::file_size(file) == text.size(), "the input is there");
}

/// A folder with models, whose scene each input is.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "gradus-scenes-XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr, "a folder can be made");
    path_ = name;
    write(path_ / "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    write(path_ / "g.obj",
          "mtllib g.mtl\nusemtl g\nv -1 -1 0.2\nv 1 -1 0.2\nv 1 1 0.3\nv -1 1 0.3\nf 1 2 3 4\n");
    write(path_ / "g.mtl", "newmtl g\nKd 0.2 0.6 0.3\nKs 0.5 0.5 0.5\nNs 9\nd 0.5\n");
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  fs::path scene() const { return path_ / "s.json"; }

 private:
  fs::path path_;
};

/// What takes its time and is no mistake.
bool is_much(const pipeline::Scene& scene) {
  return pipeline::lamps_told(scene) > 400 || scene.objects.size() > 40;
}

void run(const fs::path& file) {
  const cli::Request request = cli::read_request({"render", file.string(), "--size", "12x9"});
  const cli::RenderJob job = cli::render_job(request);
  if (is_much(job.scene)) return;
  pipeline::Plan plan = plan_of(job.scene, job.size, job.plan.rules, job.plan.part);
  pipeline::Ledger ledger;
  geometry(job.scene, plan, ledger);
  require(!cli::plan_text("s", job.scene, plan, job.path).empty(), "a plan is told");
  for (const ivec2 pixel : {ivec2{0, 0}, ivec2{6, 4}, ivec2{7, 5}})
    require(!why_text("s", job.scene, job.size, why(job.scene, job.size, pixel)).empty(), "a pixel is told");
  require(!cli::rendered(request).png.empty(), "a picture is drawn");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  write(folder.scene(), std::string_view(reinterpret_cast<const char*>(data), size));
  try {
    run(folder.scene());
  } catch (const InputError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  } catch (const UsageError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  }
  return 0;
}
