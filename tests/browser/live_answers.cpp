// What the module of live pages should answer, by the same code in an ordinary program.
//
//   live_answers --draw COUNT SEED [TOPIC]   prints requests, one per line: COUNT seeded ones per topic
//   live_answers [FILE]…                     opens the files, PNG or text, and answers the requests of its
//                                            input, one per line: "answer" or "refused", how many bytes, a
//                                            line end, and those bytes

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

#include "browser/live_requests.hpp"
#include "core/image.hpp"
#include "core/shown.hpp"
#include "live/files.hpp"
#include "live/protocol.hpp"
#include "request/complaint.hpp"

namespace {

using namespace gradus;

void draw(std::size_t count, std::uint64_t seed, std::string_view only) {
  for (const TopicEntry* topic : catalogue()) {
    if (!only.empty() && topic->name != only) continue;
    for (const std::string& request : test::LiveRequests(*topic, seed).drawn(count))
      std::cout << request << '\n';
  }
}

void tell(std::string_view kind, std::string_view text) {
  std::cout << kind << ' ' << text.size() << '\n' << text << std::flush;
}

void open(live::OpenedFiles& files, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  files.keep(path, {std::istreambuf_iterator<char>(file), {}});
  if (path.ends_with(".png")) files.keep_picture(path, read_png(path));
}

void answer_all(live::OpenedFiles& files) {
  for (std::string request; std::getline(std::cin, request);) {
    try {
      tell("answer", live::answer(request, files));
    } catch (const ArgumentError& error) {
      tell("refused", on_one_line(complaint_of(error)));
    } catch (const std::exception& error) {
      tell("refused", on_one_line(error.what()));
    }
  }
}

}  // namespace

int main(int count, char** words) {
  if (count > 3 && std::string_view(words[1]) == "--draw") {
    draw(std::strtoul(words[2], nullptr, 10), std::strtoull(words[3], nullptr, 0), count > 4 ? words[4] : "");
    return 0;
  }
  live::OpenedFiles files;
  for (int i = 1; i < count; ++i) open(files, words[i]);
  answer_all(files);
}
