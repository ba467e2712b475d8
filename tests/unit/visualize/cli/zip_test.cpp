#include "cli/files/zip.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "cli/command_line/errors.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

struct Temporary {
  Temporary() : folder(fs::temp_directory_path() / ("gradus-zip-" + std::to_string(getpid()))) {
    fs::create_directories(folder);
  }
  ~Temporary() { fs::remove_all(folder); }
  fs::path folder;
};

void write(const fs::path& path, std::string_view bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

/// What Python's zipfile finds, as "name size crc-is-right year-month-day hour method utf8-flag" a line.
std::string seen_by_python(const fs::path& zip) {
  const fs::path out = zip.string() + ".txt";
  const std::string script =
      "import sys,zipfile\n"
      "z=zipfile.ZipFile(sys.argv[1])\n"
      "assert z.testzip() is None\n"
      "for i in z.infolist():\n"
      "  d=z.read(i)\n"
      "  print(i.filename,len(d),sum(d)%1000,'%d-%d-%d'%i.date_time[:3],i.date_time[3],i.compress_type,"
      "oct(i.external_attr>>16),i.create_system)\n";
  write(zip.string() + ".py", script);
  const std::string command = "PYTHONIOENCODING=utf-8 " GRADUS_PYTHON " " + zip.string() + ".py " +
                              zip.string() + " > " + out.string();
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(out);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<ZipEntry> entries() {
  return {{"README.txt", "hello"},
          {"f\xc3\xbcllen/\xce\xb1.svg", std::string(100'000, 'a')},
          {"empty", ""},
          {"bytes.png", std::string("\0\1\2\377", 4)}};
}

class InZone {
 public:
  explicit InZone(const char* zone) {
    setenv("TZ", zone, 1);
    tzset();
  }
  ~InZone() {
    unsetenv("TZ");
    tzset();
  }
  InZone(const InZone&) = delete;
  InZone& operator=(const InZone&) = delete;
};

TEST(Zip, OthersReadIt) {
  const Temporary temporary;
  const fs::path zip = temporary.folder / "a.zip";
  const std::string bytes = zip_of(entries());
  EXPECT_LT(bytes.size(), 2000U) << "100,000 times the same letter is deflated";
  write(zip, bytes);
  EXPECT_EQ(seen_by_python(zip),
            "README.txt 5 532 1980-1-1 0 8 0o100644 3\n"
            "f\xc3\xbcllen/\xce\xb1.svg 100000 0 1980-1-1 0 8 0o100644 3\n"
            "empty 0 0 1980-1-1 0 8 0o100644 3\n"
            "bytes.png 4 258 1980-1-1 0 8 0o100644 3\n");
}

TEST(Zip, TheSameBytesInEveryZone) {
  const std::string here = zip_of(entries());
  for (const char* zone :
       {"UTC", "Pacific/Kiritimati", "Asia/Tokyo", "America/New_York", "Etc/GMT+12", "XYZ-14"}) {
    const InZone zoned(zone);
    EXPECT_EQ(zip_of(entries()), here) << zone;
  }
}

TEST(Zip, OtherEntriesGiveOtherBytes) {
  std::vector<ZipEntry> others = entries();
  others[0].bytes = "hallo";
  EXPECT_NE(zip_of(others), zip_of(entries()));
  std::swap(others[0], others[1]);
  EXPECT_NE(zip_of(others), zip_of(entries()));
}

TEST(Zip, WithoutEntries) {
  const Temporary temporary;
  write(temporary.folder / "none.zip", zip_of({}));
  EXPECT_EQ(seen_by_python(temporary.folder / "none.zip"), "");
}

TEST(Zip, AFolder) {
  const Temporary temporary;
  write(temporary.folder / "out/index.html", "<p>");
  write(temporary.folder / "out/line/line.svg", "<svg>");
  write(temporary.folder / "out/not wanted", "x");
  const fs::path zip = temporary.folder / "out.zip";
  zip_folder(temporary.folder / "out", {"index.html", "line/line.svg"}, zip.string());
  EXPECT_EQ(seen_by_python(zip),
            "index.html 3 234 1980-1-1 0 8 0o100644 3\nline/line.svg 5 458 1980-1-1 0 8 0o100644 3\n");
}

TEST(Zip, AFileThatIsNotThereLeavesNothing) {
  const Temporary temporary;
  const fs::path zip = temporary.folder / "out.zip";
  EXPECT_THROW(zip_folder(temporary.folder, {"index.html"}, zip.string()), UsageError);
  EXPECT_FALSE(fs::exists(zip));
}

TEST(StepEntries, NamesThatSortAndAReadme) {
  const std::vector<StepNumber> steps{{0, 0}, {4, 0}, {4, 1}, {11, 0}};
  const auto made = step_entries(
      "line", "A line", "gradus figure a_line", steps, {11, 0},
      [](StepNumber step) { return StepPicture{"svg " + text_of(step), "png " + text_of(step)}; });
  std::vector<std::string> names;
  for (const ZipEntry& entry : made) names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"README.txt", "line-00.svg", "line-00.png", "line-04.svg",
                                             "line-04.png", "line-04.1.svg", "line-04.1.png", "line-11.svg",
                                             "line-11.png"}));
  EXPECT_EQ(made[5].bytes, "svg 4.1");
  EXPECT_EQ(made[8].bytes, "png 11");
  EXPECT_NE(made[0].bytes.find("A line\n"), std::string::npos);
  EXPECT_NE(made[0].bytes.find("gradus figure a_line"), std::string::npos);
  EXPECT_NE(made[0].bytes.find("4 of the 12 steps"), std::string::npos);
}

TEST(StepEntries, AllSteps) {
  const std::vector<StepNumber> steps{{0, 0}, {1, 0}};
  const auto made = step_entries("line", "A line", "gradus figure a_line", steps, {1, 0},
                                 [](StepNumber) { return StepPicture{}; });
  EXPECT_EQ(made.size(), 5U);
  EXPECT_NE(made[0].bytes.find("All 2 steps"), std::string::npos);
}

}  // namespace
}  // namespace gradus::cli
