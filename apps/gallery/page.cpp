#include "page.hpp"

#include "html_text.hpp"

namespace velum_gallery {
namespace {

std::string shot_html(const Shot& shot, const Section& section) {
  const std::string file = escaped(shot.file);
  std::string html = "<figure><a href=\"" + file + "\"><img loading=\"lazy\" width=\"" +
                     std::to_string(shot_width) + "\" height=\"" + std::to_string(shot_height) + "\" src=\"" +
                     file + "\" alt=\"" + escaped(shot.caption + ", " + section.title) + "\"></a>\n" +
                     "<figcaption>" + escaped(shot.caption) + "</figcaption>\n" +
                     "<details><summary>stages</summary><ol>\n";
  for (const velum::Stage& stage : shot.stages) html += stage_html(stage);
  return html + "</ol></details></figure>\n";
}

std::string section_html(const Section& section) {
  std::string html =
      "<section id=\"" + escaped(section.id) + "\">\n<h2>" + escaped(section.title) + "</h2>\n<p>";
  if (!section.family.empty()) html += "<span class=\"family\">" + escaped(section.family) + "</span> ";
  html += escaped(section.summary) + "</p>\n";
  if (!section.parameters.empty()) {
    html += "<p class=\"fine\">Parameters: " + escaped(section.parameters) + "</p>\n";
  }
  if (!section.source.empty()) html += "<p class=\"fine\">Source: " + escaped(section.source) + "</p>\n";
  html += "<div class=\"grid\">\n";
  for (const Shot& shot : section.shots) html += shot_html(shot, section);
  return html + "</div>\n</section>\n";
}

std::string navigation_html(const std::vector<Section>& sections) {
  std::string html = "<nav>";
  for (const Section& section : sections) {
    html += "<a href=\"#" + escaped(section.id) + "\">" + escaped(section.title) + "</a> ";
  }
  return html + "</nav>\n";
}

}  // namespace

std::string page_html(const std::vector<Section>& sections) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>velum: every projection</title>\n<style>" +
      std::string(style_sheet) +
      "</style>\n</head>\n<body>\n<header><h1>velum: every projection</h1>\n"
      "<p>Each projection of the catalogue, shown on built-in shapes and on real files. Under every picture "
      "stand the stages of its viewing matrix, in the order in which they act on a column vector.</p>\n";
  html += navigation_html(sections) + "</header>\n<main>\n";
  for (const Section& section : sections) html += section_html(section);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace velum_gallery
