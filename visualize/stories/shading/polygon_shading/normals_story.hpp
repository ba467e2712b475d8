#pragma once
// How the normals of faces add up at the vertices of a mesh, drawn in space.

#include "stories/past.hpp"
#include "stories/shading/polygon_shading/subject.hpp"
#include "stories/visibility/faces_picture.hpp"

namespace gradus::polygon_shading {

inline constexpr int normals_paper_width = 36, normals_paper_height = 24;
inline constexpr Extent normals_place{{1.5, 1}, {34.5, 23}};

class NormalsStory : public Past<steps::Started, NormalAdded<double>, VertexDone<double>, steps::Finished> {
 public:
  NormalsStory(const Words& words, const Subject& mesh, const faces_subject::Reader& reader,
               std::string weighting)
      : words_(words),
        mesh_(mesh),
        reader_(reader),
        weighting_(std::move(weighting)),
        panel_(normals_place, {}) {
    Bounds bounds;
    Extent extent;
    for (const dvec3 p : mesh.places) bounds.add(p);
    length_ = 0.7 * bounds.radius();
    for (std::size_t v = 0; v < mesh.places.size(); ++v) {
      extent.add(reader.flat(mesh.places[v]));
      // Normals that look away are hidden, or may leave the place
      if (glm::dot(mesh.normals[v], reader.towards) > 0)
        extent.add(reader.flat(mesh.places[v] + length_ * mesh.normals[v]));
    }
    panel_ = Panel(normals_place, extent);
  }

  /// Of the vertices that the reader sees, the one where most faces meet.
  double tells(const VertexDone<double>& v) const {
    return glm::dot(v.normal, reader_.towards) > 0 ? static_cast<double>(added(v.vertex).size()) : 0;
  }

  dvec2 at(dvec3 p) const { return panel_.at(reader_.flat(p)); }

  Event say(const steps::Started&) const {
    return {.text = "normals.started",
            .words = {{"vertices", mesh_.places.size()}, {"weights", weights()}},
            .count = std::ssize(mesh_.rings),
            .begins = true,
            .level = Level::idea};
  }

  Event say(const NormalAdded<double>& n) const {
    return {.text = "normals.added",
            .facts = {{"weight", n.weight}},
            .words = {{"face", mesh_.named[n.face].name},
                      {"vertex", letter(n.vertex)},
                      {"normal", figure_place(n.normal)}},
            .row = {mesh_.named[n.face].name, letter(n.vertex), n.weight},
            .key = letter(n.vertex),
            .phase = "faces"};
  }

  Event say(const VertexDone<double>& v) const {
    return {.text = "normals.done",
            .facts = {{"length", glm::length(v.sum)}},
            .words = {{"vertex", letter(v.vertex)}, {"normal", figure_place(v.normal)}},
            .count = std::ssize(added(v.vertex)),
            .key = letter(v.vertex),
            .phase = "vertices"};
  }

  Event say(const steps::Finished&) const {
    return {.text = "normals.finished",
            .words = {{"weights", weights()}, {"vertices", mesh_.places.size()}},
            .ends = true};
  }

