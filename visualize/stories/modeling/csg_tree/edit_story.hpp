#pragma once
// A leaf is changed: what is computed again, what is read from what was kept, and that undoing it gives the
// state before.

#include "stories/modeling/csg_tree/drawing.hpp"

namespace gradus::csg_tree {

/// A solid moved in the plane and made so many times as large about its centre; half-spaces have no size.
inline Solid<double> edited(const Solid<double>& solid, dvec2 move, double scale) {
  const dvec3 by(move, 0);
  if (const auto* box = std::get_if<Box<double>>(&solid)) {
    const dvec3 centre = 0.5 * (box->lower + box->upper), half = 0.5 * scale * box->size();
    return Box<double>{centre + by - half, centre + by + half};
  }
  if (const auto* half = std::get_if<HalfSpace<double>>(&solid))
    return HalfSpace<double>{half->normal, half->on + by};
  if (const auto* ball = std::get_if<Ball<double>>(&solid))
    return Ball<double>{ball->centre + by, ball->radius * scale};
  const auto& c = std::get<Cylinder<double>>(solid);
  return Cylinder<double>{c.centre + by, c.radius * scale, c.axis};
}

class EditStory : public Past<steps::Started, Reused, Renewed<double>, Restored<double>, steps::Finished> {
 public:
  template <class Along>
  EditStory(const Words& words, const Subject& before, const Subject& after, Index leaf,
            std::vector<DEnds> kept, const Along& along)
      : words_(words),
        after_(after),
        leaf_(leaf),
        kept_(std::move(kept)),
        old_(before, before.tree, world_of(before, after), along),
        new_(after, after.tree, world_of(before, after), along) {}

  const RayDrawing& drawing() const { return old_; }

  Event say(const steps::Started&) const {
    return {.text = "edit.started",
            .words = {{"name", name(leaf_)}, {"what", what(leaf_)}, {"nodes", after_.tree.size()}},
            .level = Level::idea};
  }
  Event say(const Reused& k) const {
    return {.text = "kept",
            .facts = {{"again", false}},
            .words = {{"name", name(k.node)}, {"what", what(k.node)}},
            .row = {name(k.node), what(k.node), text_of(kept_[k.node]), words_.say("cached")},
            .key = name(k.node),
            .phase = words_.say("phase.change"),
            .decides = asked(k.node, false)};
  }
  Event say(const Renewed<double>& r) const {
    const bool same = r.before == r.now;
    return {.text = text_for(r.node == leaf_, same),
            .facts = {{"again", true}, {"length", length_in(r.now)}},
            .words = {{"name", name(r.node)},
                      {"what", what(r.node)},
                      {"before", text_of(r.before)},
                      {"now", text_of(r.now)}},
            .row = {name(r.node), what(r.node), text_of(r.now), words_.say("again")},
            .key = name(r.node),
            .phase = words_.say("phase.change"),
            .decides = asked(r.node, true)};
  }
  Event say(const Restored<double>& r) const {
    return {.text = "restored",
            .words = {{"name", name(r.node)}, {"ends", text_of(r.ends)}},
            .row = {name(r.node), what(r.node), text_of(r.ends), words_.say("undone")},
            .key = name(r.node),
            .phase = words_.say("phase.undo")};
  }
  Event say(const steps::Finished&) const {
    return {.text = "edit.finished",
            .words = {{"again", all<Renewed<double>>().size()}, {"nodes", after_.tree.size()}}};
  }
  /// The root, with all that was computed again and what was not.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Renewed<double>>)
      return static_cast<double>(step.node + 1);
    return 0;
  }

  View draw() const {
    View view;
    const Index root = after_.root();
    const bool undone = !all<Restored<double>>().empty(),
               asked = !all<Reused>().empty() || last<Renewed<double>>();
    const RayDrawing& shown = asked && !undone ? new_ : old_;
    const auto* renewed = now<Renewed<double>>();
    shown.add_picture(view);
    shown.section().add_region(view, "a region", Role::accepted, root);
    shown.section().add_leaves(view);
    if (asked && !undone) old_.section().add_outline(view, "a before", Role::rejected, leaf_, true);
    shown.section().add_ray(view, words_.symbol("t"));
    std::vector<DEnds> ends = kept_;
    std::vector<Role> roles(kept_.size(), Role::past);
    for (const auto& r : all<Renewed<double>>()) ends[r.node] = r.now, roles[r.node] = Role::candidate;
    for (const auto& r : all<Restored<double>>()) ends[r.node] = r.ends, roles[r.node] = Role::past;
    if (renewed) roles[renewed->node] = Role::current;
    if (const auto* restored = now<Restored<double>>()) roles[restored->node] = Role::current;
    shown.section().add_inside(view, roles[root], ends[root]);
    for (Index i = 0; i < ends.size(); ++i) {
      shown.rows().add_name(view, i, roles[i], row_name(after_.tree, i));
      shown.add_bar(view, i, roles[i], ends[i]);
    }
    shown.add_scale(view, words_.symbol("t"));
    return view;
  }

 private:
  /// Of both, so that the drawing stays where it is.
  static Extent world_of(const Subject& before, const Subject& after) {
    const Extent more = extent_of(after);
    return with(with(extent_of(before), more.lower), more.upper);
  }
  static const char* text_for(bool leaf, bool same) {
    if (leaf) return same ? "renewed.still" : "renewed.leaf";
    return same ? "renewed.same" : "renewed";
  }
  std::string name(Index i) const { return name_of(after_.tree, i); }
  std::string what(Index i) const { return what_of(words_, after_, i); }
  Decision asked(Index i, bool again) const {
    return yes_or_no(words_, "question.again", {{"name", name(i)}}, again, "again", "kept");
  }

  const Words& words_;
  const Subject& after_;
  const Index leaf_;
  const std::vector<DEnds> kept_;
  RayDrawing old_, new_;
};

}  // namespace gradus::csg_tree
