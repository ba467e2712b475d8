// The same calls of topics of every chapter, compiled for the project's headers and for plain ones; no guard:
// it is included twice, the second time with another name for gradus. tests/golden/source_test.py compares
// the answers.

namespace gradus::runs {

/// Every number that a run gave, in order.
using Answers = std::vector<double>;

/// Seeded inputs: the same for both.
struct Dice {
  gradus::Random random;
  int whole(int least, int most) {
    return least + static_cast<int>(random() % static_cast<std::uint64_t>(most - least + 1));
  }
  /// Eighths, so that corners meet borders and one another, too.
  double eighth() { return whole(-64, 64) / 8.0; }
  double real() { return static_cast<double>(random() >> 11) * 0x1p-53 * 16 - 8; }
  ivec2 cell(int far) { return {whole(-far, far), whole(-far, far)}; }
  dvec2 point() { return whole(0, 1) ? dvec2{eighth(), eighth()} : dvec2{real(), real()}; }
  dvec3 place() { return {real(), real(), real()}; }
};

inline void keep(Answers& to, double x) { to.push_back(x); }
inline void keep(Answers& to, ivec2 p) { to.insert(to.end(), {double(p.x), double(p.y)}); }
inline void keep(Answers& to, dvec2 p) { to.insert(to.end(), {p.x, p.y}); }
inline void keep(Answers& to, dvec3 p) { to.insert(to.end(), {p.x, p.y, p.z}); }
template <int C, int R, class T>
void keep(Answers& to, const glm::mat<C, R, T>& m) {
  for (int c = 0; c < C; ++c) {
    for (int r = 0; r < R; ++r) to.push_back(m[c][r]);
  }
}

inline void line(Dice& dice, Answers& to) {
  const auto plot = [&](ivec2 p) { keep(to, p); };
  const ivec2 a = dice.cell(40), b = dice.cell(40);
  bresenham_line::decision_parameter(a, b, plot);
  bresenham_line::in_window(a, b, Window{{-9, -9}, {9, 9}}, plot);
  bresenham_line::dda(a, b, plot);
  bresenham_line::run_length(a, b, [&](ivec2 p, std::int64_t n) { keep(to, p), keep(to, double(n)); });
  Raster<int> raster(20, 20, 0);
  bresenham_line::draw(raster, a, b, 1);
  for (const int cell : raster.cells()) keep(to, double(cell));
}

inline void smooth_line(Dice& dice, Answers& to) {
  const auto plot = [&](ivec2 p, auto share) { keep(to, p), keep(to, double(share)); };
  const ivec2 a = dice.cell(20), b = dice.cell(20);
  antialiased_line::wu(a, b, plot);
  antialiased_line::gupta_sproull(a, b, plot);
  antialiased_line::exact_area(a, b, plot);
}

inline void circle(Dice& dice, Answers& to) {
  bresenham_circle::decision_parameter(dice.cell(9), dice.whole(0, 30), [&](ivec2 p) { keep(to, p); });
}

inline void fill(Dice& dice, Answers& to) {
  for (const auto method :
       {flood_fill::Method::depth_first, flood_fill::Method::breadth_first, flood_fill::Method::span}) {
    Raster<int> raster(12, 9, 0);
    for (int i = 0; i < 40; ++i) raster[{dice.whole(0, 11), dice.whole(0, 8)}] = 1;
    const auto filled =
        flood_fill::fill_raster(raster, ivec2{dice.whole(0, 11), dice.whole(0, 8)}, 2, method);
    for (const int cell : raster.cells()) keep(to, double(cell));
    (void)filled;
  }
}

inline void affine(Dice& dice, Answers& to) {
  const std::vector<affine_2d::Factor<double>> factors{
      affine_2d::rotation(turn_degrees(dice.real()), dice.point()), affine_2d::translation(dice.point()),
      affine_2d::scaling(dice.point())};
  std::vector<dvec2> points{dice.point(), dice.point()}, others = points;
  keep(to, affine_2d::one_matrix<double>(factors, points));
  affine_2d::factor_by_factor<double>(factors, others);
  for (const dvec2 p : points) keep(to, p);
  for (const dvec2 p : others) keep(to, p);
}

inline void view(Dice& dice, Answers& to) {
  const Frame<double> frame = viewing::look_at(dice.place(), dice.place(), dvec3{0, 1, 0});
  for (const dvec3 v : {frame.eye, frame.right, frame.up, frame.forward}) keep(to, v);
}

template <class Clipped>
void keep_segment(Answers& to, const Clipped& clipped) {
  keep(to, clipped ? 1.0 : 0.0);
  if (clipped) keep(to, clipped->a), keep(to, clipped->b);
}

inline void clip_line(Dice& dice, Answers& to) {
  const Segment<2, double> line{dice.point(), dice.point()};
  const Rectangle<double> window{{-4, -3}, {4, 3}};
  keep_segment(to, cohen_sutherland_2d::cut_of_a_cut(line, window));
  keep_segment(to, cohen_sutherland_2d::correctly_rounded(line, window));
  keep_segment(to, liang_barsky::parametric(line, window));
  keep_segment(to, liang_barsky::correctly_rounded(line, window));
}

inline void clip_polygon(Dice& dice, Answers& to) {
  // Round the origin, so that no two edges cross
  std::vector<dvec2> polygon;
  for (const dvec2 way : {dvec2{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}})
    polygon.push_back(way * (dice.whole(1, 64) / 8.0));
  const Rectangle<double> window{{-4, -3}, {4, 3}};
  for (const auto& vertex : sutherland_hodgman::clip_to_window(polygon, window)) keep(to, vertex.at);
  sutherland_hodgman::Polygons<float> floats, clipped;
  floats.add(std::vector<glm::vec2>(polygon.begin(), polygon.end()));
  floats.add(
      std::vector<glm::vec2>{glm::vec2(dice.place()), glm::vec2(dice.place()), glm::vec2(dice.place())});
  sutherland_hodgman::BatchClipper<float>{}(floats, {{-4, -3}, {4, 3}}, clipped);
  for (const std::uint32_t end : clipped.ends) keep(to, double(end));
  for (const glm::vec2 p : clipped.points) keep(to, dvec2(p));
  for (const auto& ring : polygon_circle::arcs(polygon, Circle<double>{{0.5, 0.25}, 5}).rings) {
    for (const auto& corner : ring) keep(to, corner.at), keep(to, corner.arc + 2.0 * corner.more_than_half);
  }
}

inline void order_faces(Dice& dice, Answers& to) {
  std::vector<bsp_tree::Polygon<double>> faces;
  for (std::size_t f = 0; f < 6; ++f)
    faces.emplace_back(std::vector<dvec3>{dice.place(), dice.place(), dice.place()}, f);
  const auto tree = bsp_tree::build(faces);
  bsp_tree::back_to_front(tree, bsp_tree::Eye<double>{1, 2, 30, 1},
                          [&](const bsp_tree::Polygon<double>& part) {
                            keep(to, double(part.face));
                            for (const dvec3 corner : part.corners) keep(to, corner);
                          });
}

inline void light(Dice& dice, Answers& to) {
  const illumination::Reflectance<double> grey{
      .ambient = dvec3{0.1}, .diffuse = dvec3{0.7}, .specular = dvec3{0.2}, .shininess = 10};
  const Light lamp{.position = dice.place()};
  const std::span<const Light> lamps(&lamp, 1);
  keep(to, illumination::phong(dice.place(), dvec3{0, 0, 1}, dice.place(), grey, lamps, dvec3{1}).sum());
  const illumination::AllSeen seen;
  keep(to, illumination::blinn_phong(dice.place(), dvec3{0, 0, 1}, dice.place(), grey, lamps, dvec3{1}, seen)
               .sum());
}

inline void shade(Dice& dice, Answers& to) {
  const std::vector<polygon_shading::Corner<double, dvec3>> corners{
      {dice.point(), {1, 0, 0}}, {dice.point(), {0, 1, 0}}, {dice.point(), {0, 0, 1}}};
  polygon_shading::gouraud<double, dvec3>(corners, Window{{-9, -9}, {9, 9}},
                                          [&](ivec2 p, dvec3 colour) { keep(to, p), keep(to, colour); });
}

inline void scatter(Dice& dice, Answers& to) {
  std::vector<dvec2> samples(static_cast<std::size_t>(dice.whole(1, 30)));
  jittered::jittered(samples, Random(dice.random()));
  for (const dvec2 p : samples) keep(to, p);
  jittered::uniform(samples, Random(dice.random()));
  for (const dvec2 p : samples) keep(to, p);
  poisson_disc::bridson({.size = dvec2{3, 2}}, 0.4, 30, Random(dice.random()), [&](dvec2 p) { keep(to, p); });
  keep(to, sampling_theorem::alias_of(dice.real() * 100, 44.0));
}

/// A caller's mistake: 1 where it is refused with these words.
inline double refusal() {
  try {
    bresenham_line::pixel_at({0, 0}, {7, 3}, 9);
  } catch (const ContractViolation& mistake) {
    return std::string_view(mistake.what()) == "this line has pixels 0 to 7, there is no pixel 9" ? 1 : 2;
  }
  return 0;
}

struct Run {
  const char* name;
  void (*call)(Dice&, Answers&);
};
inline constexpr Run all[] = {{"bresenham_line", line},
                              {"antialiased_line", smooth_line},
                              {"bresenham_circle", circle},
                              {"flood_fill", fill},
                              {"affine_2d", affine},
                              {"viewing", view},
                              {"cohen_sutherland_2d and liang_barsky", clip_line},
                              {"sutherland_hodgman and polygon_circle", clip_polygon},
                              {"bsp_tree", order_faces},
                              {"illumination", light},
                              {"polygon_shading", shade},
                              {"jittered, poisson_disc and sampling_theorem", scatter}};

}  // namespace gradus::runs
