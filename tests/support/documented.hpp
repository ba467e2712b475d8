#pragma once
// Numbers that documents claim, computed: a test reads them where they stand and compares them with what it
// finds itself. docs/claims.csv lists them; the architecture test of it reads the calls of states() in the
// tests.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace gradus::test {

/// A document on one line: each blank and each end of a line is one blank, the marks of C++'s comments are
/// gone.
inline std::string on_one_line(const std::string& document) {
  std::ifstream in(GRADUS_SOURCE_DIR "/" + document);
  std::string text, line, word;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    for (bool first = true; words >> word; first = false) {
      if (first && (word == "//" || word == "///")) continue;
      if (!text.empty()) text += ' ';
      text += word;
    }
  }
  return text;
}

/// A number as documents print it: 13,126 or .0453 or 2.1e-16, and what its last digit is worth.
struct Printed {
  std::string text;
  double value = 0, unit = 1;
};
inline Printed printed_at(std::string_view text) {
  Printed number;
  std::string digits;
  std::size_t at = 0;
  const auto digit = [&](std::size_t i) { return i < text.size() && '0' <= text[i] && text[i] <= '9'; };
  bool point = false;
  for (; digit(at) || (at < text.size() && (text[at] == ',' || text[at] == '.') && digit(at + 1)); ++at) {
    if (text[at] == ',') continue;
    if (point && text[at] != '.') number.unit /= 10;
    point = point || text[at] == '.';
    digits += text[at];
  }
  const bool negative = text.substr(at).starts_with("e-");
  if (at > 0 && text.substr(at).starts_with('e') && digit(at + (negative ? 2 : 1))) {
    const std::size_t from = at++;
    while (++at, digit(at)) {
    }
    digits += text.substr(from, at - from);
    number.unit *=
        std::pow(10.0, std::strtod(std::string(text.substr(from + 1, at - from - 1)).c_str(), nullptr));
  }
  number.text = text.substr(0, at);
  number.value = std::strtod(digits.c_str(), nullptr);
  return number;
}

/// Whether a document (a path in the repository) says this text, once, with the numbers that were found where
/// the text has {}, each rounded to as many digits as stand there.
inline ::testing::AssertionResult states(const std::string& document, std::string_view text,
                                         std::initializer_list<double> found) {
  const std::string whole = on_one_line(document);
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from != std::string_view::npos;) {
    const std::size_t hole = text.find("{}", from);
    parts.push_back(text.substr(from, hole == std::string_view::npos ? hole : hole - from));
    from = hole == std::string_view::npos ? hole : hole + 2;
  }
  if (parts.size() != found.size() + 1)
    return ::testing::AssertionFailure() << "as many {} as numbers: " << text;
  std::vector<std::vector<Printed>> places;
  for (std::size_t at = whole.find(parts[0]); at != std::string::npos; at = whole.find(parts[0], at + 1)) {
    std::vector<Printed> numbers;
    std::size_t end = at + parts[0].size();
    for (std::size_t k = 1; k < parts.size(); ++k) {
      const Printed number = printed_at(std::string_view(whole).substr(end));
      end += number.text.size();
      if (number.text.empty() || !std::string_view(whole).substr(end).starts_with(parts[k])) break;
      end += parts[k].size();
      numbers.push_back(number);
    }
    if (numbers.size() == found.size()) places.push_back(numbers);
    if (parts[0].empty()) return ::testing::AssertionFailure() << "a text begins with a word: " << text;
  }
  if (places.size() != 1) {
    return ::testing::AssertionFailure()
           << document << " says " << places.size() << " times, not once: " << text;
  }
  auto wrong = ::testing::AssertionFailure() << document << ": " << text;
  bool right = true;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Printed& number = places[0][k];
    const double is = *(found.begin() + static_cast<std::ptrdiff_t>(k));
    const bool same = std::abs(is - number.value) <= 0.5000001 * number.unit;
    right = right && same;
    wrong << "\n  " << number.text << (same ? " is right, " : " is wrong, ")
          << "found: " << ::testing::PrintToString(is);
  }
  return right ? ::testing::AssertionSuccess() : wrong;
}

}  // namespace gradus::test