  View draw() const {
    View view;
    const auto* adding = now<NormalAdded<double>>();
    const auto* done = now<VertexDone<double>>();
    constexpr auto none = static_cast<std::size_t>(-1);
    const std::size_t vertex = adding ? adding->vertex : done ? done->vertex : none;
    SpaceDrawing drawing(reader_.look(panel_));
    for (std::size_t f = 0; f < mesh_.rings.size(); ++f) {
      const std::vector<dvec3>& ring = mesh_.named[f].points;
      const Role role = adding && adding->face == f ? Role::current : Role::input;
      const std::string id = fmt::format("b {:03}", f);
      drawing.add(SpaceFace{.id = id, .role = role, .ring = ring, .one_sided = false});
      for (std::size_t k = 0; k < ring.size(); ++k)
        drawing.add(SpaceEdge{.id = fmt::format("{} {:02}", id, k),
                              .role = Role::input,
                              .a = ring[k],
                              .b = ring[(k + 1) % ring.size()],
                              .behind = false});
    }
    add_normals(drawing, vertex);
    for (const VertexDone<double>& v : all<VertexDone<double>>()) {
      const dvec3 at = mesh_.places[v.vertex];
      const Role role = vertex == v.vertex ? Role::accepted : Role::result;
      drawing.add(SpaceEdge{.id = fmt::format("r {:03}", v.vertex),
                            .role = role,
                            .a = at,
                            .b = at + length_ * v.normal,
                            .arrow = true,
                            .behind = false});
    }
    drawing.add_to(view, "a");
    std::vector<std::vector<dvec3>> rings;
    for (const NamedFace& face : mesh_.named) rings.push_back(face.points);
    const HiddenLines lines(rings, distant_viewer(reader_.towards), length_);
    for (std::size_t v = 0; v < mesh_.places.size(); ++v) {
      const dvec3 p = mesh_.places[v] + 1e-3 * length_ * mesh_.normals[v];
      const bool hidden = lines.pieces(p, p + 1e-3 * length_ * reader_.towards).front().hidden;
      const dvec2 at = this->at(mesh_.places[v]);
      const std::string name = letter(v);
      if (vertex == v) view.add({"v vertex", Role::current, Dot{at}});
      if (!hidden || vertex == v) view.add({"w " + name, Role::input, Label{at, name}});
    }
    return view;
  }

 private:
  std::string weights() const { return words_.say("weights." + weighting_); }
  /// The normals that have been added at a vertex.
  std::vector<NormalAdded<double>> added(std::size_t vertex) const {
    std::vector<NormalAdded<double>> added = all<NormalAdded<double>>();
    std::erase_if(added, [&](const auto& n) { return n.vertex != vertex; });
    return added;
  }
  /// Of the faces that meet at the vertex, from it on, each as long as it counts.
  void add_normals(SpaceDrawing& drawing, std::size_t vertex) const {
    const std::vector<NormalAdded<double>> added = this->added(vertex);
    double largest = 0;
    for (const NormalAdded<double>& n : added) largest = std::max(largest, n.weight);
    std::size_t i = 0;
    for (const NormalAdded<double>& n : added) {
      const dvec3 at = mesh_.places[vertex];
      drawing.add(SpaceEdge{.id = fmt::format("n {:02}", i++),
                            .role = Role::candidate,
                            .a = at,
                            .b = at + 0.75 * length_ * n.weight / std::max(largest, 1e-300) * n.normal,
                            .arrow = true,
                            .behind = false});
    }
  }

  const Words& words_;
  const Subject& mesh_;
  const faces_subject::Reader& reader_;
  const std::string weighting_;
  Panel panel_;
  double length_ = 1;
};

inline void tell_vertex_normals(Narrator& narrator) {
  const Subject mesh = mesh_of(narrator.arguments());
  const faces_subject::Reader reader = faces_subject::reader_of(narrator.arguments());
  narrator.paper(normals_paper_width, normals_paper_height);
  narrator.trace().subtitle =
      narrator.words().count("normals.subtitle", std::ssize(mesh.rings), {{"vertices", mesh.places.size()}});
  narrator.columns({{"face", false}, {"vertex", false}, {"weight"}});
  narrator.legend({{Role::current, "current"},
                   {Role::candidate, "normals"},
                   {Role::accepted, "mean"},
                   {Role::result, "means"}});
  NormalsStory story(narrator.words(), mesh, reader, narrator.arguments().text("weighting"));
  narrator.handles("faces", [&](dvec3 p) { return story.at(p); });
  narrator.telling({0, 0});  // where the reader sees no vertex
  narrator.tell_whole(story, [&](const auto& watch) {
    std::vector<dvec3> normals(mesh.places.size());
    vertex_normals(std::span<const dvec3>(mesh.places), mesh.rings, weighting_of(narrator.arguments()),
                   std::span(normals), watch);
  });
  narrator.result({{"vertices", std::ssize(mesh.places)}});
}

}  // namespace gradus::polygon_shading
