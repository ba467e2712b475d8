// The textbook's form of a listing: what each construct becomes. (golden/listing holds all listings there are
// to it.)

#include <gtest/gtest.h>

#include "figure/listing/pseudocode.hpp"

namespace gradus {
namespace {

std::vector<SourceLine> numbered(const std::vector<std::string>& texts) {
  std::vector<SourceLine> lines;
  for (std::size_t i = 0; i < texts.size(); ++i) lines.push_back({10 + static_cast<int>(i), texts[i]});
  return lines;
}

/// The lines of the result, a bar between them.
std::string written(const std::vector<std::string>& source) {
  std::string text;
  for (const SourceLine& line : pseudocode(numbered(source))) text += (text.empty() ? "" : "|") + line.text;
  return text;
}

TEST(Pseudocode, WritesValuesAndConditionsAsATextbookDoes) {
  EXPECT_EQ(written({"std::int64_t p = 2 * dy - dx;"}), "p ← 2 · dy - dx");
  EXPECT_EQ(written({"p += 2 * (dy - dx);  // NE"}), "p ← p + 2 · (dy - dx)  // NE");
  EXPECT_EQ(written({"rest -= a + b;"}), "rest ← rest - (a + b)");
  EXPECT_EQ(written({"++x;"}), "x ← x + 1");
  EXPECT_EQ(written({"if (p < 0 || (p == 0 && !tie)) {"}), "if p < 0 or (p = 0 and not tie) then");
  EXPECT_EQ(written({"*next++ = texel(x, y);"}), "next ← texel(x, y), next ← next + 1");
  EXPECT_EQ(written({"if (++cuts > 4) break;"}), "if (cuts ← cuts + 1) > 4 then break");
  EXPECT_EQ(written({"const auto [dx, dy] = extent(from, to);"}), "[dx, dy] ← extent(from, to)");
  EXPECT_EQ(written({"Code& code = of_a ? code_a : code_b;"}), "code ← if of_a then code_a else code_b");
  EXPECT_EQ(written({"return std::nullopt;"}), "return nothing");
  EXPECT_EQ(written({"return std::move(kept.polygon);"}), "return kept.polygon");
  EXPECT_EQ(written({"const glm::vec<3, T> ndc{x, y, z};"}), "ndc ← [x, y, z]");
  EXPECT_EQ(written({"Kept<T> kept(border, std::move(room));"}), "kept ← Kept(border, room)");
  EXPECT_EQ(written({"std::optional<Segment<2, T>> kept;"}), "kept ← nothing");
  EXPECT_EQ(written({"last = &now;", "was = side(*last);"}), "last ← now|was ← side(last)");
  EXPECT_EQ(written({"const bool in = holds(edges, e);"}), "in ← holds(edges, e)");
  EXPECT_EQ(written({"T enter = T(0), leave = T(1);"}), "enter ← 0, leave ← 1");
}

TEST(Pseudocode, WritesABraceOfOneValueAsTheValue) {
  EXPECT_EQ(written({"T sum{0};"}), "sum ← 0");
  EXPECT_EQ(written({"Int d = Int(to[lead]) - T(a + b) * T{2};"}), "d ← to[lead] - (a + b) · 2");
  EXPECT_EQ(written({"path.push({seed});"}), "path.push(seed)");
  EXPECT_EQ(written({"std::vector<Turn> turns{root_of(tree)};"}), "turns ← root_of(tree)");
  EXPECT_EQ(written({"if (!(area > T{0})) continue;"}), "if not (area > 0) then continue");
  EXPECT_EQ(written({"n = std::max(n, std::int64_t{std::ssize(list)});"}), "n ← max(n, ssize(list))");
}

TEST(Pseudocode, WritesAnAssignmentForEachDeclaredName) {
  EXPECT_EQ(written({"Vec diffuse{T(0)}, specular{T(0)};"}), "diffuse ← 0, specular ← 0");
  EXPECT_EQ(written({"const T s(0.75), t(0.25);"}), "s ← 0.75, t ← 0.25");
  EXPECT_EQ(written({"Colour sum(0);"}), "sum ← 0");
  EXPECT_EQ(written({"const ivec2 a(x, y), b{y, x};"}), "a ← [x, y], b ← [y, x]");
  EXPECT_EQ(written({"Polygon half, row;"}), "half ← empty Polygon, row ← empty Polygon");
  EXPECT_EQ(written({"std::vector<int> ring;"}), "ring ← empty list");
  EXPECT_EQ(written({"std::optional<T> low, high;"}), "low ← nothing, high ← nothing");
  EXPECT_EQ(written({"Row& a = f(x, y), &b = rows[g(x, y)];"}), "a ← f(x, y), b ← rows[g(x, y)]");
  EXPECT_EQ(written({"const int n = ranges(a, b).size();"}), "n ← ranges(a, b).size()");
}

TEST(Pseudocode, WritesTuplesInBracketsOfTheirOwn) {
  EXPECT_EQ(written({"const dvec2 across{-along.y, along.x};"}), "across ← [-along.y, along.x]");
  EXPECT_EQ(written({"plot(ivec2{x, y}, centre_of({x, y}));"}), "plot([x, y], centre_of([x, y]))");
  EXPECT_EQ(written({"turns.push_back({near_side(node, side), true});"}),
            "turns.push_back([near_side(node, side), true])");
  EXPECT_EQ(written({"return {x, y};"}), "return [x, y]");
  EXPECT_EQ(written({"return {};"}), "return nothing");
  EXPECT_EQ(written({"return Segment{a.at, b.at};"}), "return Segment(a.at, b.at)");
  EXPECT_EQ(written({"Lists lists(empty ? Window{} : window);"}),
            "lists ← Lists(if empty then Window() else window)");
  EXPECT_EQ(written({"const ivec2 grid(n);"}), "grid ← ivec2(n)");
  EXPECT_EQ(written({"for (auto [a, b] : edges(points)) {"}), "for each [a, b] in edges(points) do");
  EXPECT_EQ(written({"const Vec normals[]{", "    cross(y, z),", "    cross(z, x)};", "x = 1;"}),
            "normals ← [|    cross(y, z),|    cross(z, x)]|x ← 1");
}

TEST(Pseudocode, NamesTheFunctionsInsideOfFunctions) {
  EXPECT_EQ(written({"const auto visit = [&](ivec2 p) {", "  plot(p);", "};", "x = 1;"}),
            "function visit(p)|  plot(p)|x ← 1");
  EXPECT_EQ(written({"auto twice = [](T x) { return 2 * x; };"}), "twice(x) ← 2 · x");
  EXPECT_EQ(written({"const auto draw = [&] { plot(p); };"}), "draw() ← plot(p)");
  EXPECT_EQ(written({"sort_by(list, [&](auto& p) { return mean(p).z; });"}),
            "sort_by(list, (p) → mean(p).z)");
  EXPECT_EQ(written({"sort_by(list, [&](auto& p) {", "  return mean(p).z;", "});"}),
            "sort_by(list, (p) →|  return mean(p).z|)");
}

TEST(Pseudocode, PutsACommentInsideAStatementBehindIt) {
  EXPECT_EQ(written({"auto a =  // what arrives", "    lamp.at(place);", "x = 1;  // then"}),
            "a ←|    lamp.at(place)  // what arrives|x ← 1  // then");
  EXPECT_EQ(written({"f(a,  // first", "  b);  // second"}), "f(a,|  b)  // first second");
}

TEST(Pseudocode, WritesLoopsAndBranches) {
  EXPECT_EQ(written({"while (pixel != to) {", "  plot(pixel);", "}"}), "while pixel ≠ to do|  plot(pixel)");
  EXPECT_EQ(written({"for (int i = 0; i < n; ++i) {"}), "for i ← 0 to n - 1 do");
  EXPECT_EQ(written({"for (int i = 0; i < 4; ++i) {"}), "for i ← 0 to 3 do");
  EXPECT_EQ(written({"for (std::int64_t k = 1; k <= dx; ++k) {"}), "for k ← 1 to dx do");
  EXPECT_EQ(written({"for (int k = 1; 2 * k <= n; ++k) {"}), "for k ← 1, 2, … while 2 · k ≤ n do");
  EXPECT_EQ(written({"for (auto k = factors.size(); k-- > 0;) {"}),
            "for k ← factors.size() - 1 down to 0 do");
  EXPECT_EQ(written({"for (const Vertex<T>& now : polygon) {"}), "for each now in polygon do");
  EXPECT_EQ(written({"do {", "  step();", "} while (!done[entry]);"}), "repeat|  step()|until done[entry]");
  EXPECT_EQ(written({"if (a) {", "  x = 1;", "} else if (b) {", "  x = 2;", "} else {", "  x = 3;", "}"}),
            "if a then|  x ← 1|else if b then|  x ← 2|else|  x ← 3");
}

TEST(Pseudocode, KeepsTheNumbersOfLines) {
  const auto lines = pseudocode(numbered({"if (a) {", "  x = 1;", "}", "// so far", "return x;"}));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].number, 11);
  EXPECT_EQ(lines[2].number, 13);
  EXPECT_EQ(lines[2].text, "// so far");
}

}  // namespace
}  // namespace gradus
