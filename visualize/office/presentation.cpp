#include "office/presentation.hpp"

#include <fmt/format.h>

#include "core/contract.hpp"
#include "figure/text/markup.hpp"
#include "office/parts.hpp"
#include "office/slide.hpp"

namespace gradus {
namespace {

constexpr std::string_view declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
constexpr std::string_view office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
constexpr std::string_view package = "http://schemas.openxmlformats.org/package/2006";
constexpr std::string_view presentation_type = "application/vnd.openxmlformats-officedocument.presentationml";

/// A relation of one part to another: what it is called there, what it is, and where it lies.
struct Relation {
  std::string id, type, target;
};

std::string relations(const std::vector<Relation>& all) {
  std::string xml = fmt::format("{}<Relationships xmlns=\"{}/relationships\">", declaration, package);
  for (const Relation& r : all) {
    const std::string_view family = r.type.find('/') == std::string::npos ? office : "";
    xml += fmt::format("<Relationship Id=\"{}\" Type=\"{}{}{}\" Target=\"{}\"/>", r.id, family,
                       family.empty() ? "" : "/", r.type, r.target);
  }
  return xml + "</Relationships>";
}

std::string slide_name(std::size_t i) { return fmt::format("slides/slide{}.xml", i + 1); }
std::string notes_name(std::size_t i) { return fmt::format("notesSlides/notesSlide{}.xml", i + 1); }
std::string picture_name(std::size_t slide, std::size_t i, std::string_view ending) {
  return fmt::format("media/picture{}-{}.{}", slide + 1, i + 1, ending);
}

std::string content_types(std::size_t slides) {
  std::string xml = fmt::format("{}<Types xmlns=\"{}/content-types\">", declaration, package);
  constexpr std::pair<std::string_view, std::string_view> endings[] = {
      {"rels", "application/vnd.openxmlformats-package.relationships+xml"},
      {"xml", "application/xml"},
      {"png", "image/png"},
      {"svg", "image/svg+xml"}};
  for (const auto& [ending, type] : endings) {
    xml += fmt::format("<Default Extension=\"{}\" ContentType=\"{}\"/>", ending, type);
  }
  const auto part = [&xml](std::string_view name, std::string_view type) {
    xml += fmt::format("<Override PartName=\"/{}\" ContentType=\"{}+xml\"/>", name, type);
  };
  const auto of_presentation = [](std::string_view kind) {
    return fmt::format("{}.{}", presentation_type, kind);
  };
  constexpr std::string_view theme = "application/vnd.openxmlformats-officedocument.theme";
  part("ppt/presentation.xml", of_presentation("presentation.main"));
  part("ppt/slideMasters/slideMaster1.xml", of_presentation("slideMaster"));
  part("ppt/slideLayouts/slideLayout1.xml", of_presentation("slideLayout"));
  part("ppt/notesMasters/notesMaster1.xml", of_presentation("notesMaster"));
  part("ppt/theme/theme1.xml", theme);
  part("ppt/theme/theme2.xml", theme);
  part("docProps/core.xml", "application/vnd.openxmlformats-package.core-properties");
  for (std::size_t i = 0; i < slides; ++i) {
    part("ppt/" + slide_name(i), of_presentation("slide"));
    part("ppt/" + notes_name(i), of_presentation("notesSlide"));
  }
  return xml + "</Types>";
}

std::string core_properties(const Colophon& colophon) {
  return fmt::format(
      "{}<cp:coreProperties xmlns:cp=\"{}/metadata/core-properties\" "
      "xmlns:dc=\"http://purl.org/dc/elements/1.1/\"><dc:title>{}</dc:title><dc:creator>Gradus "
      "{}</dc:creator>"
      "<dc:description>{}</dc:description></cp:coreProperties>",
      declaration, package, escaped(colophon.title), release_version, escaped(colophon.description));
}

std::string presentation_xml(std::size_t slides, const Sheet& size) {
  std::string list;
  for (std::size_t i = 0; i < slides; ++i) {
    list += fmt::format("<p:sldId id=\"{}\" r:id=\"rIdSlide{}\"/>", 256 + i, i + 1);
  }
  return fmt::format(
      "{}<p:presentation xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" xmlns:r=\"{}\" "
      "xmlns:p=\"http://schemas.openxmlformats.org/presentationml/2006/"
      "main\"><p:sldMasterIdLst><p:sldMasterId "
      "id=\"2147483648\" r:id=\"rIdMaster\"/></p:sldMasterIdLst><p:notesMasterIdLst><p:notesMasterId "
      "r:id=\"rIdNotes\"/></p:notesMasterIdLst><p:sldIdLst>{}</p:sldIdLst><p:sldSz cx=\"{}\" "
      "cy=\"{}\"/><p:notesSz "
      "cx=\"6858000\" cy=\"9144000\"/></p:presentation>",
      declaration, office, list, emu(size.width), emu(size.height));
}

std::string presentation_relations(std::size_t slides) {
  std::vector<Relation> all{{"rIdMaster", "slideMaster", "slideMasters/slideMaster1.xml"},
                            {"rIdNotes", "notesMaster", "notesMasters/notesMaster1.xml"},
                            {"rIdTheme", "theme", "theme/theme1.xml"},
                            {"rIdCard", "customXml", "../customXml/item1.xml"}};
  for (std::size_t i = 0; i < slides; ++i) {
    all.push_back({fmt::format("rIdSlide{}", i + 1), "slide", slide_name(i)});
  }
  return relations(all);
}

/// A template's {{notes}}.
std::string notes_xml(std::string_view sentence) {
  constexpr std::string_view place = "{{notes}}";
  std::string xml(office_part("notes_slide.xml"));
  return xml.replace(xml.find(place), place.size(), escaped(sentence));
}

void add_slide(std::vector<PackagePart>& parts, std::size_t i, const Slide& slide,
               std::string_view sentence) {
  std::vector<Relation> links{{"rIdLayout", "slideLayout", "../slideLayouts/slideLayout1.xml"},
                              {"rIdNotes", "notesSlide", "../" + notes_name(i)}};
  for (std::size_t k = 0; k < slide.pictures.size(); ++k) {
    links.push_back({png_relation(k), "image", "../" + picture_name(i, k, "png")});
    links.push_back({svg_relation(k), "image", "../" + picture_name(i, k, "svg")});
    parts.push_back({"ppt/" + picture_name(i, k, "png"), slide.pictures[k].png});
    parts.push_back({"ppt/" + picture_name(i, k, "svg"), slide.pictures[k].svg});
  }
  parts.push_back({"ppt/" + slide_name(i), slide.xml});
  parts.push_back({fmt::format("ppt/slides/_rels/slide{}.xml.rels", i + 1), relations(links)});
  parts.push_back({"ppt/" + notes_name(i), notes_xml(sentence)});
  parts.push_back({fmt::format("ppt/notesSlides/_rels/notesSlide{}.xml.rels", i + 1),
                   relations({{"rIdMaster", "notesMaster", "../notesMasters/notesMaster1.xml"},
                              {"rIdSlide", "slide", "../" + slide_name(i)}})});
}

}  // namespace

std::vector<PackagePart> presentation_of(std::size_t steps,
                                         const std::function<PresentedStep(std::size_t)>& step,
                                         const DrawPart& draw, const Theme& theme,
                                         const PresentationCard& card) {
  expects(steps > 0, "a presentation has at least one slide");
  const auto part = [](std::string_view name) { return std::string(office_part(name)); };
  const PresentedStep first = step(0);
  std::vector<PackagePart> parts{
      {"[Content_Types].xml", content_types(steps)},
      {"_rels/.rels",
       relations({{"rIdMain", "officeDocument", "ppt/presentation.xml"},
                  {"rIdCore", fmt::format("{}/relationships/metadata/core-properties", package),
                   "docProps/core.xml"}})},
      {"docProps/core.xml", core_properties(card.colophon)},
      {"customXml/item1.xml", std::string(declaration) + card.markup, true},
      {"ppt/presentation.xml", presentation_xml(steps, first.sheet)},
      {"ppt/_rels/presentation.xml.rels", presentation_relations(steps)},
      {"ppt/slideMasters/slideMaster1.xml", part("slide_master.xml")},
      {"ppt/slideMasters/_rels/slideMaster1.xml.rels",
       relations({{"rId1", "slideLayout", "../slideLayouts/slideLayout1.xml"},
                  {"rId2", "theme", "../theme/theme1.xml"}})},
      {"ppt/slideLayouts/slideLayout1.xml", part("slide_layout.xml")},
      {"ppt/slideLayouts/_rels/slideLayout1.xml.rels",
       relations({{"rId1", "slideMaster", "../slideMasters/slideMaster1.xml"}})},
      {"ppt/notesMasters/notesMaster1.xml", part("notes_master.xml")},
      {"ppt/notesMasters/_rels/notesMaster1.xml.rels", relations({{"rId1", "theme", "../theme/theme2.xml"}})},
      {"ppt/theme/theme1.xml", part("theme.xml")},
      {"ppt/theme/theme2.xml", part("theme.xml")}};
  for (std::size_t i = 0; i < steps; ++i) {
    const PresentedStep shown = i == 0 ? first : step(i);
    add_slide(parts, i, slide_of(shown, draw, theme), shown.sentence);
  }
  return parts;
}

}  // namespace gradus
