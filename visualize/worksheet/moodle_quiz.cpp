#include "worksheet/moodle_quiz.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "figure/text/metrics.hpp"

namespace gradus::worksheet {
namespace {

std::string replaced_all(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// For HTML and XML alike.
std::string markup_escaped(std::string_view text) {
  std::string out;
  for (const char32_t c : code_points(text)) {
    switch (c) {
      case U'&':
        out += "&amp;";
        break;
      case U'<':
        out += "&lt;";
        break;
      case U'>':
        out += "&gt;";
        break;
      case U'"':
        out += "&quot;";
        break;
      default:
        out +=
            utf8_of(std::u32string(1, c < U' ' || c == 0x7f || c == 0xfffe || c == 0xffff ? U'\ufffd' : c));
    }
  }
  return out;
}

/// Text of a question outside its answers: a brace would begin one.
std::string html_of(std::string_view text) {
  return replaced_all(replaced_all(markup_escaped(text), "{", "&#123;"), "}", "&#125;");
}

/// An answer inside a field. Signs that end it get a backslash; a star would stand for anything.
std::string field_escaped(std::string_view answer) {
  std::string out;
  for (const char c : markup_escaped(answer)) {
    if (std::string_view("\\}#~*/").find(c) != std::string_view::npos && c != '/') out += '\\';
    out += c;
  }
  return out;
}

constexpr bool is_ascii_digit(char c) { return '0' <= c && c <= '9'; }

/// "-12" of "−12"; empty for what is no whole number, and for digits with zeros in front.
std::string whole_number_of(const std::string& answer) {
  const std::string plain = replaced_all(answer, "−", "-");
  const std::string digits = plain.starts_with('-') ? plain.substr(1) : plain;
  const bool code = digits.size() > 1 && digits[0] == '0';
  if (digits.empty() || code || !std::ranges::all_of(digits, is_ascii_digit)) return "";
  return plain;
}

/// "7/12" as "0.583"; empty for what is no fraction.
std::string decimal_of(const std::string& plain) {
  const std::size_t slash = plain.find('/');
  if (slash == std::string::npos) return "";
  const std::string above = plain.substr(0, slash), below = plain.substr(slash + 1);
  if (whole_number_of(above).empty() || whole_number_of(below).empty() || below == "0") return "";
  return fmt::format("{:.3f}", std::strtod(above.c_str(), nullptr) / std::strtod(below.c_str(), nullptr));
}

/// "-3*sqrt(2)/4" of "-3√2/4", as it can be typed, and its value; empty for what has no root in it.
struct TypedRoot {
  std::string text{}, decimal{};
};
TypedRoot typed_root_of(const std::string& plain) {
  constexpr std::string_view sign = "√";
  const std::size_t at = plain.find(sign);
  if (at == std::string::npos) return {};
  const std::string before = plain.substr(0, at), behind = plain.substr(at + sign.size());
  const std::size_t slash = std::min(behind.find('/'), behind.size());
  const std::string under = behind.substr(0, slash),
                    below = slash < behind.size() ? behind.substr(slash + 1) : "1";
  const bool alone = before.empty() || before == "-";
  const std::string factor = alone ? before + "1" : before;
  for (const std::string& number : {factor, under, below}) {
    if (whole_number_of(number).empty() || number == "0") return {};
  }
  const double root = std::sqrt(std::strtod(under.c_str(), nullptr));
  return {fmt::format("{}{}sqrt({}){}", before, alone ? "" : "*", under, behind.substr(slash)),
          fmt::format("{:.3f}",
                      std::strtod(factor.c_str(), nullptr) * root / std::strtod(below.c_str(), nullptr))};
}

/// Without spaces behind and before signs: "(3,1)" of "(3, 1)".
std::string without_spaces(std::string text) {
  text = replaced_all(std::move(text), "\u00a0", " ");
  for (const std::string_view sign : {",", ";", "<", ">", "="}) {
    text = replaced_all(replaced_all(std::move(text), std::string(sign) + " ", sign), " " + std::string(sign),
                        sign);
  }
  return text;
}

/// All that is right, the answer itself first.
std::vector<std::string> right_answers(const std::string& answer) {
  std::vector<std::string> right;
  const auto add = [&right](const std::string& text) {
    if (!text.empty() && std::ranges::find(right, text) == right.end()) right.push_back(text);
  };
  const std::string shown = replaced_all(answer, "\u00a0", " "), plain = replaced_all(shown, "−", "-");
  for (const std::string& text : {shown, plain, without_spaces(plain), without_spaces(shown)}) add(text);
  const bool number = !plain.empty() && plain.find_first_not_of("-0123456789.,") == std::string::npos;
  if (number) {
    for (const std::string_view point : {".", ","}) {
      add(replaced_all(replaced_all(plain, ".", point), ",", point));
    }
  }
  const TypedRoot root = typed_root_of(plain);
  add(root.text);
  for (const std::string& decimal : {decimal_of(plain), root.decimal}) {
    add(decimal);
    add(replaced_all(decimal, ".", ","));
  }
  return right;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      word = word << 8 | (i < have ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      out += i <= have ? alphabet[word >> (18 - 6 * i) & 63] : '=';
    }
  }
  return out;
}

/// CDATA can't hold its own end.
std::string cdata(const std::string& text) {
  return "<![CDATA[" + replaced_all(text, "]]>", "]]]]><![CDATA[>") + "]]>";
}

/// Marks of the blanks, row by row: as small as whole numbers can be that stand to one another as the points.
std::vector<int> marks_of(const Task& task) {
  std::vector<int> shares;  // of a row's points, for one of its blanks, over a common denominator
  const std::vector<ExerciseRow>& rows = task.variant->exercise.rows;
  int common = 1;
  for (const ExerciseRow& row : rows) common = std::lcm(common, std::max(1, row.blanks()));
  int divisor = 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int blanks = rows[r].blanks();
    shares.push_back(blanks > 0 ? task.worth.rows[r].parts * (common / blanks) : 0);
    divisor = std::gcd(divisor, shares.back());
  }
  for (int& share : shares) share /= std::max(1, divisor);
  return shares;
}

std::string table_html(const Task& task) {
  const Exercise& exercise = task.variant->exercise;
  std::string out = "<table border=\"1\" cellpadding=\"4\">\n<thead><tr>";
  for (const Column& column : exercise.trace->columns) out += "<th>" + html_of(column.name) + "</th>";
  out += "</tr></thead>\n<tbody>\n";
  const std::vector<int> marks = marks_of(task);
  for (std::size_t r = 0; r < exercise.rows.size(); ++r) {
    const ExerciseRow& row = exercise.rows[r];
    out += "<tr>";
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      const std::string& cell = row.cells[c];
      const std::string shown = cell.empty() ? "–" : html_of(cell);
      out += "<td>" + (row.asked[c] ? embedded_answer(cell, marks[r]) : shown) + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

std::string question(const StudentSheet& sheet, std::size_t number, std::size_t count, Reckoning reckoning,
                     const DrawPng& draw) {
  const Task& task = sheet.tasks[number];
  const Trace& trace = *task.variant->exercise.trace;
  const Wording& wording = trace.wording;
  const std::string whose = sheet.student.empty() ? fmt::format("{:03}", count) : sheet.student;
  const std::string file = fmt::format("{}_{:03}.png", task.topic->name, count);
  std::string html = "<p>" + html_of(trace.goal) + "</p>\n";
  if (!trace.faulty.empty()) {
    html += "<p><strong>" + html_of(wording.say("figure.faulty", fmt::arg("what", trace.faulty))) +
            "</strong></p>\n";
  }
  html += "<p><strong>" +
          html_of(wording.say("worksheet.input", fmt::arg("input", trace.subtitle),
                              fmt::arg("method", trace.method_title))) +
          "</strong><br><code>" + html_of(fmt::format("{}", fmt::join(given_arguments(task), " · "))) +
          "</code></p>\n<p>" + html_of(filling_text(task, reckoning)) + "</p>\n";
  if (draw) {
    html += fmt::format("<p><img src=\"@@PLUGINFILE@@/{}\" alt=\"{}\"></p>\n", file,
                        html_of(trace.title + " " + trace.subtitle));
  }
  html += table_html(task);
  std::string out = fmt::format("  <question type=\"cloze\">\n    <name><text>{}</text></name>\n",
                                markup_escaped(trace.title + ": " + whose));
  out += "    <questiontext format=\"html\">\n      <text>" + cdata(html) + "</text>\n";
  if (draw) {
    out += fmt::format("      <file name=\"{}\" path=\"/\" encoding=\"base64\">{}</file>\n", file,
                       base64(draw(task)));
  }
  return out +
         "    </questiontext>\n    <generalfeedback format=\"html\"><text></text></generalfeedback>\n"
         "    <penalty>0.3333333</penalty>\n    <hidden>0</hidden>\n  </question>\n";
}

}  // namespace

std::string embedded_answer(const std::string& answer, int mark) {
  if (const std::string number = whole_number_of(answer); !number.empty()) {
    return fmt::format("{{{}:NUMERICAL:={}:0}}", mark, number);
  }
  std::string field = fmt::format("{{{}:SHORTANSWER:", mark);
  const std::vector<std::string> right = right_answers(answer);
  for (std::size_t i = 0; i < right.size(); ++i) field += (i == 0 ? "=" : "~=") + field_escaped(right[i]);
  return field + "}";
}

std::string moodle_quiz(const std::vector<StudentSheet>& sheets, Reckoning reckoning, const DrawPng& draw) {
  std::string out = "<quiz>\n";
  for (std::size_t i = 0; i < sheets.front().tasks.size(); ++i) {
    out += fmt::format(
        "  <question type=\"category\">\n    <category><text>$course$/Gradus/{}</text></category>\n"
        "  </question>\n",
        markup_escaped(replaced_all(sheets.front().tasks[i].variant->exercise.trace->title, "/", "//")));
    for (std::size_t k = 0; k < sheets.size(); ++k) out += question(sheets[k], i, k + 1, reckoning, draw);
  }
  return out + "</quiz>\n";
}

}  // namespace gradus::worksheet
